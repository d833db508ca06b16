// Stage 2, cast on: the first cycle that can carry stitches, and the stitches spread along it. Thesis 3.2.2.
#pragma once

#include <variant>

#include "knit/mesh/mesh.h"
#include "knit/model/products.h"
#include "knit/model/settings.h"
#include "knit/model/stopped.h"

namespace knit {

struct FirstCycle {
  std::int32_t level = 0;
  std::int32_t last_level = 0;   // the last level that makes a row
  std::int32_t passed_over = 0;  // levels too short for three half stitches, at the start
  Ring ring;
};

// The first level after the start, and the last before the end, whose ring is at least 3 half stitch widths
// long. Stops with splits, not_a_ring or no_row_levels.
std::variant<FirstCycle, Stopped> find_first_cycle(const Input& input, const Timing& timing,
                                                   const RowsSettings& rows, const StitchSize& stitch);

}  // namespace knit
