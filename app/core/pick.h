// From a place on the screen to what lies under it.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "app/core/session.h"

namespace app {

// The mesh vertex nearest to the place where the ray through `place` ([-1, 1], up positive) first meets the
// surface.
std::optional<knit::VertexId> pick_vertex(const Session& session, const glm::dvec2& place);

// The finished stitch within `reach` of `place` on the screen (in heights of half the view) that is nearest to
// the eye.
std::optional<StitchAt> pick_stitch(const Session& session, const glm::dvec2& place, double reach);

}  // namespace app
