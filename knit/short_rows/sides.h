// Which sides of triangles lie on each other, and the loops of those that lie on none.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

// Per side 3 t + k, from corner k to the next: the side of another triangle that leads back; no_half_edge on a rim.
// Requires triangles all the same way round, and no more than two to a side.
std::vector<HalfEdge> across_sides(std::span<const Triangle> triangles);

// The rims, each as its points in the order of its triangles' sides.
std::vector<std::vector<VertexId>> rims_of(std::span<const Triangle> triangles,
                                           std::span<const HalfEdge> across);

}  // namespace knit
