// A side of the right column: the pinned run beside the current one.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "app/panels/compare/compare_cache.h"
#include "app/panels/kit/plots.h"
#include "app/panels/kit/run_cache.h"
#include "app/panels/kit/sides.h"
#include "app/panels/kit/stop_ways.h"
#include "app/panels/kit/ways.h"
#include "app/panels/kit/widgets.h"
#include "app/session/document.h"

namespace app {

namespace {

constexpr RunNames pinned_and_now{"the pinned run", "this run"};

Colour pinned_colour() { return theme().pinned; }

void draw_nothing_pinned(PanelFrame& frame) {
  wrapped_text(
      "Pin the current run, then turn any knob: the pinned run stays as a pale ghost in the view and as a "
      "dashed line in the plots, and here is what differs.",
      theme().faint_text);
  ImGui::Dummy(ImVec2(0.0f, frame.units(2.0f)));
  if (ImGui::Button("Pin this run", ImVec2(frame.units(130.0f), 0.0f))) frame.wish(PinRun{});
  frame.mark("compare/pin");
  tooltip(frame, "Key: P. The same key lets it go.");
}

void draw_buttons(PanelFrame& frame) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = std::floor((ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f);
  const auto button = [&](const char* words, const char* mark, const char* help, const Action& wish) {
    if (ImGui::Button(words, ImVec2(width, 0.0f))) frame.wish(wish);
    frame.mark(mark);
    tooltip(frame, help);
  };
  button("Swap", "compare/swap",
         "The pinned settings become the current ones, and the other way round. Key: X.", SwapPinned{});
  ImGui::SameLine();
  button("Pin again", "compare/pin", "Pin the current run instead.", PinRun{});
  ImGui::SameLine();
  button("Unpin", "compare/unpin", "Let the pinned run go. Key: P.", Unpin{});
}

// Name, pinned, now, difference; the last three end where their columns end.
class Table {
 public:
  explicit Table(const PanelFrame& frame)
      : left_(ImGui::GetCursorScreenPos().x), width_(ImGui::GetContentRegionAvail().x) {
    line_ = std::floor(ImGui::GetTextLineHeight() + frame.units(1.0f));
  }
  [[nodiscard]] float end_of(std::size_t i) const {
    constexpr std::array shares{0.58f, 0.79f, 1.0f};
    return left_ + std::floor(shares.at(i) * width_);
  }
  [[nodiscard]] float left() const { return left_; }
  [[nodiscard]] float width() const { return width_; }
  [[nodiscard]] float line() const { return line_; }
  void end_line() const { ImGui::Dummy(ImVec2(width_, line_)); }

