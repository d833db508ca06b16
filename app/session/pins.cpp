#include "app/session/pins.h"

#include "app/session/document.h"
#include "app/session/session.h"
#include "app/session/view.h"

namespace app {

PinnedEnd end_of(const RunTally& run, const Knobs& knobs) { return {run.state, figures_of(run, knobs)}; }

void take_end(Pin& pin, PinnedEnd end) {
  pin.end = std::move(end.state);
  pin.figures = std::move(end.figures);
  pin.known = true;
  pin.work.reset();
}

bool is_at_hand(const Session& session, const Pin& pin) {
  return session.document && session.document->timeline.input_pointer() == pin.input &&
         knobs_of(session.document->timeline) == pin.knobs;
}

Pin pin_of(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  Pin pin;
  pin.input = timeline.input_pointer();
  pin.knobs = knobs_of(timeline);
  if (timeline.complete()) take_end(pin, end_of(tally_of(timeline), pin.knobs));
  return pin;
}

bool pin_is_pending(const Session& session) {
  return session.document && session.document->pinned && !session.document->pinned->known;
}

bool shows_both(const Session& session) {
  return session.view->both && session.view->centre == CentrePanel::view && session.document &&
         session.document->pinned;
}

bool is_of_this_mesh(const Session& session, const Pin& pin) {
  if (!session.document) return false;
  const knit::Input& here = session.document->timeline.input();
  if (&here == pin.input.get()) return true;
  // Welding drops vertices; the triangles that stay are the same places in the same order.
  const auto same = [](const knit::Mesh& a, const knit::Mesh& b) {
    return a.positions == b.positions && a.triangles == b.triangles;
  };
  if (same(here.mesh, pin.input->mesh)) return true;
  const bool welded_differs =
      session.document->timeline.base_parameters().mesh.weld != pin.knobs.base.mesh.weld;
  return welded_differs && same(knit::weld(here.mesh), knit::weld(pin.input->mesh));
}

}  // namespace app
