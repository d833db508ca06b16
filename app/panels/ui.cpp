#include "app/panels/ui.h"

#include <imgui.h>

#include "app/panels/checker/checker_panel.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/number_field.h"
#include "app/panels/kit/run_cache.h"
#include "app/panels/kit/splitters.h"
#include "app/panels/kit/stop_ways.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/parameters/parameters.h"
#include "app/panels/pattern/pattern.h"
#include "app/panels/side_panel.h"
#include "app/panels/timeline/present.h"
#include "app/panels/timeline/timeline.h"
#include "app/panels/view/view.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/pins.h"
#include "app/session/program.h"
#include "app/session/view.h"

namespace app {

LayoutWish layout_wish(const Session& session) {
  const Preferences& chosen = session.program->preferences;
  const auto size = [&](Split split) {
    return static_cast<float>(chosen.splits[static_cast<std::size_t>(split)]);
  };
  return {chosen.shows(Panel::parameters),
          chosen.shows(Panel::side),
          chosen.shows(Panel::timeline),
          size(Split::left),
          size(Split::right),
          size(Split::bottom),
          session.learning->lesson ? lesson_height : 0.0f,
          session.learning->prediction && session.document ? guess_height : 0.0f,
          session.view->presenting,
          shows_both(session),
          shows_checker(session),
          !session.program->embedded};
}

float ui_scale(const Session& session, float width, float height, float scale) {
  const float chosen = scale * static_cast<float>(session.program->preferences.scale);
  return session.view->presenting ? presenting_scale(width, height, chosen) : chosen;
}

namespace {

// Where most numbers are: who types one there means none of the view's layers.
bool over_fields(const Layout& layout) {
  const ImVec2 at = ImGui::GetIO().MousePos;
  const auto over = [&](const Box& box) {
    return at.x >= box.x && at.x < box.right() && at.y >= box.y && at.y < box.bottom();
  };
  return over(layout.parameters) || over(layout.explanation);
}

// All about the view, where one is not presenting.
void draw_panels(PanelFrame& frame) {
  const Preferences& chosen = frame.session.program->preferences;
  if (frame.layout.menu.height > 0.0f) draw_menu(frame);
  draw_splitters(frame);
  if (chosen.shows(Panel::parameters)) draw_parameters(frame);
  if (chosen.shows(Panel::side)) draw_side_panel(frame);
  if (chosen.shows(Panel::timeline)) draw_timeline(frame);
}

void draw_about_the_mesh(PanelFrame& frame) {
  const View& how = *frame.session.view;
  if (how.presenting) {
    draw_large_caption(frame);
    draw_thin_timeline(frame);
  } else {
    draw_panels(frame);
  }
  if (how.centre == CentrePanel::chart) {
    frame.own<PendingClick>() = {};
    draw_chart(frame);
  } else {
    draw_view(frame);
    if (shows_both(frame.session)) draw_other_view(frame);
  }
  draw_knit_along(frame);
  if (frame.session.learning->lesson) draw_lesson(frame);
  draw_prediction(frame);
}

}  // namespace

Actions draw_ui(const Session& session, PanelMemory& memory, const Scene& scene, const Layout& layout,
                const Fonts& fonts, const Scene* other) {
  PanelFrame frame{session, memory, scene, layout, fonts, {}};
  frame.other_scene = other;
  auto& list = memory.own<HangingList>();
  if (shows_checker(session)) {
    frame.actions = commands_in_checker(session);
  } else if (list.open) {
    frame.actions = commands_over_list(session);
    list = {false, !frame.actions.empty()};
  } else if (!number_field_open(memory)) {
    frame.actions = pressed_commands(session, !over_fields(layout));
  }
  memory.controls.clear();
  if (session.document) memory.own<RunCache>().refresh(session.document->timeline);
  if (shows_checker(session)) {
    memory.own<PendingClick>() = {};
    if (frame.layout.menu.height > 0.0f) draw_menu(frame);
    draw_checker(frame);
  } else {
    draw_about_the_mesh(frame);
  }
  draw_view_overlays(frame);
  draw_animation_progress(frame);
  draw_help(frame);
  draw_glossary(frame);
  draw_action_palette(frame);
  draw_go_to(frame);
  draw_open_dialog(frame);
  draw_save_dialog(frame);
  draw_figure_dialog(frame);
  if (session.view->presenting && !shows_checker(session)) draw_ring(frame);
  const Gaze& gaze = session.view->gaze;
  if (frame.rounds_under != gaze.hovered_rounds || frame.twins_under != gaze.hovered_twins)
    frame.wish(HoverRounds{frame.rounds_under, frame.twins_under});
  return std::move(frame.actions);
}

void draw_captions_alone(const Session& session, PanelMemory& memory, const Scene& scene,
                         const Layout& layout, const Fonts& fonts) {
  PanelFrame frame{session, memory, scene, layout, fonts, {}};
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  memory.controls.erase("legend-box");  // there is none
  begin_panel("Captions", layout.view, ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar();
  draw_captions(frame);
  ImGui::End();
}

bool click_waits(PanelMemory& memory) { return memory.own<PendingClick>().waits; }

bool panels_are_working(PanelMemory& memory) { return ways_are_tried(memory); }

void forget_what_was_seen(PanelMemory& memory) {
  RunCache run = std::move(memory.own<RunCache>());
  memory = PanelMemory();
  memory.own<RunCache>() = std::move(run);
}

}  // namespace app
