// Distance to the anchor along a row's ring, with the band: a saw whose teeth end in the band, and a stall
// where one climbs out of it.
#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <string>

#include "app/lessons/lesson.h"
#include "app/lessons/predict.h"
#include "app/panels/kit/frame.h"
#include "app/panels/kit/plots.h"
#include "app/panels/kit/ways.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/step/candidate_list.h"
#include "app/panels/step/step_parts.h"
#include "app/session/document.h"
#include "knit/insight/causes.h"
#include "knit/model/words.h"

namespace app {

struct CandidatePlot {
  const knit::CandidateTable& table;
  std::optional<std::int32_t> current;   // the current candidate, by its place in the ring
  std::optional<std::int32_t> selected;  // likewise
  std::size_t position = 0;              // what was measured from here on is drawn faintly
};

// The place in the ring that was clicked.
std::optional<std::int32_t> draw_candidate_plot(PanelFrame& frame, const CandidatePlot& plot, ImVec2 size);

namespace {

using namespace plot_parts;
using knit::CandidateVerdict;

// From places in the ring and distances to the screen.
struct RingScale {
  Box ground;
  std::size_t places;
  double high;
  [[nodiscard]] float x_of(std::int32_t order) const {
    const auto last = static_cast<float>(std::max<std::size_t>(1, places - 1));
    return ground.x + 4.0f + (ground.width - 8.0f) * static_cast<float>(order) / last;
  }
  [[nodiscard]] float y_of(double distance) const {
    const double share = std::clamp(distance / high, 0.0, 1.0);
    return ground.bottom() - ground.height * static_cast<float>(share);
  }
  [[nodiscard]] std::int32_t order_at(float x) const {
    const auto last = static_cast<float>(places - 1);
    const float order = (x - ground.x - 4.0f) / std::max(1.0f, ground.width - 8.0f) * last;
    return static_cast<std::int32_t>(std::floor(std::clamp(order, 0.0f, last) + 0.5f));
  }
};

RingScale scale_of(const knit::CandidateTable& table, const Box& ground) {
  double high = 1.3 * table.band.high;
  for (const knit::Candidate& candidate : table.candidates) high = std::max(high, 1.08 * candidate.distance);
  return {ground, table.candidates.size(), high > 0.0 ? high : 1.0};
}

struct Dot {
  Colour colour;
  float radius;
};
Dot dot_of(CandidateVerdict verdict) {
  switch (verdict) {
    case CandidateVerdict::first:
    case CandidateVerdict::accepted:
      return {theme().accepted, 2.8f};
    case CandidateVerdict::taken:
      return {theme().problem, 3.2f};
    case CandidateVerdict::too_far:
      return {theme().too_far, 2.2f};
    case CandidateVerdict::too_near:
    case CandidateVerdict::never_reached:
      break;
  }
  return {theme().too_near, 1.6f};
}

const knit::Candidate& at(const CandidatePlot& plot, std::int32_t order) {
  return plot.table.candidates[static_cast<std::size_t>(order)];
}

void draw_band_and_width(const PanelFrame& frame, const CandidatePlot& plot, const Stand& stand,
                         const RingScale& scale) {
  const float low = whole(scale.y_of(plot.table.band.low));
  const float high = whole(scale.y_of(plot.table.band.high));
  fill(stand, stand.ground.x, high, stand.ground.right(), std::max(low, high + stand.line),
       style::packed(theme().anchor, 46));
  const float width = whole(scale.y_of(plot.table.stitch_width));
  fill(stand, stand.ground.x, width, stand.ground.right(), width + stand.line,
       style::packed(theme().anchor, 150));
  push_font(frame.fonts.small);
  const float half = 0.5f * ImGui::GetTextLineHeight();
  const float right = stand.ground.x - frame.units(5.0f);
  text_at(ImVec2(right, width - half), 1.0f, theme().anchor, knit::short_number(plot.table.stitch_width));
  if (width + 3.0f * half < stand.ground.bottom())
    text_at(ImVec2(right, stand.ground.bottom() - 1.6f * half), 1.0f, theme().faint_text, "0");
  pop_font();
}

// Teeth: what one anchor measured, joined.
void draw_saw(const PanelFrame& frame, const CandidatePlot& plot, const Stand& stand,
              const RingScale& scale) {
  const float thick = std::max(1.0f, frame.units(1.0f));
  const auto& candidates = plot.table.candidates;
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    const knit::Candidate& to = candidates[i];
    if (to.step == knit::no_step) continue;
    const bool from_anchor = to.anchor_order == static_cast<std::int32_t>(i) - 1;
    const double before = from_anchor ? 0.0 : candidates[i - 1].distance;
    if (!from_anchor && candidates[i - 1].anchor_order != to.anchor_order) continue;
    const bool past = to.step < plot.position;
    stand.list.AddLine(ImVec2(scale.x_of(to.order - 1), scale.y_of(before)),
                       ImVec2(scale.x_of(to.order), scale.y_of(to.distance)),
                       style::packed(bar(), past ? 170 : 70), thick);
  }
}

void draw_dots(const PanelFrame& frame, const CandidatePlot& plot, const Stand& stand,
               const RingScale& scale) {
  const float room = stand.ground.width / static_cast<float>(std::max<std::size_t>(1, scale.places));
  const float shrink = std::clamp(room / frame.units(4.0f), 0.45f, 1.0f);
  for (const knit::Candidate& candidate : plot.table.candidates) {
    if (candidate.step == knit::no_step) continue;
    const Dot dot = dot_of(candidate.verdict);
    const bool past = candidate.step < plot.position;
    stand.list.AddCircleFilled(ImVec2(scale.x_of(candidate.order), scale.y_of(candidate.distance)),
                               frame.units(dot.radius) * shrink, style::packed(dot.colour, past ? 255 : 90),
                               8);
  }
}

void pick_out(const PanelFrame& frame, const CandidatePlot& plot, const Stand& stand, const RingScale& scale,
              std::int32_t order, Colour colour) {
  const float x = whole(scale.x_of(order));
  fill(stand, x, stand.ground.y, x + stand.line, stand.ground.bottom(), style::packed(colour, 120));
  if (at(plot, order).step == knit::no_step) return;
  const ImVec2 middle(scale.x_of(order), scale.y_of(at(plot, order).distance));
  stand.list.AddCircle(middle, frame.units(4.5f), style::packed(colour), 16, frame.units(1.5f));
}

std::string words_of(const knit::Candidate& candidate) {
  std::string words =
      "Vertex " + std::to_string(candidate.vertex) + ", place " + std::to_string(candidate.order + 1) + ": ";
  if (candidate.step == knit::no_step) return words + "never reached so far.";
  if (candidate.verdict == CandidateVerdict::first) return words + "the row begins here.\nClick: go there.";
  return words + knit::short_number(candidate.distance) + " from stitch " + std::to_string(candidate.stitch) +
         ", " + std::string(knit::name_of(candidate.verdict)) + ".\nClick: go to the step that says so.";
}

void draw_ring_axis(const PanelFrame& frame, const CandidatePlot& plot, const Stand& stand,
                    const RingScale& scale) {
  std::vector<AxisWord> words;
  if (plot.current)
    words.push_back({scale.x_of(*plot.current), 0.5f, std::to_string(*plot.current + 1), theme().text});
  words.push_back({stand.ground.x, 0.0f, "place 1"});
  words.push_back({stand.ground.right(), 1.0f, std::to_string(scale.places)});
  draw_axis_words(frame, stand, words);
}

}  // namespace

