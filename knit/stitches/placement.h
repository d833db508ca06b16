// Stage 4, stitch index: the policies that say where main stitches, increases and decreases go, one row each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "knit/model/placement_policy.h"
#include "knit/stitches/nearest.h"
#include "knit/stitches/stitch_index.h"

namespace knit {

// What a policy plans one join from.
struct PlacementRows {
  RowBelow below;
  std::int32_t above = 0;  // stitches of the row made
  std::int32_t row = 0;    // its number
  // Empty where only sizes are known, for policies that do not look at places.
  std::span<const Stitch> stitches_below, stitches_above;
  std::span<const std::uint8_t> shaped_below;  // per stitch below: 1 where shaping made it
  NearestPenalties penalties = {};
};

struct Placement {
  PlacementPolicy policy;
  bool by_place;  // looks at where stitches stand: a list of sizes is not enough
  Join (*plan)(const PlacementRows& rows);
  // Whose pseudo-code tells of it: its own, or that of the policy that works alike.
  PlacementPolicy told_as;
};

// In the order of the enumerators.
std::span<const Placement> placements();
const Placement& placement_of(PlacementPolicy policy);

// All joins of a list of row sizes, the cast on first. Not for policies that go by place.
std::vector<Join> plan_joins(std::span<const std::int32_t> sizes, PlacementPolicy policy);

}  // namespace knit
