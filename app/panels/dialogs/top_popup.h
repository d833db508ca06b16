// A popup at the top of the view, as the list of all actions and Go to are.
#pragma once

#include <imgui.h>

#include <algorithm>

#include "app/panels/kit/frame.h"
#include "app/panels/kit/widgets.h"

namespace app {

// ImGui::BeginPopup in the middle of the view's head, inside the window; ImGui::EndPopup is due where it gives true.
// `width`: at most, in plain units.
inline bool begin_top_popup(const PanelFrame& frame, const char* id, float width) {
  const Box& window = frame.layout.window;
  const Box& view = frame.layout.view;
  const float wide = std::min(frame.units(width), 0.96f * window.width);
  const float left = std::clamp(view.x + 0.5f * (view.width - wide), 0.02f * window.width,
                                std::max(0.02f * window.width, 0.98f * window.width - wide));
  ImGui::SetNextWindowPos(ImVec2(left, view.y + frame.units(10.0f)));
  ImGui::SetNextWindowSize(ImVec2(wide, 0.0f));
  push_raised_look(frame);
  const bool open = ImGui::BeginPopup(id, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  pop_raised_look();
  return open;
}

}  // namespace app