 private:
  float left_, width_, line_;
};

void draw_head(const PanelFrame& frame, const Table& table, std::size_t columns) {
  constexpr std::array names{"pinned", "now", "difference"};
  push_font(frame.fonts.small);
  const float y = ImGui::GetCursorScreenPos().y;
  for (std::size_t i = 0; i < columns; ++i)
    text_at(ImVec2(table.end_of(i + 3 - columns), y), 1.0f, theme().faint_text, names.at(i));
  ImGui::Dummy(ImVec2(table.width(), ImGui::GetTextLineHeight() + frame.units(1.0f)));
  pop_font();
}

void draw_parameters_that_differ(PanelFrame& frame, const RunDifference& difference) {
  if (difference.parameters.empty()) {
    faint_text(difference.edits_differ ? "the same at the start; the changes on the way differ"
                                       : "all the same");
    return;
  }
  const Table table(frame);
  draw_head(frame, table, 2);
  for (const ParameterLine& line : difference.parameters) {
    const float y = ImGui::GetCursorScreenPos().y;
    const float room = table.end_of(2) - table.end_of(1) - frame.units(8.0f);
    text_at(ImVec2(table.left(), y), 0.0f, theme().text,
            cut_to_width(line.label, table.end_of(0) - table.left()));
    text_at(ImVec2(table.end_of(1), y), 1.0f, pinned_colour(), cut_to_width(line.a, room));
    text_at(ImVec2(table.end_of(2), y), 1.0f, theme().text, cut_to_width(line.b, room));
    table.end_line();
    frame.mark("compare/setting/" + line.key);
    tooltip(frame, line.label + ": " + line.a + " pinned, " + line.b + " now.");
  }
  if (difference.edits_differ) faint_text("The changes on the way differ, too.");
}

struct FigureHelp {
  std::string_view key, help;
};
// By the figures' keys; those of kinds of problems are the keys of knit/insight/problem_counts.h.
constexpr std::array<FigureHelp, 23> figure_help{
    {{"rows", "How many rows are knitted, the cast on too."},
     {"stitches", "Stitches of all rows together."},
     {"increases", "Stitches that the pattern adds, m1l and m1r together."},
     {"decreases", "Stitches that the pattern takes away, k2tog and ssk together."},
     {"most", "Most increases or decreases in one row."},
     {"problems", "Steps that went wrong, and the stop."},
     {"left-out", "Limbs and holes smaller than a round, which no row is on."},
     {"resampled", "Rows whose stitches were distributed again, since they more than doubled or halved."},
     {"gaps-open", "Rows whose last stitch stays outside the band from the first."},
     {"stalls", "Stitches for which nothing was in the band."},
     {"clamped", "Vertices beyond the picked start or end, which get its time."},
     {"no-short-row", "Pairs of short rows that could not be had."},
     {"course-mean", "Mean length of an edge along a row, in stitch widths w; 1 is right."},
     {"course-cv", "How uneven stitches are along their rows: spread over mean, 0 is even."},
     {"wale-mean", "Mean length of an edge up a wale, in stitch heights h; 1 is right."},
     {"wale-cv", "How uneven stitches are up their wales: spread over mean, 0 is even."},
     {"tubes", "Pieces between splits, joins and ends."},
     {"splits", "Where one tube goes on as two."},
     {"joins", "Where two tubes go on as one."},
     {"genus", "How many handles the tubes close."},
     {"yarns", "How many yarns are worked with, one after the other."},
     {"holders", "The most loops of tubes that wait at the same time."},
     {"uncovered", "Share of the mesh's surface that no row is on."}}};

std::string tip_of(const FigureLine& line) {
  const auto* const found = std::find_if(figure_help.begin(), figure_help.end(),
                                         [&](const FigureHelp& help) { return help.key == line.key; });
  const std::string numbers = line.a + " pinned, " + line.b + " now.";
  return found == figure_help.end() ? numbers : std::string(found->help) + "\n" + numbers;
}

void draw_figures_that_differ(PanelFrame& frame, const RunDifference& difference) {
  const Table table(frame);
  draw_head(frame, table, 3);
  for (const FigureLine& line : difference.figures) {
    // Says more of the program than of the piece.
    if (line.key == "steps") continue;
    const float y = ImGui::GetCursorScreenPos().y;
    const bool same = !line.differs();
    text_at(ImVec2(table.left(), y), 0.0f, theme().text, line.name);
    push_font(frame.fonts.mono);
    text_at(ImVec2(table.end_of(0), y), 1.0f, same ? theme().faint_text : pinned_colour(), line.a);
    text_at(ImVec2(table.end_of(1), y), 1.0f, same ? theme().faint_text : theme().text, line.b);
    text_at(ImVec2(table.end_of(2), y), 1.0f, same ? theme().faint_text : theme().text,
            line.difference.empty() ? "=" : line.difference);
    pop_font();
    table.end_line();
    frame.mark("compare/figure/" + line.key);
    tooltip(frame, tip_of(line));
  }
}

void draw_first_row(PanelFrame& frame, const RunDifference& difference) {
  const std::string words =
      difference.any() ? rows_words(difference, pinned_and_now) : "The two runs are the same so far.";
  wrapped_text(words);
  frame.mark("compare/first-row");
  if (difference.first_row) {
    if (ImGui::IsItemClicked()) wish_row(frame, difference.first_row->row);
    tooltip(frame, "The pinned run's number stands first. Click: go to this row.");
  }
  if (!difference.stop_a.empty()) wrapped_text("Pinned, it stopped: " + difference.stop_a, theme().problem);
  if (!difference.stop_b.empty()) wrapped_text("Now it stops: " + difference.stop_b, theme().problem);
  if (!difference.stop_b.empty()) draw_stop_ways(frame, "compare/");
}

// "D / C": the name now, then the pinned one where it is another.
std::string tube_line_name(const TubeLine& line) {
  if (line.name_a.empty() || line.name_b.empty() || line.name_a == line.name_b)
    return "Tube " + (line.name_b.empty() ? line.name_a : line.name_b);
  return "Tube " + line.name_b + " (" + line.name_a + ")";
}

std::string change_text(std::int64_t a, std::int64_t b) {
  if (a == b) return "=";
  return b > a ? "+" + std::to_string(b - a) : "\xE2\x88\x92" + std::to_string(a - b);
}

// Rounds / stitches of the tubes that differ.
void draw_tubes_that_differ(PanelFrame& frame, const RunDifference& difference) {
  if (difference.tubes.empty()) return;
  heading(frame, "Tubes: rounds / stitches");
  const Table table(frame);
  const auto alike = [](const TubeLine& line) { return !line.differs(); };
  if (std::all_of(difference.tubes.begin(), difference.tubes.end(), alike)) return faint_text("all the same");
  draw_head(frame, table, 3);
  const auto sizes = [](const std::string& name, std::int32_t rounds, std::int64_t stitches) {
    return name.empty() ? std::string("\xE2\x80\x93")
                        : std::to_string(rounds) + "/" + std::to_string(stitches);
  };
  for (const TubeLine& line : difference.tubes) {
    if (!line.differs()) continue;
    const float y = ImGui::GetCursorScreenPos().y;
    text_at(ImVec2(table.left(), y), 0.0f, theme().text, tube_line_name(line));
    push_font(frame.fonts.mono);
    text_at(ImVec2(table.end_of(0), y), 1.0f, pinned_colour(),
            sizes(line.name_a, line.rounds_a, line.stitches_a));
    text_at(ImVec2(table.end_of(1), y), 1.0f, theme().text,
            sizes(line.name_b, line.rounds_b, line.stitches_b));
    if (!line.name_a.empty() && !line.name_b.empty())
      text_at(
          ImVec2(table.end_of(2), y), 1.0f, theme().text,
          change_text(line.rounds_a, line.rounds_b) + "/" + change_text(line.stitches_a, line.stitches_b));
    pop_font();
    table.end_line();
    frame.mark("compare/tube/" + (line.name_b.empty() ? line.name_a : line.name_b));
    tooltip(frame, words_of(line, pinned_and_now));
  }
}

RowPlot plot_of(const PanelFrame& frame, const std::vector<double>& values,
                const std::vector<double>& pinned) {
  RowPlot plot;
  plot.value_words = "now";
  plot.values = values;
  plot.ghosts = pinned;
  plot.missing = "after the cast on";
  const std::int32_t current = current_row(frame);
  if (current > 0) plot.current = static_cast<std::size_t>(current - 1);
  return plot;
}

void draw_plots(PanelFrame& frame) {
  const RowFigures& now = frame.own<CompareCache>().rows();
  const RowFigures& pinned = frame.own<CompareCache>().pinned_rows();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float gap = ImGui::GetStyle().ItemSpacing.y;
  const float height =
      std::floor(std::clamp(0.5f * (room.y - 2.0f * gap), frame.units(80.0f), frame.units(220.0f)));
  RowPlot stitches = plot_of(frame, now.stitches, pinned.stitches);
  stitches.name = "compare/stitches";
  stitches.title = "Stitches a row";
  stitches.help = "How many stitches each row has, now and pinned. Click: to the end of that row.";
  RowPlot course = plot_of(frame, now.course, pinned.course);
  course.name = "compare/course";
  course.title = "Course length / w";
  course.help =
      "The mean length of a stitch along each row, in stitch widths w, now and pinned; 1 is right. Click: to "
      "the end of that row.";
  course.decimals = 2;
  const std::vector<double> ones(now.course.size(), 1.0);
  course.ideals = ones;
  course.ideal_words = "asked";
  for (const RowPlot& plot : {stitches, course}) {
    if (const auto clicked = draw_row_plot(frame, plot, ImVec2(room.x, height)))
      wish_row(frame, static_cast<std::int32_t>(*clicked) + 1);
  }
}

}  // namespace

template <>
void draw_side<SidePanel::compare>(PanelFrame& frame) {
  if (frame.timeline() == nullptr) return faint_text("Open a mesh first.");
  if (!frame.session.document->pinned) return draw_nothing_pinned(frame);
  frame.own<CompareCache>().refresh(frame.session, frame.own<RunCache>().problem_counts(*frame.timeline()));
  draw_buttons(frame);
  const RunDifference* difference = frame.own<CompareCache>().difference();
  if (difference == nullptr) return faint_text("The pinned run is being worked out...");
  if (!difference->same_mesh)
    wrapped_text(
        "The pinned run is of another mesh: " + frame.session.document->pinned->input->mesh.name + ".",
        theme().warning);
  draw_first_row(frame, *difference);
  // As close as in the report card, so that the plots have room.
  const float across = ImGui::GetStyle().ItemSpacing.x;
  heading(frame, "Settings");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(across, 0.0f));
  draw_parameters_that_differ(frame, *difference);
  ImGui::PopStyleVar();
  ImGui::Dummy(ImVec2(0.0f, 0.0f));
  heading(frame, "Figures");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(across, 0.0f));
  draw_figures_that_differ(frame, *difference);
  ImGui::PopStyleVar();
  ImGui::Dummy(ImVec2(0.0f, 0.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(across, 0.0f));
  draw_tubes_that_differ(frame, *difference);
  ImGui::PopStyleVar();
  draw_plots(frame);
}

}  // namespace app
