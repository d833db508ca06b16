// How one looks at what is open: what stays when another mesh is opened, and in `gaze` what does not.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/scene/camera.h"
#include "app/scene/yarn_look.h"
#include "app/session/side_panels.h"
#include "knit/insight/breaks.h"
#include "knit/pattern/written_pattern.h"

namespace app {

enum class Layer : std::uint8_t {
  surface,    // the mesh that came in
  times,      // its colours
  isolines,   // level sets of the time
  criticals,  // where level sets begin, part, join and end
  wire,       // its edges
  cycle,      // the current cycle's candidates with their verdicts
  band,       // the anchor and [w - epsilon, w + epsilon]
  stitches,
  row_edges,
  column_edges,
  faces,    // by label
  stretch,  // of edges, while stitches settle
  moves,    // of stitches, likewise
  yarn,     // the loops, in place of faces, edges and stitches
  count_
};
inline constexpr std::size_t layer_count = static_cast<std::size_t>(Layer::count_);
std::string_view name_of(Layer layer);  // "Row edges"
std::string_view key_of(Layer layer);   // "row-edges": for scripts

struct Playback {
  bool playing = false;
  int direction = 1;  // -1: backwards
  double steps_per_second = 300.0;
  double owed = 0.0;  // part of a step not yet taken
  friend bool operator==(const Playback&, const Playback&) = default;
};
inline constexpr double slowest_steps_per_second = 1.0;
inline constexpr double fastest_steps_per_second = 100000.0;

// What the centre shows.
enum class CentrePanel : std::uint8_t { view, chart };

// A stitch, by its row (from 1) and its place in it (from 0).
struct StitchAt {
  std::int32_t row = 1, stitch = 0;
  friend bool operator==(const StitchAt&, const StitchAt&) = default;
};

// Whole rounds, by their numbers.
struct RoundSpan {
  std::int32_t first = 1, last = 1;
  [[nodiscard]] bool holds(std::int32_t round) const { return first <= round && round <= last; }
  friend bool operator==(const RoundSpan&, const RoundSpan&) = default;
};

// Of stitches: where they have settled (knit/settle), where they were placed, or where they come to lie in the air
// (knit/relax).
enum class Positions : std::uint8_t { settled, placed, relaxed };

// By index: what scripts and session files call them.
inline constexpr std::array<std::string_view, 3> positions_keys{"settled", "placed", "relaxed"};

// Which list stands below the step.
enum class RunList : std::uint8_t { rows, candidates, problems, breaks };

// By index: what scripts and session files call them.
inline constexpr std::array<std::string_view, 4> list_keys{"rows", "candidates", "problems", "breaks"};

enum class Picking : std::uint8_t { nothing, start, end };

// What one looks at in the open mesh: another has nothing of it.
struct Gaze {
  Camera camera;
  bool camera_kept = false;  // it came with a session: not framed anew once the view's shape is known
  Picking picking = Picking::nothing;
  // Knitting along, before a piece's first round: which of its deals, from 1; 0: none, the round itself.
  std::int16_t knit_along_deal = 0;
  std::optional<StitchAt> hovered_stitch;  // under the pointer, in the view or the chart: shown in both
  // By their line in the text or their place on the timeline: likewise, and in both of these.
  std::optional<RoundSpan> hovered_rounds;
  // Likewise of twins that the same words, or the same chart, stand for.
  std::vector<StitchAt> hovered_twin_stitches;
  std::vector<RoundSpan> hovered_twins;
  // Whose chart is shown, by its letters (pattern_pieces.h); empty: of the round at hand.
  std::string chart_piece;
  std::optional<std::int32_t> knit_along;  // the current round, from 1; none: not knitting along
  std::int32_t knit_along_round = 1;       // remembered when it is put away
  friend bool operator==(const Gaze&, const Gaze&) = default;
};

// What stands open over everything.
struct Dialogs {
  bool help_open = false;
  bool action_palette_open = false;
  bool glossary_open = false;
  bool go_to_open = false;
  std::string glossary_term;
  bool open_dialog_open = false;
  friend bool operator==(const Dialogs&, const Dialogs&) = default;
};

struct Checker;  // app/checker/checker.h

struct View {
  Gaze gaze;
  double aspect = 1.6;  // of the view
  std::array<bool, layer_count> layers{true, true, true, true, false, true, true,
                                       true, true, true, true, true,  true, false};
  Playback playback;
  bool slow_motion = false;
  bool presenting = false;                   // for a class: the view, one large sentence, a thin timeline
  bool ring = true;                          // round the pointer, while presenting
  bool both = false;                         // the pinned run left of this one, where one is pinned
  bool following = false;                    // the view turns to what happens behind the surface
  std::vector<knit::BreakCondition> breaks;  // playing stops there, in whatever run
  SidePanel side = SidePanel::step;
  RunList list = RunList::rows;
  CentrePanel centre = CentrePanel::view;
  Positions positions = Positions::settled;  // in the view, in figures and in what is saved
  knit::PatternOptions pattern;              // title, yarn, needle of the written pattern
  Dialogs dialogs;
  std::shared_ptr<const Checker> checker;  // a written pattern that is checked; null: none was begun
  bool checking = false;                   // it is shown, in place of all about the mesh
  YarnLook yarn;
  friend bool operator==(const View&, const View&) = default;

  [[nodiscard]] bool shows(Layer layer) const { return layers[static_cast<std::size_t>(layer)]; }
};

}  // namespace app
