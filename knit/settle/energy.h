// What settling makes small: squares of how far wales, courses, quads, rims and corners are from what they should be.
//
//   wale   * sum over wales    ((|e| - h) / h)^2
//   course * sum over courses  ((|e| - w) / w)^2
//   shear  * sum over quads    ((|d1| - |d2|) / hypotenuse(w, h))^2      d1, d2 the diagonals
//   rim    * sum over stitches of rims  (distance to the rim's first polygon / w)^2
//   fold   * sum over corners  (max(0, 1/4 - a) + max(0, 0.15 - a))^2     a = n . ((q - p) x (r - p)) / (w h)
//   cover  * sum over places that fabric may slide off  area / (w h) * (max(0, d - allowed) / (h / 4))^2
//            d from the place to the nearest face; allowed 3/4 h, or what it was at first if that is more
// Without the last, fabric slides off what sticks out: it would be shorter farther in. So a place that comes to lie uncovered,
// h away, costs its area in stitches.
// One step of Levenberg-Marquardt linearises each in the tangent planes of its stitches, two unknowns a stitch, normals
// held still: A = sum of g g^T, b = sum of g r, and (A + shift) x = -b. Of a place that a face's stitches cover by the shares
// c, A gets c g g^T at each stitch alone, which is no less (Jensen) and the same where they move alike. To A comes how edges that are too long resist being
// turned, (|e| - L) / |e| of the identity across e: without it a step turns them wildly, and about twice as many iterations
// are needed. Cost: one pass over all terms.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <tuple>
#include <vector>

#include "knit/model/settings.h"
#include "knit/settle/blocks.h"
#include "knit/settle/cover.h"
#include "knit/settle/graph.h"

namespace knit {

// The terms, with what does not change while stitches move.
struct SettleTerms {
  SettleGraph graph;
  std::vector<std::vector<glm::dvec3>> rim_polygons;  // as the stitches of graph.rims lay at first
  std::vector<CoverPlace> places;
  double facing = 1.0;               // -1: faces run clockwise seen from the mesh's outside
  double width = 1.0, height = 1.0;  // of a stitch
  [[nodiscard]] auto fields() const { return std::tie(graph, rim_polygons, places, facing, width, height); }
  friend bool operator==(const SettleTerms&, const SettleTerms&) = default;
};

// By number along the knitting path.
struct Placed {
  std::span<const glm::dvec3> positions, normals;
  // Per place to be covered the triangle that it was found nearest to last, or empty. It saves searches; nothing that comes
  // out depends on it.
  std::span<std::uint32_t> near = {};
};

// Two directions of length 1 that span the plane across a normal.
struct Frame {
  glm::dvec3 u{0.0}, v{0.0};
};
Frame frame_across(const glm::dvec3& normal);

// Which way faces run: by most corners.
double facing_of(const SettleGraph& graph, Placed placed);

double sum_of_terms(const SettleTerms& terms, const SettleSettings& settings, Placed placed);

// Adds to each stitch the terms that hang on it, `sign` times.
void add_terms(const SettleTerms& terms, const SettleSettings& settings, Placed placed, double sign,
               std::vector<double>& around);

// How the sum changes with each position, normals held still.
std::vector<glm::dvec3> slopes_of(const SettleTerms& terms, const SettleSettings& settings, Placed placed);

// The system of a step, without its shift.
void linearise(const SettleTerms& terms, const SettleSettings& settings, Placed placed,
               std::span<const Frame> frames, const BlockPattern& pattern, BlockSystem& system);

}  // namespace knit
