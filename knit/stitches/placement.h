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
  bool follows =
      false;  // the round begins where wales are shortest: its first stitch may be doubled like any
};

// What a plan fills: `to`, `below`, `above`; `labels`, one a cell of the larger side, |change()| of them shaping;
// `placed`, the mains and shaping in the order in which they are placed; `mains`, stitches of the row made; `rule`,
// which lights a line of the pseudo-code (that of `told_as`), with `spacing` and `remainder` by sections. By sections
// there are mains_wanted() mains. link_cells() then fills `partner` and `link`. `from` is set by the stage.
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
