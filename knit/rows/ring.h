// A level's vertices as one closed ring in working order: the cycle that Algorithm 2 walks. Thesis 3.2.3,
// step 2.
//
// Order: counter-clockwise seen along the direction of knitting, by angle about the level's centroid. It
// starts at the vertex nearest to the start direction (see row_frame), so that every row begins on the same
// side.
#pragma once

#include <optional>
#include <span>
#include <variant>

#include "knit/fabric/stitch.h"
#include "knit/mesh/mesh.h"
#include "knit/model/products.h"

namespace knit {

struct NotARing {
  std::int32_t vertices = 0;  // distinct places of the level
  std::int32_t loops = 0;     // closed loops its vertices form through mesh edges; 0: no closed loop
};

// By angle; where neighbours by angle are not neighbours on the mesh (not star-shaped), by walking the mesh's
// edges. A level without edges of its own is accepted by angle, unless it has fewer than three places.
std::variant<Ring, NotARing> order_ring(const Input& input, const Ends& ends, std::span<const VertexId> level,
                                        const std::optional<glm::dvec3>& start_direction = std::nullopt);

// `count` places spread evenly from the ring's first point on.
std::vector<Stitch> spread_evenly(const Ring& ring, std::int32_t count);

}  // namespace knit
