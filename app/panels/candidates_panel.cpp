// The candidates of the row at hand: a plot, and a table that can be sorted.
#include <algorithm>
#include <string>

#include "app/core/lesson.h"
#include "app/core/predict.h"
#include "app/panels/candidate_plot.h"
#include "app/panels/widgets.h"
#include "knit/narrate.h"

namespace app {

namespace {

using knit::CandidateVerdict;

constexpr float least_plot = 78.0f;  // plain units
constexpr float most_plot = 130.0f;
constexpr float least_table = 72.0f;

const char* words_of(knit::NoCandidates none) {
  switch (none) {
    case knit::NoCandidates::has_some:
      return "";
    case knit::NoCandidates::no_row:
      return "The vertices that a row is picked from appear with the row.";
    case knit::NoCandidates::cast_on:
      return "The cast on has no candidates: its stitches are spread evenly along their cycle.";
    case knit::NoCandidates::cut:
      return "A row from a contour has no candidates: its stitches are spread evenly along the cut.";
    case knit::NoCandidates::not_yet:
      return "The row's vertices have not been put in order yet.";
  }
  return "";
}

Colour colour_of(CandidateVerdict verdict) {
  switch (verdict) {
    case CandidateVerdict::first:
    case CandidateVerdict::accepted:
      return theme().text;
    case CandidateVerdict::taken:
      return theme().problem;
    case CandidateVerdict::too_far:
      return theme().warning;
    case CandidateVerdict::too_near:
    case CandidateVerdict::never_reached:
      break;
  }
  return theme().faint_text;
}

// The candidate that the last step measured or took.
std::optional<std::int32_t> order_at_hand(const PanelFrame& frame) {
  const knit::Step* step = last_step(frame.session);
  if (step == nullptr) return std::nullopt;
  if (const auto* measured = std::get_if<knit::CandidateMeasured>(&step->what))
    return measured->candidate_order;
  if (const auto* missed = std::get_if<knit::BandMissed>(&step->what)) return missed->taken_order;
  return std::nullopt;
}

std::optional<std::int32_t> selected_order(const PanelFrame& frame) {
  const auto& selected = frame.session.travel.selected;
  if (!selected) return std::nullopt;
  return frame.ui.candidates.order_of(*frame.timeline(), *selected);
}

void cell(const std::string& words, Colour colour, bool right) {
  ImGui::TableNextColumn();
  if (right) {
    const float spare = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(words.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, spare));
  }
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(colour));
  text(words);
  ImGui::PopStyleColor();
}

// To the step that said so; what was not reached is only selected.
void wish_why(PanelFrame& frame, const knit::Candidate& candidate) {
  const knit::VertexThing vertex{candidate.vertex};
  if (candidate.step == knit::no_step) {
    frame.wish(Select{vertex});
  } else {
    frame.wish(ShowWhy{vertex});
  }
}

void draw_line(PanelFrame& frame, const knit::Candidate& candidate, bool lit, bool selected) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string order = std::to_string(candidate.order);
  const bool reached = candidate.step != knit::no_step;
  const bool past = reached && candidate.step < frame.timeline()->position();
  Colour colour = selected ? theme().selected : colour_of(candidate.verdict);
  if (!past) colour.a = 120;  // still to come
  if (ImGui::Selectable(("##" + order).c_str(), lit, ImGuiSelectableFlags_SpanAllColumns))
    wish_why(frame, candidate);
  frame.mark("candidate/" + order);
  tooltip(frame, reached ? "Click: go to the step that says so." : "Click: show it.");
  ImGui::SameLine(0.0f, 0.0f);
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(colour));
  text(order);
  ImGui::PopStyleColor();
  cell(std::to_string(candidate.vertex), colour, true);
  cell(reached ? knit::short_number(candidate.distance) : "\xE2\x80\x93", colour, true);
  cell(std::string(knit::name_of(candidate.verdict)), colour, false);
}

void read_sorting(CandidateList& list) {
  const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  if (specs == nullptr || specs->SpecsCount == 0) return;
  const ImGuiTableColumnSortSpecs& first = specs->Specs[0];
  list.sort_by(static_cast<CandidateColumn>(first.ColumnIndex),
               first.SortDirection == ImGuiSortDirection_Descending);
}

void draw_header(PanelFrame& frame) {
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Order", ImGuiTableColumnFlags_WidthStretch, 0.21f);
  ImGui::TableSetupColumn("Vertex", ImGuiTableColumnFlags_WidthStretch, 0.24f);
  ImGui::TableSetupColumn("Distance", ImGuiTableColumnFlags_WidthStretch, 0.27f);
  ImGui::TableSetupColumn("Verdict", ImGuiTableColumnFlags_WidthStretch, 0.33f);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().faint_text));
  for (int column = 0; column < 4; ++column) {
    ImGui::TableSetColumnIndex(column);
    ImGui::TableHeader(ImGui::TableGetColumnName(column));
    frame.mark("candidates/sort/" + std::to_string(column));
    tooltip(frame, "Click: sort by this, and the other way round.");
  }
  ImGui::PopStyleColor();
}

// Keeps the candidate at hand in sight, when it has changed.
void follow(CandidateList& list, const std::optional<std::int32_t>& order) {
  if (!order || order == list.shown) return;
  list.shown = order;
  const float line = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
  const float top = line * static_cast<float>(list.line_of(*order) + 1) - 0.5f * ImGui::GetWindowHeight();
  ImGui::SetScrollY(std::max(0.0f, top));
}

void draw_table(PanelFrame& frame, const std::optional<std::int32_t>& current,
                const std::optional<std::int32_t>& selected) {
  constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                    ImGuiTableFlags_BordersOuter | ImGuiTableFlags_Sortable;
  const float height = std::max(frame.units(least_table), ImGui::GetContentRegionAvail().y);
  if (!ImGui::BeginTable("candidate table", 4, flags, ImVec2(0.0f, height))) return;
  CandidateList& list = frame.ui.candidates;
  draw_header(frame);
  read_sorting(list);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(list.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const knit::Candidate& candidate = list.at(static_cast<std::size_t>(i));
      const bool chosen = selected == candidate.order;
      draw_line(frame, candidate, chosen || current == candidate.order, chosen);
    }
  }
  follow(list, current ? current : selected);
  ImGui::EndTable();
}

}  // namespace

void draw_candidates(PanelFrame& frame) {
  CandidateList& list = frame.ui.candidates;
  if (frame.timeline() == nullptr || frame.timeline()->known() == 0)
    return wrapped_text(words_of(knit::NoCandidates::no_row), theme().faint_text);
  list.refresh(*frame.timeline(), row_at_hand(frame));
  if (list.table().none != knit::NoCandidates::has_some)
    return wrapped_text(words_of(list.table().none), theme().faint_text);
  const Question* question = open_question(frame.session);
  const bool gives_away =
      asked_vertex(frame.session) || (question != nullptr && question->hides_candidates());
  if (gives_away)
    return wrapped_text("Distances and verdicts are hidden here until you have guessed.", theme().faint_text);
  const auto current = order_at_hand(frame);
  const auto selected = selected_order(frame);
  const CandidatePlot plot{list.table(), current, selected, frame.timeline()->position()};
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 size(room.x, std::clamp(0.45f * room.y, frame.units(least_plot), frame.units(most_plot)));
  if (const auto clicked = draw_candidate_plot(frame, plot, size))
    wish_why(frame, list.table().candidates[static_cast<std::size_t>(*clicked)]);
  draw_table(frame, current, selected);
}

}  // namespace app
