// Stages 2 and 3 with contours: how many stitches a curve carries.
//
// A row holds round(L / w) stitches, or what lasts (lasting_counts); at least 3, at most twice and at least half of what it is
// worked on; where that limit binds, the counts of a few rows together come as near to that as they can.
#pragma once

#include <span>

#include "knit/model/settings.h"
#include "knit/rows/contour_events.h"

namespace knit {

struct ChosenCount {
  std::int32_t count = 0;
  CountReason reason = CountReason::ideal;
  double ideal = 0.0;  // length / w
};
// Of a row of a tube whose rows have these lengths. `below`: the stitches that it is worked on, 0: it is cast on. `cast_on`: what
// a person asked for there; 0: nothing.
ChosenCount choose_count(std::span<const double> lengths, std::size_t row, std::int32_t below,
                         double stitch_width, std::int32_t cast_on);

}  // namespace knit
