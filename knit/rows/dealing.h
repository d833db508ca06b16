// Events of tubes, done to live loops (knit/fabric/deal.h): where a loop is cut in two, where two are opened and joined, and
// the bridge across the saddle. Pure: a fabric and a plan in, the deal out.
//
// Split of the loop p_0 .. p_(n-1) at saddle S: d1, d2 the squared distances to the children's lowest curves, m_i the middle
// of p_(i-1) p_i; the arc from i on of l stitches, min(3, n/2) <= l <= n - that, goes to child 1, where
//   sum of d1 over the arc + sum of d2 over the rest + |m_i - S|^2 + |m_(i+l) - S|^2  is least: prefix sums, O(n^2).
// Join: each loop is opened at the gap whose middle is nearest to S.
// Bridge over the gap D = |A S| + |S B|: g = max(0, round(D / w) - 1) stitches at equal steps on A S B, moved to the surface;
// more where a child would have under three stitches, or an edge would be there twice.
// The beginning of the round stays where it is: of a split, the child that has it goes on with it; of a join it is that of the
// loop that brings the yarn. The other child of a split begins a quarter along its arc, beside the saddle: decreases gather
// at the saddle, where wales are longest, and opposite it, and none may lie across the beginning. In a rhythm shaping stands
// beside mains, and it begins where its yarn is rejoined, at the saddle; a tube whose front and back are to be shaped apart begins at its
// back, whichever loop it is dealt (contour_stage.cpp turns it). Where rounds begin in a written pattern is decided apart (knit/limbs/limb_markers.h).
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "knit/fabric/fabric.h"
#include "knit/mesh/mesh.h"
#include "knit/tubes/plan.h"

namespace knit {

struct ArcFound {
  std::int32_t first = 0, count = 0;  // of the loop's stitches, to child 1
  double cost = 0.0;
  std::int64_t tried = 0;  // arcs
};
ArcFound find_arc(std::span<const Stitch> loop, const std::array<const Ring*, 2>& children,
                  const glm::dvec3& saddle);

// Everything that the deal at an event needs; `event` of the plan, whose tubes below are all live.
struct DealAt {
  const Input& input;
  const TubePlan& plan;
  const Fabric& fabric;
  std::int32_t event = 0;
  double stitch_width = 0.1;
  bool from_pinch = false;  // the other child of a split begins at its arc's first stitch
};
Deal deal_split(const DealAt& at, const ArcFound& arc);
// Which of a join's two loops was worked last in this order; of a tube without rows those that it was dealt from.
std::size_t yarn_bringer(const TubePlan& plan, const std::vector<TubeId>& order, const TubeEvent& join);
Deal deal_join(const DealAt& at, std::size_t brings_yarn);
// The strip between the two tubes' first rows, or last ones: two loops that run against each other.
Deal deal_ring(const DealAt& at);

}  // namespace knit
