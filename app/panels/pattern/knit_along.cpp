// Knit along: one round at a time, large, over the foot of the centre; its line, its row of the chart, and forward
// and back. The view and the chart light the same round.
#include <algorithm>
#include <string>

#include "app/panels/kit/ways.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/pattern/chart_cache.h"
#include "app/panels/pattern/pattern.h"
#include "app/panels/pattern/pattern_parts.h"
#include "app/session/view.h"

namespace app {

namespace {

void draw_turning(PanelFrame& frame, std::int32_t round, std::int32_t last) {
  const float side = frame.units(34.0f);
  const auto turn = [&](const char* id, Icon icon, std::int32_t to, const char* help) {
    if (icon_button(id, icon, ImVec2(side, side))) frame.wish(KnitAlong{std::clamp(to, 1, last)});
    frame.mark("knit-along/" + std::string(id));
    tooltip(frame, help);
    ImGui::SameLine();
  };
  turn("first", Icon::first, 1, "To the cast on.");
  turn("back", Icon::back, round - 1, "One round back.");
  turn("forward", Icon::forward, round + 1, "This round is knitted: the next one.");
  const float top = ImGui::GetCursorPosY();
  // Beside a button words stand lower by its padding anyway.
  ImGui::SetCursorPosY(top + 0.5f * (side - ImGui::GetTextLineHeight()) - ImGui::GetStyle().FramePadding.y);
  faint_text("Round " + std::to_string(round) + " of " + std::to_string(last));
  ImGui::SameLine(ImGui::GetContentRegionMax().x - side);
  ImGui::SetCursorPosY(top);
  if (icon_button("close", Icon::cross, ImVec2(side, side))) frame.wish(KnitAlong{std::nullopt});
  frame.mark("knit-along/close");
  tooltip(frame, "Stop knitting along; the round is remembered.");
}

// The round's squares in working order, from right to left as on the chart.
void draw_strip(const PanelFrame& frame, const knit::ChartRow& row) {
  const float width = ImGui::GetContentRegionAvail().x;
  const auto count = static_cast<float>(std::max<std::size_t>(1, row.squares.size()));
  const float side = std::min(frame.units(22.0f), width / count);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t column = 0; column < row.squares.size(); ++column) {
    const ImVec2 at(low.x + width - side * static_cast<float>(column + 1), low.y);
    draw_square(list, at, row.squares[column], {side, false, false});
  }
  ImGui::Dummy(ImVec2(width, side));
}

}  // namespace

std::int32_t current_round(const PanelFrame& frame) {
  if (frame.session.view->gaze.knit_along) return *frame.session.view->gaze.knit_along;
  return current_row(frame);
}

void wish_round(PanelFrame& frame, std::int32_t number) {
  wish_row(frame, number);
  if (frame.session.view->gaze.knit_along) frame.wish(KnitAlong{number});
}

void draw_knit_along(PanelFrame& frame) {
  const auto& along = frame.session.view->gaze.knit_along;
  if (!along || frame.timeline() == nullptr) return;
  ChartCache& cache = frame.own<ChartCache>();
  cache.refresh(*frame.timeline(), frame.session.view->pattern);
  const std::int32_t last = cache.rounds();
  const Box& view = frame.layout.view;
  const float margin = frame.units(14.0f);
  ImGui::SetNextWindowPos(ImVec2(view.x + margin, view.bottom() - margin), ImGuiCond_Always,
                          ImVec2(0.0f, 1.0f));
  ImGui::SetNextWindowSize(ImVec2(view.width - 2.0f * margin, 0.0f));
  push_raised_look(frame);
  ImGui::Begin("KnitAlong", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  pop_raised_look();
  if (last == 0) {
    faint_text(cache.in_pieces()
                   ? "Knitting along is for one piece only; the tab Pattern has all pieces in words."
                   : "There is nothing to knit yet: the stitches have no labels.");
  } else {
    const std::int32_t round = std::clamp(*along, 1, last);
    draw_turning(frame, round, last);
    push_font(frame.fonts.heading);
    wrapped_text(cache.line_of(round));
    pop_font();
    frame.mark("knit-along/line");
    draw_strip(frame, cache.chart().rows[static_cast<std::size_t>(round) - 1]);
  }
  ImGui::End();
}

}  // namespace app
