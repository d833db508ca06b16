// The report card: how good the knit mesh is, in figures and plots, live.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/base/text.h"
#include "app/files/card.h"
#include "app/panels/kit/plots.h"
#include "app/panels/kit/sides.h"
#include "app/panels/kit/term_text.h"
#include "app/panels/kit/ways.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/report/card_cache.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/shown.h"
#include "app/session/view.h"
#include "knit/model/words.h"

namespace app {

namespace {

// Where the figures' columns end and lines begin.
struct Grid {
  float left = 0.0f, right = 0.0f;
  float column = 0.0f;  // width of each
  float line = 0.0f;
  float air = 0.0f;  // of a line, below its words
  [[nodiscard]] float end_of(std::size_t i) const {
    return right - column * static_cast<float>(card_columns - 1 - i);
  }
};

Grid grid_of(const PanelFrame& frame) {
  push_font(frame.fonts.mono);
  const float figure = ImGui::CalcTextSize("0.000").x;
  pop_font();
  const float left = ImGui::GetCursorScreenPos().x;
  const float width = ImGui::GetContentRegionAvail().x;
  // Names need their room; wide panels spread the columns.
  const float least = figure + frame.units(10.0f);
  // High panels spread the lines, too; plots get the greater part of what they have more.
  const float spare = ImGui::GetContentRegionAvail().y - frame.units(530.0f);
  const float air = std::floor(std::clamp(0.025f * spare, frame.units(2.0f), frame.units(8.0f)));
  const float line = std::floor(ImGui::GetTextLineHeight()) + air;
  return {left, left + width, std::floor(std::max(least, 0.17f * width)), line, air};
}

void draw_header(PanelFrame& frame, const Grid& grid, const CardHeads& heads) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  push_font(frame.fonts.small);
  const float height = ImGui::GetTextLineHeight() + frame.units(2.0f);
  for (std::size_t i = 0; i < heads.size(); ++i) {
    const std::string head(heads.at(i));
    if (head.empty()) continue;
    text_at(ImVec2(grid.end_of(i), at.y), 1.0f, theme().faint_text, head);
    const float width = ImGui::CalcTextSize(head.c_str()).x;
    ImGui::SetCursorScreenPos(ImVec2(grid.end_of(i) - width, at.y));
    ImGui::Dummy(ImVec2(width, height));
    frame.mark("head/" + head);
    tooltip(frame, help_of_head(head));
  }
  pop_font();
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy(ImVec2(grid.right - grid.left, height));
}

void draw_rule(const PanelFrame& frame, const Grid& grid, float space) {
  // In the middle between the words above and below.
  const float y = std::floor(ImGui::GetCursorScreenPos().y + 0.5f * (space - grid.air));
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(grid.left, y),
                                            ImVec2(grid.right, y + std::max(1.0f, frame.units(1.0f))),
                                            style::packed(theme().outline));
  ImGui::Dummy(ImVec2(0.0f, space));
}

// What a click leads from.
void underline(const PanelFrame& frame, ImVec2 at, float width) {
  ImGui::GetWindowDrawList()->AddRectFilled(
      at, ImVec2(at.x + width, at.y + std::max(1.0f, frame.units(1.0f))), style::packed(theme().text));
}

void wish_way(PanelFrame& frame, const FigureWay& way) {
  if (const auto* thing = std::get_if<knit::Element>(&way)) frame.wish(LookAt{*thing});
  if (const auto* range = std::get_if<knit::SizeRange>(&way)) {
    const bool lit = frame.session.document && frame.session.document->travel.sized == *range;
    frame.wish(SelectSized{lit ? std::nullopt : std::optional(*range)});
  }
  if (const auto* row = std::get_if<FigureRow>(&way)) wish_row(frame, row->row);
}

