// Stage 4, stitch index: labels 0-6 that say where increases and decreases go around main stitches.
// Thesis 3.2.4.
//
// One label list a join; cells are those of the larger row, in working order. An increase is labelled
// in the new row, a decrease in the old one: the label sits on the stitch that appears or disappears.
//
// The rules, found from Appendix A (docs/algorithm.md gives the study). p -> n are the sizes, id = |n - p|,
// k = ceil(id / 2) mains are wanted, P mains stand in the row before:
//   from_cast_on (R0)   the row before is the cast on: a main for each of its stitches, shaping spread between
//   plain (R1)          n = p: the mains stay
//   equal (R2)          P divisible by k, P > k: every n / k cells, while they last (may give a main too many)
//   follow (R3)         P >= k: every (P / k)-th main of the row before, moved by the shaping placed before it
//   remainder_last (R4) P < k: every p / k + 2 cells, what is left over on the last spacing
//   dense               when sections lack room: a label after each main
//   nearest             (policy) in nearest.h, from where the stitches stand
//   repeat              (rhythm) in repeats.h, the same in every section
//   even                (policy) sections of the smaller row as equal as can be, plus their own shaping
#pragma once

#include <span>
#include <vector>

#include "knit/fabric/join.h"
#include "knit/model/settings.h"

namespace knit {

// The mains carried by a row, and whether it is the cast on (all 5, no mains).
struct RowBelow {
  std::int32_t size = 0;
  std::span<const std::int32_t> mains;
  bool is_cast_on = false;
};

std::int32_t mains_wanted(std::int32_t below, std::int32_t above);

// For the policies thesis and even. Requires ceil(below / 2) <= above <= 2 * below and below, above >= 1. `row` is the row made.
Join plan_join(const RowBelow& below, std::int32_t above, std::int32_t row, PlacementPolicy policy);

}  // namespace knit