std::optional<std::int32_t> draw_candidate_plot(PanelFrame& frame, const CandidatePlot& plot, ImVec2 size) {
  push_font(frame.fonts.small);
  const float gutter =
      ImGui::CalcTextSize(knit::short_number(plot.table.stitch_width).c_str()).x + frame.units(7.0f);
  pop_font();
  const std::string title = "Distance to the anchor";
  const Stand stand = begin_stand(frame, "plot/candidates", title, size, gutter);
  const RingScale scale = scale_of(plot.table, stand.ground);
  std::optional<std::int32_t> pointed;
  if (stand.inside) pointed = scale.order_at(ImGui::GetIO().MousePos.x);
  draw_band_and_width(frame, plot, stand, scale);
  draw_saw(frame, plot, stand, scale);
  draw_dots(frame, plot, stand, scale);
  if (plot.current) pick_out(frame, plot, stand, scale, *plot.current, theme().text);
  if (plot.selected) pick_out(frame, plot, stand, scale, *plot.selected, theme().selected);
  if (pointed) pick_out(frame, plot, stand, scale, *pointed, theme().faint_text);
  draw_foot(stand);
  draw_ring_axis(frame, plot, stand, scale);
  draw_key(frame, stand, title, stand.ground.right(), {"band", theme().anchor, true});
  if (stand.hovered && pointed) tooltip(frame, words_of(at(plot, *pointed)));
  if (stand.hovered && !stand.inside) {
    tooltip(frame,
            "How far each vertex of the cycle lies from the anchor it was measured against. The teeth "
            "end in the band; one that climbs out of it is a stall.");
  }
  return stand.clicked ? pointed : std::nullopt;
}

// The candidates of the current row: a plot, and a table that can be sorted.

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
std::optional<std::int32_t> current_order(const PanelFrame& frame) {
  const knit::Step* step = last_step(frame.session);
  if (step == nullptr) return std::nullopt;
  if (const auto* measured = knit::get_if<knit::CandidateMeasured>(*step)) return measured->candidate_order;
  if (const auto* missed = knit::get_if<knit::BandMissed>(*step)) return missed->taken_order;
  return std::nullopt;
}

std::optional<std::int32_t> selected_order(const PanelFrame& frame) {
  const auto& selected = frame.session.document->travel.selected;
  if (!selected) return std::nullopt;
  return frame.own<CandidateList>().order_of(*frame.timeline(), *selected);
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
  const knit::VertexElement vertex{candidate.vertex};
  if (candidate.step == knit::no_step) {
    frame.wish(Select{vertex});
  } else {
    frame.wish(ShowWhy{vertex});
  }
}