// One that is outside stands in the warning's colour with a dot before it, which also eyes that see no such
// colour can tell.
void draw_figure(PanelFrame& frame, const CardFigure& figure, const Grid& grid, std::size_t column, float y) {
  const float middle = y + 0.5f * ImGui::GetTextLineHeight();
  const float end = grid.end_of(column);
  push_font(frame.fonts.mono);
  const ImVec2 size = ImGui::CalcTextSize(figure.text.c_str());
  // A little lower than the middle: on the line that the names stand on.
  text_at(ImVec2(end, middle - 0.5f * size.y + frame.units(0.4f)), 1.0f,
          figure.outside ? theme().warning : theme().text, figure.text);
  pop_font();
  if (figure.outside) {
    const float radius = frame.units(2.2f);
    const ImVec2 at(end - size.x - radius - frame.units(2.5f), middle + frame.units(0.4f));
    ImGui::GetWindowDrawList()->AddCircleFilled(at, radius, style::packed(theme().warning));
  }
  // No wider than its column's own part, so that it covers no words beside it.
  ImGui::SetCursorScreenPos(ImVec2(end - grid.column, y));
  const std::string_view leads = click_words(figure.way);
  if (leads.empty()) {
    ImGui::Dummy(ImVec2(grid.column, grid.line));
  } else {
    if (ImGui::InvisibleButton(figure.name.c_str(), ImVec2(grid.column, grid.line)))
      wish_way(frame, figure.way);
    if (ImGui::IsItemHovered()) underline(frame, ImVec2(end - size.x, middle + 0.5f * size.y), size.x);
  }
  frame.mark(figure.name);
  tooltip(frame, leads.empty() ? figure.help : figure.help + "\n\n" + std::string(leads));
}

void draw_missing(PanelFrame& frame, const CardLine& line, const Grid& grid, float y) {
  push_font(frame.fonts.small);
  // Where two stand on a line there is no room to say when: the tip does.
  const std::string words = "\xE2\x80\x93" + (line.single ? "" : " " + line.missing);
  const float low = y + frame.units(1.5f);
  text_at(ImVec2(grid.right, low), 1.0f, theme().faint_text, words);
  const float width = ImGui::CalcTextSize(words.c_str()).x;
  pop_font();
  ImGui::SetCursorScreenPos(ImVec2(grid.right - width, y));
  ImGui::Dummy(ImVec2(width, grid.line));
  frame.mark("missing/" + line.name);
  tooltip(frame, line.help + " " + with_capital(line.missing) + (line.missing.ends_with('.') ? "" : "."));
}

void draw_line(PanelFrame& frame, const CardLine& line, const Grid& grid) {
  const ImVec2 at(grid.left, ImGui::GetCursorScreenPos().y);
  ImGui::SetCursorScreenPos(at);
  text_at(at, 0.0f, theme().text, line.words);
  float width = ImGui::CalcTextSize(line.words.c_str()).x;
  const float unit = ImGui::CalcTextSize(line.unit.c_str()).x;
  std::size_t column = 0;  // the first that holds a figure: words may go on up to it
  while (column + 1 < card_columns && !line.figures[column]) ++column;
  const float most = grid.end_of(column) - grid.column - at.x - frame.units(1.0f);
  if (!line.unit.empty() && width + frame.units(5.0f) + unit <= most) {
    text_at(ImVec2(at.x + width + frame.units(5.0f), at.y), 0.0f, theme().faint_text, line.unit);
    width += frame.units(5.0f) + unit;
  }
  ImGui::Dummy(ImVec2(std::min(width, most), grid.line));
  frame.mark("line/" + line.name);
  explained_tooltip(frame, line.help, line.words);
  if (!line.missing.empty()) draw_missing(frame, line, grid, at.y);
  for (std::size_t i = 0; i < card_columns; ++i) {
    if (line.figures[i]) draw_figure(frame, *line.figures[i], grid, i, at.y);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + grid.line));
}

// Two by two: each figure stands beside its own words.
void draw_singles(PanelFrame& frame, const std::vector<CardLine>& lines, const Grid& grid) {
  const float between = frame.units(14.0f);
  const float half = std::floor(0.5f * (grid.right - grid.left - between));
  Grid first = grid, second = grid;
  first.right = grid.left + half;
  second.left = grid.right - half;
  first.column = second.column = std::min(grid.column, std::floor(0.3f * half));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const float y = ImGui::GetCursorScreenPos().y;
    draw_line(frame, lines[i], i % 2 == 0 ? first : second);
    const bool row_ends = i % 2 == 1 || i + 1 == lines.size();
    ImGui::SetCursorScreenPos(ImVec2(grid.left, row_ends ? y + grid.line : y));
  }
}

