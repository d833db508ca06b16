// In which order to eliminate the vertices of a surface, so that a sparse factorisation stays sparse.
//
// Nested dissection: a plane halves the vertices, those beside the cut come last, and so on in each half. On
// a sphere of half a million vertices the factorisation then takes a third of the arithmetic that it takes in
// Eigen's minimum degree ordering. A. George, "Nested dissection of a regular finite element mesh", 1973.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "knit/model/heard.h"
#include "knit/timing/intrinsic.h"

namespace knit {

// Every vertex that has spokes, once.
std::vector<VertexId> order_by_dissection(const Spokes& spokes, std::span<const glm::dvec3> positions,
                                          const Heard& heard = {});

}  // namespace knit
