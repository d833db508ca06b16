// The right column: tabs, and below them the side that is shown.
#include "app/panels/side_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "app/panels/kit/commands.h"
#include "app/panels/kit/panel_buttons.h"
#include "app/panels/kit/sides.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/step/step.h"

namespace app {

namespace {

struct Tab {
  SidePanel side = SidePanel::step;
  std::string words, mark;  // "Step", "side/step"
};
using Tabs = std::array<Tab, side_keys.size()>;

Tabs tabs_of_all() {
  Tabs tabs;
  for (std::size_t i = 0; i < tabs.size(); ++i) {
    tabs[i] = {static_cast<SidePanel>(i), std::string(side_words[i]), "side/" + std::string(side_keys[i])};
  }
  return tabs;
}

// A word over a line that is thick below the chosen one.
void draw_tab(PanelFrame& frame, const Tab& tab, ImVec2 size, float thin, ImFont* font) {
  const bool chosen = tab.side == frame.session.view->side;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = size.x;
  const float height = size.y;
  push_font(font);
  if (ImGui::InvisibleButton(tab.mark.c_str(), ImVec2(width, height)) && !chosen)
    frame.wish(ShowSide{tab.side});
  frame.mark(tab.mark);
  const bool lit = chosen || ImGui::IsItemHovered();
  text_at(ImVec2(at.x + 0.5f * width, at.y + frame.units(2.0f)), 0.5f,
          lit ? theme().text : theme().faint_text, tab.words);
  pop_font();
  // Beside the column: below it the tip would cover the first lines of what the click opens.
  if (wants_tooltip()) {
    const Box& column = frame.layout.explanation;
    const Box beside{column.x, at.y, column.width, frame.layout.window.bottom() - at.y};
    tooltip_about(frame, beside, tooltip_of(info_of(Command::side)));
  }
  if (!chosen) return;
  const float foot = std::floor(at.y + height);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, foot - 2.0f * thin), ImVec2(at.x + width, foot),
                                            style::packed(theme().accent));
}

float width_of_words(std::span<const Tab> tabs, ImFont* font) {
  float words = 0.0f;
  push_font(font);
  for (const Tab& tab : tabs) words += ImGui::CalcTextSize(tab.words.c_str()).x;
  pop_font();
  return words;
}

void draw_tab_line(PanelFrame& frame, std::span<const Tab> tabs, ImFont* font, float air) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight() + frame.units(9.0f);
  const float thin = std::max(1.0f, std::floor(frame.units(1.0f)));
  const float foot = std::floor(at.y + height);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, foot - thin),
                                            ImVec2(at.x + ImGui::GetContentRegionAvail().x, foot),
                                            style::packed(theme().outline));
  for (const Tab& tab : tabs) {
    push_font(font);
    const float width = ImGui::CalcTextSize(tab.words.c_str()).x + air;
    pop_font();
    draw_tab(frame, tab, ImVec2(width, height), thin, font);
    ImGui::SameLine(0.0f, 0.0f);
  }
  ImGui::NewLine();
}

// They share what room there is between their words; where there is too little these get smaller, and then take
// two lines.
void draw_tabs(PanelFrame& frame) {
  draw_cross(frame, Panel::side);
  const float room = ImGui::GetContentRegionAvail().x - room_for_cross(frame);
  const Tabs all = tabs_of_all();
  const std::span<const Tab> tabs(all);
  for (ImFont* const font : {frame.fonts.strong, frame.fonts.small}) {
    const float air =
        std::min((room - width_of_words(tabs, font)) / static_cast<float>(tabs.size()), frame.units(20.0f));
    if (air >= frame.units(5.0f)) return draw_tab_line(frame, tabs, font, air);
  }
  draw_tab_line(frame, tabs.first((tabs.size() + 1) / 2), frame.fonts.strong, frame.units(12.0f));
  draw_tab_line(frame, tabs.subspan((tabs.size() + 1) / 2), frame.fonts.strong, frame.units(12.0f));
}

}  // namespace

void draw_side_panel(PanelFrame& frame) {
  begin_panel("Explanation", frame.layout.explanation);
  draw_tabs(frame);
  if (frame.session.view->side != SidePanel::step) leave_variables(frame);
  side_drawings.at(static_cast<std::size_t>(frame.session.view->side))(frame);
  ImGui::End();
}

}  // namespace app
