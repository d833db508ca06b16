// All panels in one call, and the little that is theirs to remember.
//
// How a frame goes; the session is the same all through it, so picture, captions and panels agree:
//   glue.begin_frame(size, window.input().take_frame());
//   const Layout layout = layout_of(size.width, size.height, scale, layout_wish(session));
//   apply(session, SetAspect{layout.view_aspect()});
//   const Scene scene = describer.describe(session);
//   const Actions wishes = draw_ui(session, ui, scene, layout, fonts);
//   glue.end_frame();
//   ... draw the scene into pixels_of(layout.view, layout.window, size.pixels_per_x, size.pixels_per_y),
//   ... then ImGui's own triangles over all of the window; the view's rectangle has no background of theirs
//   for (const Action& wish : wishes) apply(session, wish);
// Wishes show in the next frame, so one is due whenever there were any. Popups, tooltips and notices find
// their size in two frames: draw three after the last event before going to sleep.
//
// Before the first frame, and whenever the scale changes: fonts = glue.load_fonts(folder, scale,
// style::text_size), style::apply(scale), ImGuiDraw::forget_fonts().
#pragma once

#include <imgui.h>

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/compare/compare_cache.h"
#include "app/panels/compare/sweep_cache.h"
#include "app/panels/dialogs/figure_dialog.h"
#include "app/panels/kit/imgui_glue.h"
#include "app/panels/kit/layout.h"
#include "app/panels/kit/words_state.h"
#include "app/panels/pattern/chart_cache.h"
#include "app/panels/pattern/pattern_lines.h"
#include "app/panels/report/card_cache.h"
#include "app/panels/step/candidate_list.h"
#include "app/panels/step/run_cache.h"
#include "app/scene/scene.h"
#include "app/session/action.h"
#include "app/session/view.h"

namespace app {

// A buffer that a text field writes into.
struct TextBuffer {
  std::array<char, 4096> bytes{};
  void set(const std::string& text);
  [[nodiscard]] std::string text() const;
};

// A drag that began in the view.
struct ViewDrag {
  enum class Kind : std::uint8_t { orbit, pan } kind = Kind::orbit;
  bool moved = false;  // far enough to be no click
};

// A click in the view counts once it can no longer become a double click.
struct PendingClick {
  std::optional<knit::Thing> thing;  // none: beside everything
  double due = 0.0;
};

struct OpenDialog {
  struct Entry {
    std::string name;
    bool folder = false;
  };
  bool shown = false;
  std::filesystem::path folder;
  std::vector<Entry> entries;
  std::string trouble;  // why the folder cannot be read, or the path not opened
  int chosen = -1;      // by the arrow keys or a click; else what is typed counts
  int field = 0;        // changes when the field is emptied from outside
  bool refocus = false;
  TextBuffer path;
};

struct SaveDialog {
  std::optional<ExportKind> wanted;  // open for this
  bool shown = false;
  TextBuffer path;
};

// A vertex number that is typed.
struct VertexField {
  TextBuffer text;
  std::string shown;    // the value that `text` was made from
  std::string trouble;  // why what was typed is refused
};

// A break condition that is typed.
struct BreakField {
  TextBuffer text;
  std::string trouble;  // why what was typed is none
};

// A drag with the right button on the track, which lays the loop.
struct LoopDrag {
  std::size_t from = 0;  // the position where it began
  float x = 0.0f;        // and on the screen
  bool moved = false;    // far enough to be no click
};

// What is typed about the pattern; follows the session's options unless they are what was typed.
struct PatternFields {
  bool open = false;
  std::optional<knit::PatternOptions> shown;  // what the buffers stand for
  TextBuffer title, yarn, colour, needle;
  std::string trouble;  // why the needle is refused
};

// The written pattern's place in its panel.
struct PatternView {
  PatternLayout layout;
  std::int32_t followed = 0;                // the round at hand that was scrolled to
  std::optional<RoundSpan> followed_meant;  // and the rounds under the pointer elsewhere
};

// How the chart is held: as fits the panel, times `zoom`, moved by `move`.
struct ChartView {
  float zoom = 1.0f;
  ImVec2 move{0.0f, 0.0f};
};

// Only what is the panels' own: nothing of the algorithm, and nothing that a script would need.
struct UiState {
  std::optional<bool> legend_open;  // as a person has folded it; none: as there is room
  Unit unit = Unit::item;           // of the step buttons
  bool from_here = false;           // a changed parameter counts from here on, not from the start
  ViewDrag drag;
  std::optional<PendingClick> click;
  CandidateList candidates;
  OpenDialog open;
  SaveDialog save;
  FigureDialog figure;
  BreakField break_field;
  std::optional<LoopDrag> loop_drag;
  std::map<std::string, VertexField, std::less<>> vertex_fields;  // by parameter key
  int row_scrolled_to = 0;
  RunCache run;
  ChartCache chart;
  ChartView chart_view;
  PatternFields pattern_fields;
  PatternView pattern_view;
  LabelTally labels;
  CardCache card;
  CompareCache compare;
  SweepForm sweep_form;
  SweepCache sweep;
  WordsState words;
  // Where controls stood in the last frame, by name ("play", "scrubber", "layer/surface"): for tests and for
  // whoever points at them.
  std::map<std::string, Box, std::less<>> controls;
};

// Of the strip below the view, plain units.
inline constexpr float lesson_height = 150.0f;

// As the preferences have it, with room for a lesson while one goes on.
LayoutWish layout_wish(const Session& session);

// Needs a frame of ImGui's. What a person wished in it, in order.
Actions draw_ui(const Session& session, UiState& ui, const Scene& scene, const Layout& layout,
                const Fonts& fonts);

}  // namespace app
