// All that the program knows: one value. Panels read it and return wishes (action.h); only `apply` changes
// it.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/base/worker.h"
#include "app/scene/camera.h"
#include "app/session/changes.h"
#include "app/session/pins.h"
#include "app/session/preferences.h"
#include "app/session/sweep.h"
#include "app/session/travel.h"
#include "knit/import/check.h"
#include "knit/import/repair.h"
#include "knit/pattern/written_pattern.h"
#include "knit/quality/closeness.h"
#include "knit/run/timeline.h"

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
  faces,  // by label
  count_
};
inline constexpr std::size_t layer_count = static_cast<std::size_t>(Layer::count_);
std::string_view name_of(Layer layer);  // "Row edges"
std::string_view key_of(Layer layer);   // "row-edges": for scripts

enum class Unit : std::uint8_t { item, row, stage };

struct Playback {
  bool playing = false;
  int direction = 1;  // -1: backwards
  double steps_per_second = 300.0;
  double owed = 0.0;  // part of a step not yet taken
};
inline constexpr double slowest_steps_per_second = 1.0;
inline constexpr double fastest_steps_per_second = 100000.0;

struct Notice {
  enum class Kind : std::uint8_t { info, warning, error } kind = Kind::info;
  std::string text;
};

// Where the mesh came from: one of the two is set once something is open.
struct Source {
  std::string example;                  // "thesis-sphere"
  std::filesystem::path file;           // as given
  std::vector<knit::MendKind> mends{};  // carried out on what the file says, in this order
};

// A mesh that could not be opened, and what would make it fit. It is not open: what was open still is.
struct MendOffer {
  Source source;
  std::string finding;  // the sentence: what is wrong with it
  std::shared_ptr<const knit::MendPlan> plan;
};

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

// What the right column shows.
enum class SidePanel : std::uint8_t { step, report, pattern, compare, sweep };

// Which list stands below the step.
enum class RunList : std::uint8_t { rows, candidates, problems, breaks };

// By index: what scripts and session files call them.
inline constexpr std::array<std::string_view, 5> side_keys{"step", "report", "pattern", "compare", "sweep"};
inline constexpr std::array<std::string_view, 4> list_keys{"rows", "candidates", "problems", "breaks"};

enum class Picking : std::uint8_t { nothing, start, end };

// What a worker does for the session, so that a window stays responsive.
struct LongStep {
  knit::Timeline::Job job;
  Work<knit::Timeline::Outcome> work;
  double seconds = 0.0;  // since it began
};
struct Measuring {
  std::uint64_t run = 0;  // hash of the state measured
  Work<std::optional<knit::Closeness>> work;
};

// A session file, and what it says.
struct SavedAs {
  std::filesystem::path path;
  std::string text;
};
struct Rescued {
  std::filesystem::path path;
  std::string words;  // "thesis-sphere, row 14"
};

// A lesson under way (lesson.h), guessing (predict.h), an animation in the making (figures.h): each replaced
// whole when it changes; null: none.
struct LessonRun;
struct Prediction;
struct AnimationRun;
// A large file on its way to be open, and what was made ready for an action (opening.h).
struct Opening;
struct MadeMesh;
// A picture that the loop takes (figures.h).
struct FigureWish {
  std::filesystem::path path;
  int width = 0, height = 0;
  bool panels = false, transparent = false;
};

struct Session {
  // As the compiler makes them, in session.cpp: each file that makes or copies one would be slow to compile else.
  Session();
  Session(const Session& other);
  Session(Session&& other) noexcept;
  Session& operator=(const Session& other);
  Session& operator=(Session&& other) noexcept;
  ~Session();