// Once stitches have settled or relaxed: which of their positions figures, plots, view and what is saved are of.
void draw_positions_switch(PanelFrame& frame) {
  struct Way {
    Positions positions;
    std::string_view name;
  };
  std::vector<Way> ways{{Positions::settled, has_settled(frame.session) ? "as settled" : "on the mesh"}};
  if (has_settled(frame.session)) ways.push_back({Positions::placed, "as placed"});
  if (has_relaxed(frame.session)) ways.push_back({Positions::relaxed, "in the air"});
  std::vector<std::string_view> names;
  int shown = 0;
  for (const Way& way : ways) {
    if (way.positions == positions_shown(frame.session)) shown = static_cast<int>(names.size());
    names.push_back(way.name);
  }
  ImGui::BeginGroup();
  const int clicked = segmented("positions", names, shown, ImGui::GetContentRegionAvail().x);
  ImGui::EndGroup();
  if (clicked >= 0) frame.wish(SetPositions{ways[static_cast<std::size_t>(clicked)].positions});
  frame.mark("positions");
  tooltip(frame,
          "Where stitches are shown: where they are at ease on the mesh, where rows were placed, or where "
          "they lie off "
          "the needles. Figures, plots, the view "
          "and what is saved follow; the pattern has the same words at both.");
}

void draw_figures(PanelFrame& frame, const knit::Quality* quality) {
  const Grid grid = grid_of(frame);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
  bool first = true;
  const auto& document = frame.session.document;
  const knit::Closeness* closeness = document ? document->closeness.get() : nullptr;
  const SettledFigures* both = frame.timeline() != nullptr ? frame.own<CardCache>().both() : nullptr;
  const CardFigures known{quality, closeness, both, frame.session.view->positions,
                          frame.session.jobs->run.measuring.has_value()};
  for (const CardGroup& group : card_groups(known)) {
    if (!first) draw_rule(frame, grid, frame.units(7.0f));
    first = false;
    if (group.headed) draw_header(frame, grid, group.heads);
    if (group.lines.front().single) {
      draw_singles(frame, group.lines, grid);
      continue;
    }
    for (const CardLine& line : group.lines) draw_line(frame, line, grid);
  }
  draw_rule(frame, grid, frame.units(10.0f));
  ImGui::PopStyleVar();
}

// --- tubes --------------------------------------------------------------------------------------------------

constexpr std::size_t most_tube_lines = 6;  // more are scrolled to

// A number, or what stands above numbers: at the right end of its column.
void draw_cell(const std::string& words, Colour colour) {
  ImGui::TableNextColumn();
  const float spare = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(words.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, spare));
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(colour));
  text(words);
  ImGui::PopStyleColor();
}

enum class TubeHead : std::uint8_t { tube, rounds, stitches, wale_cv, longest, course_cv };
constexpr std::array tube_heads{"Tube", "Rounds", "Stitches", "Wale CV", "Longest", "Course CV"};

std::string_view help_of(TubeHead head) {
  switch (head) {
    case TubeHead::tube:
      return "Its letter, in working order.";
    case TubeHead::rounds:
      return "How many rounds it has.";
    case TubeHead::stitches:
      return "How many stitches its rounds have together.";
    case TubeHead::wale_cv:
      return "How uneven its wales are: standard deviation over mean.";
    case TubeHead::longest:
      return "Its longest wale edge, in stitch heights h.";
    case TubeHead::course_cv:
      break;
  }
  return "How uneven the stitches of its worst round are: standard deviation over mean.";
}

bool leads_to_wale(const knit::TubeFit& tube, TubeHead head) {
  return head == TubeHead::longest && tube.longest.known();
}
bool leads_to_uneven_row(const knit::TubeFit& tube, TubeHead head) {
  return head == TubeHead::course_cv && tube.uneven_row > 0;
}

std::string_view way_of(const knit::TubeFit& tube, TubeHead head) {
  if (leads_to_wale(tube, head)) return "Click: the view turns to this edge.";
  return leads_to_uneven_row(tube, head) ? "Click: to this row." : "Click: to its first row.";
}

// Of its column.
TubeHead head_under_pointer() {
  for (std::size_t i = 0; i < tube_heads.size(); ++i) {
    const ImGuiTableColumnFlags flags = ImGui::TableGetColumnFlags(static_cast<int>(i));
    if ((flags & ImGuiTableColumnFlags_IsHovered) != 0) return static_cast<TubeHead>(i);
  }
  return TubeHead::tube;
}

