// A polygon of the file to triangles, for obj.cpp.
#pragma once

#include <span>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

// Appends exactly corners.size() - 2 triangles that keep the polygon's direction. A quad is cut along its
// shorter diagonal that lies inside, more corners by clipping ears, concave or not. What has no clear inside
// (crossing itself, or of no area) still gets its triangles, each edge of the polygon once, so that topology
// never depends on luck. Ears in one plane then get Delaunay's edges (flat_flips.h), also across the bridge that leads to
// a hole, so that a flat ring has the same triangles however it was written. Requires three or more corners, all in range.
void triangulate(std::span<const VertexId> corners, const std::vector<glm::dvec3>& positions,
                 std::vector<Triangle>& triangles);

}  // namespace knit
