// The list of rows: all that are worked out, those after the place shown dimmed, so that it keeps its height and its
// scroll while one steps.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/base/text.h"
#include "app/panels/kit/ways.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/step/step_parts.h"
#include "app/session/document.h"
#include "app/session/preferences.h"
#include "app/session/program.h"
#include "app/session/row_table.h"
#include "knit/insight/causes.h"
#include "knit/insight/why.h"
#include "knit/model/words.h"

namespace app {

namespace {

constexpr float shortest_list = 60.0f;  // plain units

struct ColumnHead {
  const char* name;
  const char* tip;
  float weight;  // of its width
};
constexpr std::array<ColumnHead, row_column_keys.size()> column_heads{
    ColumnHead{"Stitches", "How many stitches the row has; before it the pinned run's.", 1.5f},
    ColumnHead{"Change", "How many more or fewer stitches than the row is worked on.", 1.0f},
    ColumnHead{"Holds", "How many stitch widths fit into the length of the row.", 1.0f},
    ColumnHead{"Course", "The mean length along the row from stitch to stitch, in stitch widths.", 1.0f},
    ColumnHead{"Tube", "Which tube the row belongs to.", 0.7f}};

const Preferences& preferences_of(const PanelFrame& frame) { return frame.session.program->preferences; }

std::vector<RowColumn> columns_shown(const PanelFrame& frame) {
  std::vector<RowColumn> shown;
  for (std::size_t i = 0; i < column_heads.size(); ++i)
    if (preferences_of(frame).shows(static_cast<RowColumn>(i))) shown.push_back(static_cast<RowColumn>(i));
  return shown;
}

void right_aligned(const std::string& words, Colour colour) {
  const float spare = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(words.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, spare));
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(colour));
  text(words);
  ImGui::PopStyleColor();
}

void draw_column_menu(PanelFrame& frame) {
  if (!ImGui::BeginPopup("row columns")) return;
  keep_list(frame);
  for (std::size_t i = 0; i < column_heads.size(); ++i) {
    const auto column = static_cast<RowColumn>(i);
    const bool shown = preferences_of(frame).shows(column);
    if (ImGui::MenuItem(column_heads[i].name, nullptr, shown)) frame.wish(ShowRowColumn{column, !shown});
    frame.mark("rows/column/" + std::string(row_column_keys[i]));
    tooltip(frame, column_heads[i].tip);
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Copy as CSV", nullptr, false, frame.timeline() != nullptr)) frame.wish(CopyRows{});
  frame.mark("rows/copy-here");
  ImGui::EndPopup();
}

// A click of either button opens the choice of columns.
void draw_head(PanelFrame& frame, const char* name, const char* tip, float align) {
  ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, ImVec2(align, 0.0f));
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().faint_text));
  const bool clicked = ImGui::Selectable((std::string(name) + "##head").c_str());
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  if (clicked || ImGui::IsItemClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup("row columns");
  tooltip(frame, std::string(tip) + "\n\nClick: choose columns.");
}

void draw_row_head(PanelFrame& frame) {
  const float side = ImGui::GetTextLineHeight();
  const float left = ImGui::GetCursorPosX();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::CalcTextSize("Row").x + frame.units(6.0f);
  ImGui::PushClipRect(at, ImVec2(at.x + width, at.y + 2.0f * side), true);
  draw_head(frame, "Row",
            "Rows from the first to the last that is worked out; those still to come are dimmed.", 0.0f);
  frame.mark("rows/columns");
  ImGui::PopClipRect();
  if (frame.timeline() == nullptr) return;
  ImGui::SameLine(left + width);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.0f, 0.0f));
  if (icon_button("copy rows", Icon::copy, ImVec2(side, side))) frame.wish(CopyRows{});
  ImGui::PopStyleVar();
  frame.mark("rows/copy");
  tooltip(frame, "Copy the list with all of its columns as CSV.");
}