void draw_tube(PanelFrame& frame, const knit::TubeFit& tube) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string name = knit::tube_name(tube.tube);
  const bool clicked = ImGui::Selectable(name.c_str(), false, ImGuiSelectableFlags_SpanAllColumns);
  frame.mark("tube/" + name);
  const TubeHead head = head_under_pointer();
  tooltip(frame,
          "Tube " + name + ". " + std::string(help_of(head)) + "\n\n" + std::string(way_of(tube, head)));
  draw_cell(std::to_string(tube.rounds), theme().text);
  draw_cell(std::to_string(tube.stitches), theme().text);
  const bool wales = tube.wales > 0;
  draw_cell(wales ? fixed_text(tube.wale_cv, 3) : "-", theme().text);
  const bool stretched = wales && tube.longest_wale > knit::stretched_above;
  draw_cell(wales ? fixed_text(tube.longest_wale, 2) : "-", stretched ? theme().warning : theme().text);
  draw_cell(fixed_text(tube.worst_course_cv_in_row, 3), theme().text);
  if (!clicked) return;
  if (leads_to_wale(tube, head))
    return frame.wish(LookAt{knit::ColumnEdgeElement{tube.longest.row, tube.longest.edge}});
  wish_row(frame, leads_to_uneven_row(tube, head) ? tube.uneven_row : tube.first_row);
}

// A line a tube, where there is more than one.
void draw_tubes(PanelFrame& frame, const knit::Quality* quality) {
  if (quality == nullptr || quality->tubes.size() < 2) return;
  push_font(frame.fonts.small);
  const float line = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
  const std::size_t lines = std::min(quality->tubes.size(), most_tube_lines) + 1;
  constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg;
  const ImVec2 size(0.0f, std::ceil(line * static_cast<float>(lines)));
  if (ImGui::BeginTable("tubes of the card", static_cast<int>(tube_heads.size()), flags, size)) {
    // As wide as their heads, so that none is cut off.
    for (const char* name : tube_heads)
      ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthStretch, ImGui::CalcTextSize(name).x);
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    for (std::size_t i = 0; i < tube_heads.size(); ++i) {
      if (i == 0) faint_text(tube_heads[0]);
      if (i > 0) draw_cell(tube_heads.at(i), theme().faint_text);
      frame.mark("head/" + std::string(tube_heads.at(i)));
      tooltip(frame, help_of(static_cast<TubeHead>(i)));
    }
    for (const knit::TubeFit& tube : quality->tubes) draw_tube(frame, tube);
    ImGui::EndTable();
  }
  pop_font();
}

// --- plots --------------------------------------------------------------------------------------------------

HistogramPlot histogram_of(const char* name, const char* title, const knit::Spread& spread) {
  HistogramPlot plot;
  plot.name = name;
  plot.title = title;
  plot.low = spread.histogram.low;
  plot.high = spread.histogram.high;
  plot.bins = spread.histogram.bins;
  if (spread.count == 0) {
    plot.bins = {};
    return plot;
  }
  plot.mean = spread.mean;
  plot.open_below = spread.low < plot.low;
  plot.open_above = spread.high > plot.high;
  return plot;
}

HistogramPlot course_plot(const knit::Quality& quality) {
  HistogramPlot plot = histogram_of("plot/course", "Course / w", quality.course);
  plot.help =
      "How long the edges along the rows are, in stitch widths w. Dashed: 1, what was asked. Yellow: the "
      "mean.";
  plot.unit = " w";
  plot.counted = "edges";
  plot.reference = 1.0;
  plot.missing = "after the cast on";
  return plot;
}

HistogramPlot wale_plot(const knit::Quality& quality) {
  HistogramPlot plot = histogram_of("plot/wale", "Wale / h", quality.wale);
  plot.help =
      "How long the edges from row to row are, in stitch heights h. Dashed: 1, what was asked. Yellow: the "
      "mean.";
  plot.unit = " h";
  plot.counted = "edges";
  plot.reference = 1.0;
  plot.missing = "after the faces";
  return plot;
}

HistogramPlot corner_plot(const knit::Quality& quality) {
  HistogramPlot plot = histogram_of("plot/corner", "Corner angles", quality.corner);
  plot.help = "The inner angles of all faces, in degrees. Dashed: 90, a square's. Yellow: the mean.";
  plot.unit = "\xC2\xB0";
  plot.axis_unit = plot.unit;
  plot.counted = "corners";
  plot.decimals = 0;
  plot.reference = 90.0;
  plot.missing = "after the faces";
  return plot;
}

// What a row plot points into.
struct RowValues {
  std::vector<double> made, ideal, pinned;
};

