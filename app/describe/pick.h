// From a place on the screen to what lies under it.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "app/session/session.h"
#include "app/session/view.h"
#include "knit/insight/why.h"

namespace app {

// The mesh vertex nearest to the place where the ray through `place` ([-1, 1], up positive) first meets the
// surface.
std::optional<knit::VertexId> pick_vertex(const Session& session, const glm::dvec2& place);

// The finished stitch within `reach` of `place` on the screen (in heights of half the view) that is nearest to
// the eye.
std::optional<StitchAt> pick_stitch(const Session& session, const glm::dvec2& place, double reach);

// What a click in the view means: a stitch, an edge, a face or a vertex of the mesh.

// How far from the pointer things are still meant, in heights of half the view.
struct PickReach {
  double point = 0.03, edge = 0.015;
};

// Of what is shown and in front, the nearest stitch within reach; else the nearest edge; else the face under the
// place; else the mesh's vertex there. The cycle's vertices and, with the mesh's edges shown, the mesh's come
// before edges, because edges run through them; a stitch at the same place comes first.
std::optional<knit::Element> pick_thing(const Session& session, const glm::dvec2& place,
                                        const PickReach& reach);

}  // namespace app
