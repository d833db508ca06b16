// The area of triangles, summed in their order. Slivers and triangles without area too.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "knit/mesh/mesh.h"

namespace knit {

// In square units of the positions.
double surface_area(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles);

}  // namespace knit
