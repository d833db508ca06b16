#include "app/session/shown.h"

#include "app/session/document.h"
#include "app/session/view.h"

namespace app {

namespace {

bool as_placed(const Session& session) {
  return session.view->positions == Positions::placed && has_settled(session);
}

}  // namespace

bool has_settled(const Session& session) {
  return session.document && static_cast<bool>(session.document->timeline.state().placed);
}

knit::Fabric shown_fabric(const Session& session) {
  const knit::State& state = session.document->timeline.state();
  return as_placed(session) ? knit::placed_fabric(state) : state.fabric;
}

knit::State shown_state(const Session& session) {
  knit::State state = session.document->timeline.state();
  if (as_placed(session)) state.fabric = knit::placed_fabric(state);
  return state;
}

std::string_view shown_words(const Session& session) { return as_placed(session) ? " as placed" : ""; }

}  // namespace app
