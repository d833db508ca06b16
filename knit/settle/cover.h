// Places of the mesh that fabric may slide off while it settles, because the surface bends sharply there: ends of limbs,
// thin limbs that no row ends on, sharp edges.
//
// The mesh is cut until no edge is longer than half a stitch's width (nor finer than some hundred places a stitch, whatever
// the width); of all corners in a cube of that size the first stands for their area. Kept are those that lie at least 0.3 w
// outside the middle of the stitches up to two faces away: elsewhere faces cannot come to lie far below the surface,
// wherever their stitches go on it. Mesh units. Cost: as many searches of the nearest face as there are cubes.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <tuple>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/heard.h"
#include "knit/settle/graph.h"

namespace knit {

struct CoverPlace {
  glm::dvec3 at{0.0};
  double area = 0.0;       // that it stands for
  double allowed = 0.0;    // how far the fabric may lie from it at no cost
  std::uint32_t near = 0;  // of the graph's triangles, the nearest at first
  [[nodiscard]] auto fields() const { return std::tie(at, area, allowed, near); }
  friend bool operator==(const CoverPlace&, const CoverPlace&) = default;
};

// Of its stitch's height: from how far on a place counts as being left, and how much farther it counts as left by one.
inline constexpr double left_from = 0.75, left_by = 0.25;

// The fabric as it is placed: its stitches' positions and the surface's normals there.
struct PlacedFabric {
  const SettleGraph& graph;
  std::span<const glm::dvec3> positions, normals;
  double width = 1.0, height = 1.0;  // of a stitch
};
std::vector<CoverPlace> places_to_cover(const Input& input, const PlacedFabric& placed,
                                        const Heard& heard = {});

}  // namespace knit
