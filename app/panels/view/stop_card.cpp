// Near a stop: why the run went no further, and the ways on as buttons that take them.
#include <algorithm>

#include "app/panels/kit/stop_ways.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/offers/repair_buttons.h"
#include "app/panels/view/overlays.h"
#include "app/panels/view/view.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/program.h"
#include "app/session/run_key.h"

namespace app {

namespace {

// Put away for the run that it was about.
struct StopCardAway {
  std::optional<RunKey> run;
};

// What stands over the buttons, as high as it was in the last frame.
struct StopCardHead {
  float height = 0.0f;
};

constexpr float stop_card_width = 400.0f;

float height_of_way() { return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y; }

// Its top stands where all ways that may be found have room below, so that a button which comes moves none of the others.
void place_stop_card(PanelFrame& frame) {
  const Box& view = frame.layout.view;
  const float margin = std::min(frame.units(10.0f), 0.1f * view.width);
  const float width = std::min(frame.units(stop_card_width), view.width - 2.0f * margin);
  const float most = 0.7f * view.height;
  const float whole = frame.own<StopCardHead>().height + static_cast<float>(enough_ways) * height_of_way();
  ImGui::SetNextWindowPos(ImVec2(view.x + margin, view.bottom() - margin - std::min(whole, most)));
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, most));
}

}  // namespace

void draw_stop_card(PanelFrame& frame) {
  frame.own<StopCardPlace>().box.reset();
  if (stop_shown(frame.session) == nullptr || frame.session.learning->lesson) return;
  if (frame.session.jobs->repair_offer || frame.session.view->gaze.picking != Picking::nothing) return;
  const RunKey run = run_key(*frame.timeline());
  if (frame.own<StopCardAway>().run == run) return;
  place_stop_card(frame);
  push_raised_look(frame);
  ImGui::Begin("Stopped", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  pop_raised_look();
  push_font(frame.fonts.strong);
  text("The run stopped here");
  pop_font();
  const float side = ImGui::GetFrameHeight();
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - side);
  if (icon_button("stop away", Icon::cross, ImVec2(side, side))) frame.own<StopCardAway>().run = run;
  frame.mark("stop/away");
  tooltip(frame, "Puts this away. The list Problems has it too.");
  // Beside it the step says why.
  const bool is_said =
      frame.session.program->preferences.shows(Panel::side) && frame.session.view->side == SidePanel::step;
  if (!is_said) wrapped_text(sentence(frame.session));
  draw_repair_buttons(frame, "stop/");
  const std::size_t ways = draw_stop_ways(frame, "stop/");
  frame.own<StopCardHead>().height = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y +
                                     ImGui::GetStyle().WindowPadding.y + ImGui::GetScrollY() -
                                     static_cast<float>(ways) * height_of_way();
  const ImVec2 at = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  frame.own<StopCardPlace>().box = Box{at.x, at.y, size.x, size.y};
  ImGui::End();
}

}  // namespace app
