// The panels, each in its own file, and what they are drawn with.
#pragma once

#include <string_view>

#include "app/panels/ui.h"
#include "app/session/document.h"
#include "app/session/view.h"

namespace app {

struct Track;

// One frame's drawing. Panels read the session and leave their wishes in `actions`.
struct PanelFrame {
  const Session& session;
  UiState& ui;
  const Scene& scene;
  const Layout& layout;
  const Fonts& fonts;
  Actions actions;
  std::optional<RoundSpan> rounds_under = std::nullopt;  // the pointer, in whichever panel has it

  void wish(Action action) { actions.push_back(std::move(action)); }
  // Notes where the last item stands.
  void mark(std::string_view control);
  // Plain-screen units in window units.
  [[nodiscard]] float units(float plain) const { return plain * layout.scale; }
  // Null while nothing is open.
  [[nodiscard]] const knit::Timeline* timeline() const {
    return session.document ? &session.document->timeline : nullptr;
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
void draw_report_card(PanelFrame& frame);   // its other side
void draw_pattern_text(PanelFrame& frame);  // another side: the written rounds
void draw_compare(PanelFrame& frame);       // another: the pinned run beside the one at hand
void draw_sweep(PanelFrame& frame);         // another: many values of a parameter
void draw_last_step(PanelFrame& frame);     // the explanation's parts
void draw_layers(PanelFrame& frame);
void draw_legend(PanelFrame& frame);
void draw_rows(PanelFrame& frame);
void draw_problems(PanelFrame& frame);
void draw_candidates(PanelFrame& frame);
void draw_selected(PanelFrame& frame);  // one line over the lists, with ways on from there
void draw_breaks(PanelFrame& frame);
void draw_travel_marks(PanelFrame& frame,
                       const Track& track);  // on the track: hits of break conditions, the loop
void draw_pattern_marks(PanelFrame& frame, const Track& track);  // and the round under the pointer
void draw_rescue(PanelFrame& frame);      // over the view: a session from before a crash
void draw_mend_offer(PanelFrame& frame);  // over the view: what would make a mesh fit that is not
void draw_timeline(PanelFrame& frame);
void draw_transport(PanelFrame& frame);  // the timeline's parts
void draw_track(PanelFrame& frame);
void draw_help(PanelFrame& frame);
void draw_pseudo_code(PanelFrame& frame);  // of the stage at hand, with its variables
void draw_lesson(PanelFrame& frame);       // in the strip below the view
void draw_prediction(PanelFrame& frame);   // over the view: what comes next?
void draw_lesson_menu(PanelFrame& frame);
void draw_figure_menu(PanelFrame& frame);    // inside the File menu
void draw_figure_dialog(PanelFrame& frame);  // size, stretch and rate of what is saved
void draw_animation_progress(PanelFrame& frame);
void draw_action_palette(PanelFrame& frame);
void draw_glossary(PanelFrame& frame);
void draw_splitters(PanelFrame& frame);
void draw_open_dialog(PanelFrame& frame);
void draw_save_dialog(PanelFrame& frame);

// Of the row in the making; none: 0.
std::int32_t row_at_hand(const PanelFrame& frame);
// To the end of a row in the stage at hand.
void wish_row(PanelFrame& frame, std::int32_t number);

// That is knitted along, or in the making; none: 0.
std::int32_t round_at_hand(const PanelFrame& frame);
// There, as wish_row; who knits along goes on from there.
void wish_round(PanelFrame& frame, std::int32_t number);
// Inside the written pattern: its title, yarn and needle, folded away.
void draw_pattern_fields(PanelFrame& frame);
// Of the step under the pointer, which is on the track.
void mean_round_under(PanelFrame& frame, const Track& track);
// Under the pointer, by a stitch, a square, a line of the text or the timeline.
std::optional<RoundSpan> rounds_meant(const Session& session);

// How many lines the list of problems has.
std::size_t count_problems(const PanelFrame& frame);

}  // namespace app
