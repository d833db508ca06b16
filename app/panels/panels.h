// The panels, each in its own file, and what they are drawn with.
#pragma once

#include <string_view>

#include "app/panels/ui.h"

namespace app {

// One frame's drawing. Panels read the session and leave their wishes in `actions`.
struct PanelFrame {
  const Session& session;
  UiState& ui;
  const Scene& scene;
  const Layout& layout;
  const Fonts& fonts;
  Actions actions;

  void wish(Action action) { actions.push_back(std::move(action)); }
  // Notes where the last item stands.
  void mark(std::string_view control);
  // Plain-screen units in window units.
  [[nodiscard]] float units(float plain) const { return plain * layout.scale; }
  // Null while nothing is open.
  [[nodiscard]] const knit::Timeline* timeline() const {
    return session.timeline ? &*session.timeline : nullptr;
  }
};

void draw_menu(PanelFrame& frame);
void draw_view(PanelFrame& frame);
void draw_captions(PanelFrame& frame);       // inside the view's window
void draw_chart(PanelFrame& frame);          // in the view's place
void draw_knit_along(PanelFrame& frame);     // over the foot of either
void draw_view_overlays(PanelFrame& frame);  // notices, the picking banner, the empty state
void draw_parameters(PanelFrame& frame);
void draw_edits(PanelFrame& frame);  // inside the parameters
void draw_explanation(PanelFrame& frame);
void draw_report_card(PanelFrame& frame);  // its other side
void draw_last_step(PanelFrame& frame);    // the explanation's parts
void draw_layers(PanelFrame& frame);
void draw_legend(PanelFrame& frame);
void draw_rows(PanelFrame& frame);
void draw_problems(PanelFrame& frame);
void draw_timeline(PanelFrame& frame);
void draw_transport(PanelFrame& frame);  // the timeline's parts
void draw_track(PanelFrame& frame);
void draw_help(PanelFrame& frame);
void draw_open_dialog(PanelFrame& frame);
void draw_save_dialog(PanelFrame& frame);

// Of the row in the making; none: 0.
std::int32_t row_at_hand(const PanelFrame& frame);
// To the end of a row in the stage at hand.
void wish_row(PanelFrame& frame, std::int32_t number);

// How many lines the list of problems has.
std::size_t count_problems(const PanelFrame& frame);

}  // namespace app
