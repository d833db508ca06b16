// Whether a tube is its own mirror image, told by its chart: it then gets pairs of short rows that are mirror images too.
//
//   m        columns j and m - j lie opposite each other; cells, between a column and the next, c and m - 1 - c
//   heights  max over levels and columns of |Y[j] - Y[m - j]|
//   widths   max over levels of how far one side is ahead of the other, summed up round the tube
// The m of the least sum of both is taken, if they are under 0.4 and 0.2 stitch heights; of equal ones the m nearest to column 0,
// where rounds begin. Triangles that lie one way make a mirrored body's chart differ by some 0.03 of both, and a mirror that
// runs between two columns by as much as a quarter column lags, 0.3 at most. A tube 15 % wider on one side differs by
// 0.3 in its widths. Cost: columns^2 x rounds.
#pragma once

#include <cstdint>
#include <optional>

#include "knit/short_rows/tube_chart.h"

namespace knit {

// m, from 0 to columns - 1; none where one side is another shape.
std::optional<std::int32_t> mirror_of(const TubeChart& chart, double stitch_height);

}  // namespace knit