void draw_heads(PanelFrame& frame, const std::vector<RowColumn>& columns) {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  ImGui::TableNextColumn();
  draw_row_head(frame);
  for (const RowColumn column : columns) {
    ImGui::TableNextColumn();
    const ColumnHead& head = column_heads[static_cast<std::size_t>(column)];
    draw_head(frame, head.name, head.tip, 1.0f);
  }
  draw_column_menu(frame);
}

// What a row's cells are written from.
struct RowLine {
  std::int32_t number = 1;
  const knit::Row* row = nullptr;  // as it is at the end of what is worked out; null: not yet made
  bool later = false;              // than the place shown
  bool in_progress = false;
};

void draw_change(std::int32_t change, bool later) {
  if (change == 0) return right_aligned("0", theme().faint_text);
  // Warm and blue as the labels are, which themselves are too pale for words in the light theme.
  const std::string sign = change > 0 ? "+" : "\xE2\x88\x92";
  const Colour colour = change > 0 ? theme().warning : theme().accent;
  right_aligned(sign + std::to_string(std::abs(change)), later ? theme().faint_text : colour);
}

// The pinned run's first, as in the view's halves and in Compare.
void draw_beside(const std::optional<std::int32_t>& pinned, const std::string& now, Colour colour) {
  if (!pinned) return right_aligned(now, colour);
  const std::string before = std::to_string(*pinned) + " | ";
  const float wide = ImGui::CalcTextSize((before + now).c_str()).x;
  const float spare = ImGui::GetContentRegionAvail().x - wide;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, spare));
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().pinned));
  text(before);
  ImGui::PopStyleColor();
  ImGui::SameLine(0.0f, 0.0f);
  right_aligned(now, colour);
}

void draw_stitches(PanelFrame& frame, const RowLine& line) {
  const auto pinned = pinned_stitches(frame.session, line.number);
  if (line.in_progress) {
    const std::size_t made = stitches_so_far(frame.timeline()->state());
    return draw_beside(pinned, std::to_string(made) + " so far", theme().accent);
  }
  if (line.row == nullptr) return;
  const bool same = !pinned || *pinned == knit::size_of(*line.row);
  const Colour colour = line.later ? theme().faint_text : same ? theme().text : theme().warning;
  draw_beside(pinned, std::to_string(line.row->stitches.size()), colour);
}

void draw_cell(PanelFrame& frame, RowColumn column, const RowLine& line) {
  if (column == RowColumn::stitches) return draw_stitches(frame, line);
  if (line.row == nullptr || line.in_progress) return;
  const Colour colour = line.later ? theme().faint_text : theme().text;
  const RowFacts facts = facts_of_row(*line.row, frame.timeline()->parameters().stitch.width);
  switch (column) {
    case RowColumn::stitches:
      return;
    case RowColumn::change:
      if (facts.change) draw_change(*facts.change, line.later);
      return;
    case RowColumn::holds:
      return right_aligned(fixed_text(facts.holds, 1), colour);
    case RowColumn::course:
      return right_aligned(fixed_text(facts.course, 3), colour);
    case RowColumn::tube:
      return right_aligned(facts.tube, colour);
  }
}

// Of the cell under the pointer: to where the row begins, gets its number of stitches, or its change is counted.
void wish_why(PanelFrame& frame, std::int32_t row, std::optional<RowColumn> column) {
  const knit::Timeline& timeline = *frame.timeline();
  const auto decided = knit::count_decided_by(timeline, row);
  if (column == RowColumn::stitches && decided) return frame.wish(SeekPlace{timeline.step(*decided).place});
  if (column == RowColumn::change && row > 1) return frame.wish(SeekPlace{{knit::Stage::stitches, row, 0}});
  frame.wish(SeekPlace{{knit::stage_of_row(row), row, 0}});
}

// Why it has its stitches, unless that is to be guessed, and where a click leads.
std::string row_tip(const PanelFrame& frame, knit::RowId number) {
  const std::string why = gives_away_causes(frame.session) ? "" : knit::why_count(*frame.timeline(), number);
  return why + (why.empty() ? "" : "\n\n") +
         "Click: to the end of this row in this stage. Double click: why; to the step that begins the row, "
         "gives it its stitches, or counts its change.";
}

