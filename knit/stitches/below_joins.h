// What the joins below a round say of the live stitches that it is worked on: which of them carry on mains, and which came of
// shaping. O(live stitches + the joins that made them).
#pragma once

#include <cstdint>
#include <vector>

#include "knit/fabric/fabric.h"

namespace knit {

// Of live stitches, one by one.
struct BelowJoins {
  std::vector<std::int32_t> mains;  // rising
  std::vector<std::uint8_t> shaped;
  bool cast_on = true;  // all of them
};
BelowJoins joins_below(const Fabric& fabric, const LiveStitches& live);

}  // namespace knit
