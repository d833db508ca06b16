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

// What a row's join is planned on. Of a round over short rows: what lies under them, one for one with what it takes.
struct JoinGround {
  LiveStitches from;          // what the row takes
  std::vector<Stitch> below;  // what is planned on
  BelowJoins joins;
  std::vector<std::int32_t>
      marked;  // places that turns left a mark on, rising; none while the row is not there
};
// The row may be the next one, not yet added.
JoinGround ground_of(const Fabric& fabric, const Row& row);

}  // namespace knit
