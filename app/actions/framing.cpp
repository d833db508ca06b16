#include "app/actions/framing.h"

#include "app/session/document.h"
#include "app/session/shown.h"
#include "app/session/view.h"

namespace app {

namespace {

bool same_box(const knit::Bounds& a, const knit::Bounds& b) {
  return a.low == b.low && a.high == b.high && a.radius == b.radius;
}

}  // namespace

void frame_all(Session& session) {
  session.view->gaze.camera.frame(bounds_shown(session), session.view->aspect);
}

std::optional<FramedWhole> framed_whole(const Session& session) {
  if (!session.document) return std::nullopt;
  const knit::Bounds bounds = bounds_shown(session);
  const Camera& camera = session.view->gaze.camera;
  Camera framing = camera;
  framing.frame(bounds, session.view->aspect);
  if (framing.target != camera.target || framing.distance != camera.distance) return std::nullopt;
  return FramedWhole{camera.target, camera.distance, bounds};
}

void frame_again(Session& session, const FramedWhole& before) {
  const Camera& camera = session.view->gaze.camera;
  if (!session.document || camera.target != before.target || camera.distance != before.distance) return;
  if (!same_box(before.bounds, bounds_shown(session))) frame_all(session);
}

void show_as_relaxed(Session& session, bool before, bool now) {
  Positions& positions = session.view->positions;
  if (now && !before) positions = Positions::relaxed;
  if (before && !now && positions == Positions::relaxed) positions = Positions::settled;
}

}  // namespace app