void draw_line(PanelFrame& frame, const RowLine& line, const std::vector<RowColumn>& columns) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string label = std::to_string(line.number);
  constexpr ImGuiSelectableFlags flags =
      ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick;
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(line.later ? theme().faint_text : theme().text));
  const bool clicked = ImGui::Selectable(label.c_str(), line.number == current_row(frame), flags);
  ImGui::PopStyleColor();
  frame.mark("row/" + label);
  if (wants_tooltip()) tooltip(frame, row_tip(frame, line.number));
  const float pointer = ImGui::GetIO().MousePos.x;
  std::optional<RowColumn> under;
  for (const RowColumn column : columns) {
    ImGui::TableNextColumn();
    if (pointer >= ImGui::GetCursorScreenPos().x - ImGui::GetStyle().CellPadding.x) under = column;
    draw_cell(frame, column, line);
  }
  if (!clicked) return;
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return wish_why(frame, line.number, under);
  wish_row(frame, line.number);
}

struct RowList {
  std::int32_t row = 0;  // the current one when the list was last drawn
};

// Scrolls only when the current row has left the list's sight: while stepping the lines stand still. Somebody who
// scrolled away stays there while stepping; a jump to another row brings it into sight.
void follow_row(PanelFrame& frame) {
  const std::int32_t row = current_row(frame);
  const std::int32_t last = std::exchange(frame.own<RowList>().row, row);
  if (row == last || row < 1) return;
  const float line = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
  const float room = ImGui::GetWindowHeight() - line;  // below the heads
  const auto line_of = [](std::int32_t number) { return static_cast<std::size_t>(number - 1); };
  const auto in_sight = [&](std::int32_t number) {
    const float top = line * static_cast<float>(line_of(number)) - ImGui::GetScrollY();
    return top >= 0.0f && top + line <= room;
  };
  const bool step = std::abs(row - last) == 1;
  if (in_sight(row) || (step && last > 0 && !in_sight(last))) return;
  scroll_to_line(line_of(row));
}

bool makes_rows(const knit::State& state) {
  return state.stage() == knit::Stage::cast_on || state.stage() == knit::Stage::rows;
}

RowLine line_of(const PanelFrame& frame, std::int32_t number) {
  const knit::State& state = frame.timeline()->state();
  RowLine line{number, frame.timeline()->furthest().fabric.find_row(number)};
  const bool made = state.fabric.has_row(number);
  line.in_progress = !made && makes_rows(state) && number == current_row(frame);
  line.later = !made && !line.in_progress;
  return line;
}

}  // namespace

ImVec2 list_size(const PanelFrame& frame) {
  return {0.0f, std::max(frame.units(shortest_list), ImGui::GetContentRegionAvail().y)};
}

void draw_rows(PanelFrame& frame) {
  constexpr ImGuiTableFlags flags =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  const std::vector<RowColumn> columns = columns_shown(frame);
  if (!ImGui::BeginTable("row table", 1 + static_cast<int>(columns.size()), flags, list_size(frame))) return;
  ImGui::TableSetupColumn("Row", ImGuiTableColumnFlags_WidthStretch, 1.0f);
  for (const RowColumn column : columns) {
    const ColumnHead& head = column_heads[static_cast<std::size_t>(column)];
    ImGui::TableSetupColumn(head.name, ImGuiTableColumnFlags_WidthStretch, head.weight);
  }
  ImGui::TableSetupScrollFreeze(0, 1);
  draw_heads(frame, columns);
  if (frame.timeline() != nullptr) {
    const std::int32_t known = frame.timeline()->furthest().fabric.row_count();
    const bool making = makes_rows(frame.timeline()->state());
    ImGuiListClipper clipper;
    clipper.Begin(std::max(known, making ? current_row(frame) : 0));
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
        draw_line(frame, line_of(frame, i + 1), columns);
    follow_row(frame);
  }
  ImGui::EndTable();
}

}  // namespace app
