#include "app/panels/kit/lesson_marks.h"

#include <algorithm>

#include "app/lessons/lesson.h"
#include "app/panels/kit/style.h"
#include "app/session/learning.h"
#include "app/session/view.h"

namespace app {

namespace {

const LessonPage* page_shown(const PanelFrame& frame) {
  return frame.session.learning->lesson ? frame.session.learning->lesson->shown() : nullptr;
}

// Fades outwards.
void draw_glow(const PanelFrame& frame, const Box& box) {
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  struct Ring {
    float out, thick;
    std::uint8_t alpha;
  };
  for (const Ring& ring : {Ring{3.0f, 2.0f, 255}, Ring{5.5f, 3.0f, 90}, Ring{8.5f, 3.0f, 40}}) {
    const float out = frame.units(ring.out);
    list.AddRect(ImVec2(box.x - out, box.y - out), ImVec2(box.right() + out, box.bottom() + out),
                 style::packed(theme().selected, ring.alpha), frame.units(4.0f) + out, 0,
                 frame.units(ring.thick));
  }
}

}  // namespace

void bring_lit_into_view(PanelFrame& frame, const std::string& control) {
  const LessonPage* page = page_shown(frame);
  if (page == nullptr) return;
  const bool lit = std::any_of(page->lights.begin(), page->lights.end(),
                               [&](const Light& light) { return light.control == control; });
  if (!lit) return;
  const ImGuiID id = ImGui::GetID(("lit " + control).c_str());
  const int number = static_cast<int>(frame.session.learning->lesson->page) + 1;
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  if (storage.GetInt(id) == number) return;
  storage.SetInt(id, number);
  ImGui::SetScrollHereY(0.5f);
}

void draw_lit_controls(PanelFrame& frame) {
  const LessonPage* page = page_shown(frame);
  const bool covered = frame.session.view->dialogs.help_open ||
                       frame.session.view->dialogs.open_dialog_open ||
                       ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  if (page == nullptr || covered) return;
  for (const Light& light : page->lights) {
    const auto box = frame.memory.controls.find(light.control);
    if (box != frame.memory.controls.end()) draw_glow(frame, box->second);
  }
}

}  // namespace app
