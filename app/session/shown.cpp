#include "app/session/shown.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/session/document.h"

namespace app {

bool has_settled(const Session& session) {
  return session.document && static_cast<bool>(session.document->timeline.state().placed);
}

bool has_relaxed(const Session& session) {
  return session.document && knit::relaxed_places(session.document->timeline.state()) != nullptr;
}

Positions positions_shown(const Session& session) {
  const Positions wished = session.view->positions;
  const bool there = wished == Positions::placed ? has_settled(session) : has_relaxed(session);
  return there ? wished : Positions::settled;
}

std::shared_ptr<const std::vector<glm::dvec3>> places_shown(const Session& session) {
  const knit::State& state = session.document->timeline.state();
  switch (session.view->positions) {
    case Positions::placed:
      return state.placed.pointer();
    case Positions::relaxed:
      return knit::relaxed_places(state);
    case Positions::settled:
      break;
  }
  return nullptr;
}

knit::Bounds bounds_shown(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Bounds& mesh = timeline.input().bounds;
  const auto places =
      session.view->positions == Positions::relaxed ? knit::relaxed_places(timeline.furthest()) : nullptr;
  if (!places) return mesh;
  std::vector<glm::dvec3> all{mesh.low, mesh.high};
  all.insert(all.end(), places->begin(), places->end());
  knit::Bounds both = knit::bounds_of(all);
  // Of the mesh its own ball counts, not its box's.
  both.radius = glm::distance(both.centre(), mesh.centre()) + mesh.radius;
  for (const glm::dvec3& place : *places)
    both.radius = std::max(both.radius, glm::distance(both.centre(), place));
  return both;
}

knit::Fabric shown_fabric(const Session& session) {
  const knit::State& state = session.document->timeline.state();
  const auto places = places_shown(session);
  return places ? state.fabric.moved_to(*places) : state.fabric;
}

knit::State shown_state(const Session& session) {
  knit::State state = session.document->timeline.state();
  if (const auto places = places_shown(session)) state.fabric = state.fabric.moved_to(*places);
  return state;
}

std::string_view shown_words(const Session& session) {
  switch (positions_shown(session)) {
    case Positions::placed:
      return " as placed";
    case Positions::relaxed:
      return " as relaxed";
    case Positions::settled:
      break;
  }
  return "";
}

}  // namespace app