// Of one that became a stitch also what was refused just before it.
std::string tip_of(const PanelFrame& frame, const knit::Candidate& candidate) {
  if (candidate.step == knit::no_step) return "Click: show it.";
  const bool taken =
      candidate.verdict == CandidateVerdict::accepted || candidate.verdict == CandidateVerdict::taken;
  const std::int32_t row = frame.own<CandidateList>().table().row;
  // From 0, the stitch after the anchor is the anchor's number.
  const std::string refused =
      taken ? knit::why_refused_before(*frame.timeline(), {row, candidate.stitch}) : "";
  const std::string head =
      taken ? "Stitch " + std::to_string(candidate.stitch + 1) + " of row " + std::to_string(row) + ".\n"
            : "";
  return head + refused + (refused.empty() ? "" : "\n\n") + "Click: go to the step that says so.";
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
  if (ImGui::IsItemHovered()) tooltip(frame, tip_of(frame, candidate));
  ImGui::SameLine(0.0f, 0.0f);
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(colour));
  text(std::to_string(candidate.order + 1));
  ImGui::PopStyleColor();
  cell(std::to_string(candidate.vertex), colour, true);
  cell(reached ? knit::short_number(candidate.distance) : "\xE2\x80\x93", colour, true);
  cell(std::string(knit::name_of(candidate.verdict)), colour, false);
  const std::int32_t stitch = frame.own<CandidateList>().stitch_of(candidate.order);
  cell(stitch > 0 ? std::to_string(stitch) : "", colour, true);
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
  ImGui::TableSetupColumn("Order", ImGuiTableColumnFlags_WidthStretch, 0.20f);
  ImGui::TableSetupColumn("Vertex", ImGuiTableColumnFlags_WidthStretch, 0.22f);
  ImGui::TableSetupColumn("Distance", ImGuiTableColumnFlags_WidthStretch, 0.30f);
  ImGui::TableSetupColumn("Verdict", ImGuiTableColumnFlags_WidthStretch, 0.28f);
  ImGui::TableSetupColumn("Stitch", ImGuiTableColumnFlags_WidthStretch, 0.20f);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().faint_text));
  push_font(frame.fonts.small);  // with the mark of the order a word must fit in a narrow panel
  for (int column = 0; column < 5; ++column) {
    ImGui::TableSetColumnIndex(column);
    const char* name = ImGui::TableGetColumnName(column);
    if (column == 1 || column == 2 || column == 4) {  // numbers end at the right
      const float arrow = ImGui::GetFontSize() + ImGui::GetStyle().FramePadding.x;
      const float spare = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(name).x - arrow;
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, spare));
    }
    ImGui::TableHeader(name);
    frame.mark("candidates/sort/" + std::to_string(column));
    tooltip(frame, "Click: sort by this, and the other way round.");
  }
  pop_font();
  ImGui::PopStyleColor();
}

// Keeps the current candidate in sight, when it has changed.
void follow(CandidateList& list, const std::optional<std::int32_t>& order) {
  if (!order || order == list.shown) return;
  list.shown = order;
  scroll_to_line(list.line_of(*order));
}

void draw_table(PanelFrame& frame, const std::optional<std::int32_t>& current,
                const std::optional<std::int32_t>& selected) {
  constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                    ImGuiTableFlags_BordersOuter | ImGuiTableFlags_Sortable;
  const float height = std::max(frame.units(least_table), ImGui::GetContentRegionAvail().y);
  if (!ImGui::BeginTable("candidate table", 5, flags, ImVec2(0.0f, height))) return;
  CandidateList& list = frame.own<CandidateList>();
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
  CandidateList& list = frame.own<CandidateList>();
  if (frame.timeline() == nullptr || frame.timeline()->known() == 0)
    return wrapped_text(words_of(knit::NoCandidates::no_row), theme().faint_text);
  list.refresh(*frame.timeline(), current_row(frame));
  if (list.table().none != knit::NoCandidates::has_some)
    return wrapped_text(words_of(list.table().none), theme().faint_text);
  const Question* question = open_question(frame.session);
  const bool gives_away =
      asked_vertex(frame.session) || (question != nullptr && question->hides_candidates());
  if (gives_away)
    return wrapped_text("Distances and verdicts are hidden here until you have guessed.", theme().faint_text);
  const auto current = current_order(frame);
  const auto selected = selected_order(frame);
  const CandidatePlot plot{list.table(), current, selected, frame.timeline()->position()};
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 size(room.x, std::clamp(0.45f * room.y, frame.units(least_plot), frame.units(most_plot)));
  if (const auto clicked = draw_candidate_plot(frame, plot, size))
    wish_why(frame, list.table().candidates[static_cast<std::size_t>(*clicked)]);
  draw_table(frame, current, selected);
}

}  // namespace app
