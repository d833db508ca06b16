// At which levels of a chart the full rounds stand: a stitch's height apart where the tube is nearest.
//
//   l_0 = 0;  l_(k+1) = the first level where the columns have advanced h' since l_k, all but the nearest 3 in 100
//   h' in [0.8 h, 1.25 h], by bisection so that the last round falls on the high rim
// Not the very nearest column: one bad one must not rule. Cost: some 30 x rounds x 8 passes over the
// columns.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "knit/short_rows/tube_chart.h"

namespace knit {

struct FullRounds {
  std::vector<double> levels;  // of the chart, rising from 0 to its last: one more than there are gaps
  double spacing = 0.0;        // h', on the near side
  double wanted = 0.0;         // h
  bool crowded = false;        // h' would have to be under 0.8 h: the near side leaves no room for a round
  [[nodiscard]] std::int32_t gaps() const { return static_cast<std::int32_t>(levels.size()) - 1; }
  [[nodiscard]] auto fields() const { return std::tie(levels, spacing, wanted, crowded); }
  friend bool operator==(const FullRounds&, const FullRounds&) = default;
};

// Two gaps at least.
FullRounds full_rounds(const TubeChart& chart, double stitch_height);

}  // namespace knit