RowPlot row_plot(const PanelFrame& frame, const RowValues& values) {
  RowPlot plot;
  plot.name = "plot/rows";
  plot.title = "Stitches a row";
  plot.help =
      "How many stitches each row has, and its ideal: the length of its curve on the mesh over the stitch "
      "width w. Click: to the end of that row in this stage.";
  plot.value_words = "made";
  plot.ideal_words = "ideal";
  plot.values = values.made;
  plot.ideals = values.ideal;
  plot.ghosts = values.pinned;
  plot.missing = "after the cast on";
  if (frame.timeline() == nullptr) return plot;
  const auto& rows = frame.timeline()->furthest().fabric.rows();
  plot.rows = rows.size();
  for (const auto& row : rows)
    plot.highest = std::max(plot.highest, static_cast<double>(row->stitches.size()));
  const std::int32_t current = current_row(frame);
  if (current > 0) plot.current = static_cast<std::size_t>(current - 1);
  return plot;
}

// How a height is shared out to the three lines of plots.
struct Heights {
  float pair, corner, rows;
};

Heights heights_of(const PanelFrame& frame, float room) {
  const auto share = [&](float part, float least, float most) {
    return std::floor(std::clamp(part * room, frame.units(least), frame.units(most)));
  };
  return {share(0.32f, 88.0f, 190.0f), share(0.26f, 76.0f, 160.0f), share(0.42f, 108.0f, 300.0f)};
}

// The bin whose things are lit is known by its span, which is the range that a click asked for.
void draw_bars_of(PanelFrame& frame, HistogramPlot plot, knit::Measured of, ImVec2 size) {
  const auto range_of = [&](std::size_t bin) {
    const auto [from, to] = span_of_bin(plot, bin);
    return knit::SizeRange{of, from, to};
  };
  const auto& lit = frame.session.document ? frame.session.document->travel.sized : std::nullopt;
  for (std::size_t i = 0; lit && i < plot.bins.size(); ++i) {
    if (range_of(i) == *lit) plot.lit = i;
  }
  const auto clicked = draw_histogram(frame, plot, size);
  if (!clicked) return;
  frame.wish(SelectSized{clicked == plot.lit ? std::nullopt : std::optional(range_of(*clicked))});
}

void draw_plots(PanelFrame& frame, const knit::Quality& quality) {
  const float gap = frame.units(6.0f);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const Heights heights = heights_of(frame, room.y - 2.0f * gap);
  const float between = frame.units(14.0f);
  const float half = std::floor(0.5f * (room.x - between));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(between, gap));
  using knit::Measured;
  draw_bars_of(frame, course_plot(quality), Measured::course, ImVec2(half, heights.pair));
  ImGui::SameLine();
  draw_bars_of(frame, wale_plot(quality), Measured::wale, ImVec2(room.x - half - between, heights.pair));
  draw_bars_of(frame, corner_plot(quality), Measured::corner, ImVec2(room.x, heights.corner));
  RowValues values;
  for (const knit::RowFit& row : quality.rows) {
    values.made.push_back(row.stitches);
    values.ideal.push_back(row.ideal);
  }
  if (frame.session.document && frame.session.document->pinned) {
    for (const auto& row : frame.session.document->pinned->end.fabric.rows())
      values.pinned.push_back(static_cast<double>(row->stitches.size()));
  }
  const auto clicked = draw_row_plot(frame, row_plot(frame, values), ImVec2(room.x, heights.rows));
  if (clicked) wish_row(frame, quality.rows[*clicked].row);
  ImGui::PopStyleVar();
}

const knit::Quality* shown_quality(const PanelFrame& frame) {
  if (frame.timeline() == nullptr) return nullptr;
  const CardCache& cache = frame.own<CardCache>();
  const Positions shown = positions_shown(frame.session);
  if (shown == Positions::relaxed && cache.relaxed() != nullptr) return cache.relaxed();
  return shown == Positions::placed && cache.both() != nullptr ? &cache.both()->placed : cache.quality();
}

}  // namespace

template <>
void draw_side<SidePanel::report>(PanelFrame& frame) {
  if (frame.timeline() != nullptr) frame.own<CardCache>().refresh(*frame.timeline());
  const knit::Quality* quality = shown_quality(frame);
  if (has_settled(frame.session) || has_relaxed(frame.session)) draw_positions_switch(frame);
  draw_figures(frame, quality);
  draw_tubes(frame, quality);
  const knit::Quality none;
  draw_plots(frame, quality != nullptr ? *quality : none);
}

}  // namespace app
