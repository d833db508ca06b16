// The order of pieces that is least trouble to knit.
//
// Cost = 4 x most holders at once + 10 x yarns + 2 x pieces between twins + 1.5 x holders entered elsewhere than at their first
// stitch + decreases across the marker + 0.3 x lines. The weights are taste.
// Search, without chance: from the fabric's own order, and from orders that go on with the yarn wherever they can, one for each
// way to choose among children at the first forks, blocks of pieces are moved and the first change for the better is taken,
// until there is none or enough were tried. Then limbs that one join takes are put in the order in which it takes them, odd
// ones first, if that costs no more.
// Each order tried: what it costs without its markers, O(tubes); where that is not dearer already than the order it changes,
// markers and layout, O(stitches of all loops + starts x deals x stitches).
#pragma once

#include <optional>
#include <vector>

#include "knit/order/limb_layout.h"

namespace knit {

struct OrderedLimbs {
  LimbRuns runs;
  LimbMarkers markers;
  LimbLayout layout;
  double cost = 0.0;
  std::int32_t tried = 0;  // orders
};

// Nothing where it cannot be worked.
std::optional<OrderedLimbs> in_order(const LimbTubes& tubes, const std::vector<std::int32_t>& order);

// The tubes with rows as the fabric has them, one after the other.
std::vector<std::int32_t> order_of_rows(const LimbTubes& tubes);

OrderedLimbs cheapest_order(const LimbTubes& tubes);

}  // namespace knit
