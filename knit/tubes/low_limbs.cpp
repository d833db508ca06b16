#include "knit/tubes/low_limbs.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace knit {

namespace {

double area_of(const MorseSurface& surface) {
  double area = 0.0;
  const auto& p = surface.positions;
  for (const auto& [a, b, c] : surface.triangles)
    area += 0.5 * glm::length(glm::cross(p[b] - p[a], p[c] - p[a]));
  return area;
}

}  // namespace

bool is_low(const TubePlan& plan, const LeftOut& left_out) {
  return !left_out.handle && left_out.height < low_limb * plan.stitch_height;
}

LowLimbs low_limbs(const TubeGraph& graph, const TubePlan& plan) {
  LowLimbs low;
  double swept = 0.0;
  for (const LeftOut& left_out : plan.left_out) {
    if (!is_low(plan, left_out)) continue;
    ++low.count;
    swept += left_out.height * left_out.girth;
    if (low.highest == nullptr || left_out.height > low.highest->height) low.highest = &left_out;
  }
  if (low.count > 0) low.share = std::min(1.0, swept / area_of(graph.surface));
  return low;
}

}  // namespace knit
