#include "app/panels/ui.h"

#include <imgui.h>

#include <algorithm>

#include "app/panels/kit/commands.h"
#include "app/panels/kit/panels.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/program.h"
#include "app/session/view.h"

namespace app {

void TextBuffer::set(const std::string& text) {
  bytes.fill('\0');
  std::copy_n(text.begin(), std::min(text.size(), bytes.size() - 1), bytes.begin());
}

std::string TextBuffer::text() const { return {bytes.data()}; }

void PanelFrame::mark(std::string_view control) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  // What is scrolled out of its panel is not there to be pointed at.
  if (!ImGui::IsItemVisible()) return;
  ui.controls.insert_or_assign(std::string(control), Box{low.x, low.y, high.x - low.x, high.y - low.y});
}

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
          session.learning->lesson ? lesson_height : 0.0f};
}

Actions draw_ui(const Session& session, UiState& ui, const Scene& scene, const Layout& layout,
                const Fonts& fonts) {
  PanelFrame frame{session, ui, scene, layout, fonts, pressed_commands(session)};
  ui.controls.clear();
  if (session.document) ui.run.refresh(session.document->timeline);
  const bool wants_chart = session.view->centre == CentrePanel::chart || session.view->gaze.knit_along ||
                           session.view->side == SidePanel::pattern;
  if (session.document && wants_chart) ui.chart.refresh(session.document->timeline, session.view->pattern);
  draw_menu(frame);
  draw_splitters(frame);
  if (session.program->preferences.shows(Panel::parameters)) draw_parameters(frame);
  if (session.program->preferences.shows(Panel::side)) draw_explanation(frame);
  if (session.program->preferences.shows(Panel::timeline)) draw_timeline(frame);
  if (session.view->centre == CentrePanel::chart) {
    ui.click.reset();
    draw_chart(frame);
  } else {
    draw_view(frame);
  }
  draw_knit_along(frame);
  if (session.learning->lesson) draw_lesson(frame);
  draw_prediction(frame);
  draw_view_overlays(frame);
  draw_animation_progress(frame);
  draw_help(frame);
  draw_glossary(frame);
  draw_action_palette(frame);
  draw_open_dialog(frame);
  draw_save_dialog(frame);
  draw_figure_dialog(frame);
  if (frame.rounds_under != session.view->gaze.hovered_rounds) frame.wish(HoverRounds{frame.rounds_under});
  return std::move(frame.actions);
}

}  // namespace app
