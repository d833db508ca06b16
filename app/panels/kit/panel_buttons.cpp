#include "app/panels/kit/panel_buttons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/panels/kit/commands.h"
#include "app/panels/kit/widgets.h"
#include "app/session/program.h"

namespace app {

namespace {

constexpr float cross_side = 18.0f;
constexpr float toggle_width = 24.0f;
constexpr std::array all_panels{Panel::parameters, Panel::timeline, Panel::side};  // as they stand

std::string key_of(Panel panel) { return std::string(panel_keys[static_cast<std::size_t>(panel)]); }

std::string small_name(Panel panel) {
  switch (panel) {
    case Panel::parameters:
      return "the parameters";
    case Panel::side:
      return "the explanation";
    case Panel::timeline:
      return "the timeline";
  }
  return "";
}

// The window in small, with the panel's part of it filled while it is there.
void draw_small_window(const PanelFrame& frame, ImVec2 centre, Panel panel, Colour colour, bool open) {
  const float thin = std::max(1.0f, std::floor(frame.units(1.2f)));
  const ImVec2 low(std::floor(centre.x - frame.units(7.0f)), std::floor(centre.y - frame.units(6.0f)));
  const ImVec2 high(low.x + std::floor(frame.units(14.0f)), low.y + std::floor(frame.units(12.0f)));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImVec2 from = low;
  ImVec2 to = high;
  if (panel == Panel::parameters) to.x = low.x + frame.units(5.0f);
  if (panel == Panel::side) from.x = high.x - frame.units(5.0f);
  if (panel == Panel::timeline) from.y = high.y - frame.units(4.5f);
  if (open) {
    list.AddRectFilled(from, to, style::packed(colour), frame.units(1.5f));
  } else if (panel == Panel::timeline) {
    list.AddLine(from, ImVec2(to.x, from.y), style::packed(colour), thin);
  } else {
    const float x = panel == Panel::parameters ? to.x : from.x;
    list.AddLine(ImVec2(x, low.y), ImVec2(x, high.y), style::packed(colour), thin);
  }
  list.AddRect(low, high, style::packed(colour), frame.units(2.0f), 0, thin);
}

}  // namespace

const char* name_of(Panel panel) {
  switch (panel) {
    case Panel::parameters:
      return "Parameters";
    case Panel::side:
      return "Explanation";
    case Panel::timeline:
      return "Timeline";
  }
  return "";
}

float room_for_cross(const PanelFrame& frame) { return frame.units(cross_side + 4.0f); }

void draw_cross(PanelFrame& frame, Panel panel) {
  const ImVec2 back = ImGui::GetCursorPos();
  const float side = frame.units(cross_side);
  const float right = back.x + ImGui::GetContentRegionAvail().x;
  const float below = 0.5f * std::max(0.0f, ImGui::GetFrameHeight() - side);
  const std::string id = "close/" + key_of(panel);
  ImGui::SetCursorPos(ImVec2(right - side, back.y + below));
  if (ImGui::InvisibleButton(id.c_str(), ImVec2(side, side))) frame.wish(ShowPanel{panel, false});
  frame.mark(id);
  const bool lit = ImGui::IsItemHovered();
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (lit) list.AddRectFilled(low, high, style::packed(theme().hovered), frame.units(4.0f));
  draw_icon(list, Icon::cross, ImVec2(0.5f * (low.x + high.x), 0.5f * (low.y + high.y)), 0.56f * side,
            style::packed(lit ? theme().text : theme().faint_text));
  tooltip(frame, "Close " + small_name(panel) + ". The small windows at the right end of the menu bar open " +
                     "and close panels; " + keys_of(info_of(Command::only_view)) +
                     " does so with all of them.");
  ImGui::SetCursorPos(back);
}

float room_for_toggles(const PanelFrame& frame) {
  return frame.units(toggle_width * static_cast<float>(all_panels.size()) + 14.0f);
}

void draw_toggles(PanelFrame& frame) {
  const Box& menu = frame.layout.menu;
  const float width = frame.units(toggle_width);
  float x = menu.right() - room_for_toggles(frame) + frame.units(8.0f);
  for (const Panel panel : all_panels) {
    const bool open = frame.session.program->preferences.shows(panel);
    const std::string id = "toggle/" + key_of(panel);
    ImGui::SetCursorPos(ImVec2(x, 0.0f));
    if (ImGui::InvisibleButton(id.c_str(), ImVec2(width, menu.height))) frame.wish(ShowPanel{panel, !open});
    frame.mark(id);
    const bool lit = ImGui::IsItemHovered();
    tooltip(frame, (open ? "Close " : "Open ") + small_name(panel));
    draw_small_window(frame, ImVec2(x + 0.5f * width, 0.5f * menu.height), panel,
                      lit ? theme().text : theme().faint_text, open);
    x += width;
  }
}

}  // namespace app
