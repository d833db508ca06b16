// From arcs to stitches: which stitches of the round below a pair of short rows stands on.
//
// Of an arc [from, to] the stitches first..last that stand in it. Legal: the stitches before first, first, last and the one
// after last are plain, made and worked one to one by the next round; an arc that is not over the beginning of the round stays
// inside it; at least three stitches, at most all but two. Else it is moved, by 1, 2, then 3 stitches: wider at the
// beginning, at the end, at both; narrower at the beginning, at the end, at both. Else it is dropped. The mirror image of
// a place is tried alike: of two that are as good the one that stands more evenly over the arc is taken.
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
};

// Appends to `plans` the pairs of a gap in the order in which they are worked, and what was dropped.
void place_pairs(std::span<const PairArc> arcs_of_gap, const RoundBelow& round, PairPlans& plans);

}  // namespace knit
