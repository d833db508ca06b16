// The first start: one line that says what this is, and the first lesson.
#include <algorithm>

#include "app/panels/kit/widgets.h"
#include "app/panels/view/overlays.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"

namespace app {

namespace {

struct FirstStartAway {
  bool away = false;
};

// Nothing is known of whoever sits here: no lesson was ever taken, and nothing opened but what the program opens itself.
bool is_first_start(const PanelFrame& frame) {
  const Session& session = frame.session;
  const Preferences& preferences = session.program->preferences;
  return session.jobs->beside && session.document && session.document->source.file.empty() &&
         !session.learning->lesson && preferences.lessons.empty() && preferences.recent.size() <= 1;
}

}  // namespace

void draw_first_start(PanelFrame& frame) {
  bool& away = frame.own<FirstStartAway>().away;
  if (away || !is_first_start(frame) || frame.timeline()->position() > 0) return;
  // Who asked for more than the view has seen what this is.
  const View& view_of_it = *frame.session.view;
  if (view_of_it.centre != CentrePanel::view || view_of_it.gaze.knit_along) return;
  if (!frame.session.outbox->notices.empty()) return;
  if (frame.session.program->rescued || frame.session.jobs->repair_offer) return;
  const Box& view = frame.layout.view;
  const float margin = std::min(frame.units(10.0f), 0.1f * view.width);
  const float width = std::min(frame.units(560.0f), view.width - 2.0f * margin);
  ImGui::SetNextWindowPos(ImVec2(view.x + 0.5f * view.width, view.y + margin), ImGuiCond_Always,
                          ImVec2(0.5f, 0.0f));
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, view.height));
  push_raised_look(frame);
  ImGui::Begin("First start", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  pop_raised_look();
  wrapped_text("Step by step from a 3D mesh to a pattern to knit by hand. Space plays it.");
  if (ImGui::Button("Start lesson 1")) frame.wish(StartLesson{first_lesson});
  frame.mark("first-start/lesson");
  tooltip(frame, "What it does: a few pages, with a mesh to try things on.");
  ImGui::SameLine();
  if (ImGui::Button("Not now")) away = true;
  frame.mark("first-start/away");
  tooltip(frame, "All lessons are in the menu Help.");
  ImGui::End();
}

}  // namespace app
