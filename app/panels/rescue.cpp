// The offer of a session that was saved aside before a crash: a calm banner at the foot of the view.
#include <algorithm>

#include "app/panels/widgets.h"

namespace app {

void draw_rescue(PanelFrame& frame) {
  if (!frame.session.rescued) return;
  const Box& view = frame.layout.view;
  const float margin = std::min(frame.units(10.0f), 0.1f * view.width);
  const float width = std::min(frame.units(460.0f), view.width - 2.0f * margin);
  // Notices have the view's head.
  ImGui::SetNextWindowPos(ImVec2(view.x + 0.5f * view.width, view.bottom() - frame.units(40.0f)),
                          ImGuiCond_Always, ImVec2(0.5f, 1.0f));
  ImGui::SetNextWindowSize(ImVec2(width, 0.0f));
  push_raised_look(frame);
  ImGui::Begin("Rescue", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  pop_raised_look();
  wrapped_text("The last session ended without being closed:");
  push_font(frame.fonts.strong);
  wrapped_text(frame.session.rescued->words);
  pop_font();
  ImGui::Dummy(ImVec2(0.0f, frame.units(2.0f)));
  const ImVec2 size(frame.units(90.0f), 0.0f);
  if (ImGui::Button("Open it", size)) frame.wish(TakeRescued{});
  frame.mark("rescue/open");
  tooltip(frame, "Takes the place of what is open.");
  ImGui::SameLine();
  if (ImGui::Button("Forget it", size)) frame.wish(DropRescued{});
  frame.mark("rescue/forget");
  tooltip(frame, "Removes what was saved aside.");
  ImGui::End();
}

}  // namespace app
