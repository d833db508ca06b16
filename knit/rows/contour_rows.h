// Stages 2 and 3 with contours: where the surface is cut, and how many stitches each cut carries.
//
// Cuts lie at equal steps of time, as many as rows of the stitch height fit into the height still to go. A
// row holds round(L / w) stitches, at least 3, at most twice and at least half the row below; where that limit
// binds, the counts of a few rows together come as near to L / w as they can. A cut shorter than three half
// stitches makes no row.
#pragma once

#include <variant>

#include "knit/mesh/mesh.h"
#include "knit/model/products.h"
#include "knit/model/settings.h"
#include "knit/rows/contour_events.h"
#include "knit/rows/frame.h"

namespace knit {

// A slip of the stitch size shall not fill the memory: beyond these a run stops.
inline constexpr std::int32_t most_contour_rows = 20000;
inline constexpr std::int32_t most_contour_stitches = 2000000;

// From `from_time` (0 for the whole surface) on. Stops with no_row_levels when no cut makes a row, with
// too_fine when there would be more than can be held.
std::variant<CutPlan, Stopped> plan_cuts(const Input& input, const Timing& timing, const RowsSettings& rows,
                                         const StitchSize& stitch, double from_time);

struct ChosenCount {
  std::int32_t count = 0;
  CountReason reason = CountReason::ideal;
  double ideal = 0.0;  // length / w
};
// For plan.cuts[cut], which must be a single loop; `below`: stitches of the row below, 0 for the first row.
ChosenCount choose_count(const CutPlan& plan, std::int32_t cut, std::int32_t below, const RowsSettings& rows,
                         const StitchSize& stitch);

}  // namespace knit
