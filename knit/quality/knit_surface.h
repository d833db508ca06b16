// The knit mesh as triangles: what distances to it are measured by. Quads are cut between their first and third corner.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/run/state.h"

namespace knit {

struct KnitSurface {
  std::vector<glm::dvec3> positions;  // the knitting path first
  std::vector<Triangle> triangles;    // counter-clockwise seen from outside
};

// Of strips and deals; openings stay open.
KnitSurface knit_surface(const State& state);

}  // namespace knit