  std::filesystem::path assets;  // the folder of examples and fonts
  Source source;
  std::shared_ptr<const knit::Mesh> original;  // as read, before welding
  std::optional<knit::Timeline> timeline;      // nothing open: none
  std::string mesh_hash;                       // hash_text of `original`; empty: not known
  std::vector<knit::Finding> findings;         // warnings about the open mesh
  std::vector<knit::MendStep> mended;          // what was done to it, as source.mends says
  std::optional<MendOffer> mend_offer;         // of the mesh that could not be opened last
  std::shared_ptr<const Session> before_mend;  // what undoing the mends goes back to; null: nothing to undo
  knit::Parameters defaults;                   // of the open mesh or example: what reset goes back to
  double load_ms = 0.0;                        // of the last opening
  double run_ms = 0.0;                         // spent on working the run out, so far
  // In a window long work is done beside it; without one it is waited for.
  bool beside = false;
  std::shared_ptr<Opening> opening;           // null: none under way
  std::shared_ptr<const MadeMesh> made_mesh;  // while the action is done that it was made ready for
  std::optional<LongStep> long_step;
  std::optional<knit::Parameters> before_change;  // what cancelling goes back to
  std::optional<Measuring> measuring_run;
  std::uint64_t closeness_run = 0;                   // hash of the state that `closeness` belongs to
  std::shared_ptr<const knit::Closeness> closeness;  // of the finished run; null: not measured
  bool measuring = false;                            // a worker is at it

  Travel travel;               // where one was, what is selected, break conditions, the loop
  Changes changes;             // of parameters, to undo and redo
  std::optional<Pin> pinned;   // the run that this one is compared with
  std::optional<Sweep> sweep;  // under way or done
  std::string place_note;      // why another place is shown than the one tuned at; else empty
  std::optional<std::string> clipboard_wanted;  // the loop hands it over after the next frame

  std::optional<Rescued> rescued;  // a session from before a crash, offered
  std::optional<SavedAs> saved;    // the session file last written or opened
  bool camera_kept = false;        // it came with a session: not framed anew once the view's shape is known

  Preferences preferences;
  std::shared_ptr<const LessonRun> lesson;
  std::shared_ptr<const Prediction> prediction;
  std::shared_ptr<const AnimationRun> animation;
  std::vector<FigureWish> figures_wanted;  // the loop takes them after the next frame
  std::string pointed_variable;            // of the pseudo-code, under the pointer; empty: none

  Camera camera;
  double aspect = 1.6;  // of the view
  std::array<bool, layer_count> layers{true, true, true, true, false, true, true, true, true, true, true};
  Playback playback;
  Picking picking = Picking::nothing;
  SidePanel side = SidePanel::step;
  RunList list = RunList::rows;
  CentrePanel centre = CentrePanel::view;
  std::optional<StitchAt> hovered_stitch;  // under the pointer, in the view or the chart: shown in both
  // By their line in the text or their place on the timeline: likewise, and in both of these.
  std::optional<RoundSpan> hovered_rounds;
  std::optional<std::int32_t> knit_along;  // the round at hand, from 1; none: not knitting along
  std::int32_t knit_along_round = 1;       // remembered when it is put away
  knit::PatternOptions pattern;            // title, yarn, needle of the written pattern
  std::vector<Notice> notices;             // newest last
  bool help_open = false;
  bool action_palette_open = false;
  bool glossary_open = false;
  std::string glossary_term;
  bool open_dialog_open = false;
  bool quit = false;
  std::vector<std::filesystem::path> pages_wanted;        // patterns with a picture; likewise
  std::vector<std::filesystem::path> screenshots_wanted;  // the loop takes them after the next frame

  [[nodiscard]] bool shows(Layer layer) const { return layers[static_cast<std::size_t>(layer)]; }
};

// The last step taken, or null at the start or with nothing open.
const knit::Step* last_step(const Session& session);
// In force for the last step taken (for the next one at the start). Requires something open.
const knit::Parameters& parameters_of_last_step(const Session& session);
// One sentence for the last step; at the very end also why the run stopped. Never empty.
std::string sentence(const Session& session);
// Whether the view shows the run's last state and why that is the last: null unless the run stopped there.
const knit::Step* stop_shown(const Session& session);
// How close the finished piece is to the mesh: measured at once, unless it is known. Requires something open.
std::shared_ptr<const knit::Closeness> closeness_now(const Session& session);

}  // namespace app
