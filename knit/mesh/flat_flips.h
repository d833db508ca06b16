// Edges inside flat parts of a surface, chosen anew: how a flat part is cut into triangles says nothing of the shape, but
// whatever runs straight over each triangle, as level curves of a solved field do, runs otherwise over long thin ones.
//
// An edge between two triangles of one plane is flipped to the quad's other diagonal where the two angles against it add up to
// more than a half turn, until there is none: the Delaunay triangles of the flat part. Corners on one circle keep the diagonal
// that they have. No vertex moves, and no edge is made that is there already.
// C. Lawson, "Software for C1 surface interpolation", 1977. O(n log n) and the flips, which are few.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

// Only edges that two of these triangles pass, in opposite directions, are looked at. The flips made come back.
// `across`: each half-edge's other side, where somebody knows it already; then a mesh that wants no flip is soon told.
std::size_t flip_flat_edges(std::span<Triangle> triangles, const std::vector<glm::dvec3>& positions,
                            const std::vector<HalfEdge>& across = {});

}  // namespace knit
