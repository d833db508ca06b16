// Counts of a tube on live stitches that has no rhythm: too few rounds, or stitches that no number of sections goes with. Each round
// is still one repeat where that costs little of the shape, so that none has to be counted out stitch by stitch.
//
//   J = sum over rounds of (n_r - c_r)^2 + 9 for a round that shapes and is no repeat (sections_to_begin)
// c_r are the ideals, n_0 the live stitches; n_r is nearest to c_r or at most max(2, c_r / 10) off it, three at least,
// at most double and at least half of n_(r-1). State: (round, count). Cost: rounds x counts within reach, squared.
// Ties: the smaller count.
#pragma once

#include <cstdint>
#include <span>

#include "knit/rhythm/tube_rhythm.h"

namespace knit {

// Of as many rounds as there are ideals, at least one, on at least one stitch. Its sections are 1, and it has no segments.
RhythmPlan plan_few_rounds(std::span<const double> ideals, std::int32_t live, bool in_pairs);

}  // namespace knit
