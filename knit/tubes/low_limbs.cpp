#include "knit/tubes/low_limbs.h"

#include <algorithm>

#include "knit/mesh/surface_area.h"

namespace knit {

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
  if (low.count > 0)
    low.share = std::min(1.0, swept / surface_area(graph.surface.positions, graph.surface.triangles));
  return low;
}

}  // namespace knit
