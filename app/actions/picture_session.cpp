#include "app/actions/picture_session.h"

#include <cmath>
#include <utility>

#include "app/session/document.h"
#include "app/session/program.h"
#include "app/session/view.h"

namespace app {

Session figure_session(const Session& session) {
  Session figure;
  figure.program = session.program;
  figure.program->rescued.reset();
  figure.document = session.document;
  figure.view = session.view;
  figure.view->dialogs = {};
  figure.view->gaze.picking = Picking::nothing;
  figure.view->gaze.hovered_stitch.reset();
  figure.view->gaze.hovered_rounds.reset();
  figure.view->gaze.hovered_twin_stitches.clear();
  figure.view->gaze.hovered_twins.clear();
  figure.view->playback.playing = false;
  return figure;
}

Session finished_piece(const Session& session) {
  Session piece = figure_session(session);
  Document& document = *piece.document;
  document.timeline.seek(document.timeline.known());
  document.pinned.reset();
  document.travel.selected.reset();
  document.travel.sized.reset();
  View& view = *piece.view;
  view.layers.fill(false);
  for (const Layer layer : {Layer::faces, Layer::column_edges, Layer::row_edges})
    view.layers[static_cast<std::size_t>(layer)] = true;
  view.gaze.knit_along.reset();
  view.aspect = 1.0;
  view.gaze.camera.frame(document.timeline.input().bounds, view.aspect);
  return piece;
}

void fit_view(Session& session, double aspect) {
  if (!(aspect > 0.0)) return;
  View& view = *session.view;
  Camera& camera = view.gaze.camera;
  if (aspect < view.aspect)
    camera.field_of_view = 2.0 * std::atan(std::tan(0.5 * camera.field_of_view) * view.aspect / aspect);
  view.aspect = aspect;
}

}  // namespace app
