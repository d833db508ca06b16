// From arcs to stitches: which stitches of the round below a pair of short rows stands on.
//
// Of an arc [from, to] the stitches first..last that stand in it. Legal: the stitches before first, first, last and the one
// after last are plain, made and worked one to one by the next round; first < 0 < last over the beginning of the round, or
// 2 <= first and last <= stitches - 2 inside it, which is the same on both sides of stitch 0, so that a mirrored round gets
// the mirrored places; at least three stitches, at most all but two. Else it is moved, by 1, 2, then 3 stitches: wider at
// its beginning, at its end, at both; narrower at its beginning, at its end, at both. Else it is dropped.
// On a tube that is its own mirror image an arc whose middle is where the round begins, or opposite, gets as many stitches on
// both sides: a stitch and its image count at the mean of their columns, for rounding and triangles put them a hair apart. It is
// moved at both ends before it is moved at one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "knit/short_rows/pair_plan.h"

namespace knit {

// The round below a gap, from its beginning on.
struct RoundBelow {
  std::vector<double>
      columns;  // of its stitches, rising, from the column where the round begins; less than a turn
  std::vector<std::uint8_t> plain;  // whether the next round works the stitch one to one
  std::int32_t chart_columns = 0;
  bool mirrored = false;  // the tube is its own mirror image
};

// Appends to `plans` the pairs of a gap in the order in which they are worked, and what was dropped.
void place_pairs(std::span<const PairArc> arcs_of_gap, const RoundBelow& round, PairPlans& plans);

}  // namespace knit
