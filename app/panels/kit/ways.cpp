#include "app/panels/kit/ways.h"

#include "app/session/view.h"

namespace app {

std::int32_t current_row(const PanelFrame& frame) {
  const knit::Step* step = last_step(frame.session);
  return step != nullptr ? step->place.row : 0;
}

void wish_row(PanelFrame& frame, std::int32_t number) {
  const knit::Stage at = frame.timeline()->state().stage();
  const knit::Stage stage = at == knit::Stage::done ? knit::Stage::pattern : at;
  const bool by_rows = stage >= knit::Stage::rows && stage <= knit::Stage::pattern &&
                       stage != knit::Stage::settle && stage != knit::Stage::relax;
  frame.wish(SeekPlace{{by_rows && number > 1 ? stage : knit::Stage::rows, number, INT32_MAX}});
}

std::optional<RoundSpan> rounds_meant(const Session& session) {
  if (session.view->gaze.hovered_rounds) return session.view->gaze.hovered_rounds;
  if (!session.view->gaze.hovered_stitch) return std::nullopt;
  return RoundSpan{session.view->gaze.hovered_stitch->row, session.view->gaze.hovered_stitch->row};
}

std::vector<RoundSpan> all_rounds_meant(const Session& session) {
  std::vector<RoundSpan> all;
  const Gaze& gaze = session.view->gaze;
  if (const auto rounds = rounds_meant(session)) all.push_back(*rounds);
  if (gaze.hovered_rounds) {
    all.insert(all.end(), gaze.hovered_twins.begin(), gaze.hovered_twins.end());
  } else {
    for (const StitchAt& stitch : gaze.hovered_twin_stitches) all.push_back({stitch.row, stitch.row});
  }
  return all;
}

}  // namespace app
