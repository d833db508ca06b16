// The chart of the pattern: one row of squares a round, wales kept in columns by grey squares where there is no
// stitch.
//
// Rows go bottom to top, each is worked from right to left: column 0 is the right edge, where rounds begin. A
// square belongs to the round that works it: an increase stands in the round that makes it, a decrease in the
// round that takes two together.
#pragma once

#include <cstdint>
#include <vector>

#include "knit/rounds.h"

namespace knit {

enum class ChartSymbol : std::uint8_t { no_stitch, knit, m1r, m1l, k2tog, ssk, cast_on, bind_off };

struct ChartSquare {
  ChartSymbol symbol = ChartSymbol::no_stitch;
  bool main = false;         // of a main wale
  std::int32_t stitch = -1;  // of its row, from 0; -1: no stitch
  friend bool operator==(const ChartSquare&, const ChartSquare&) = default;
};
struct ChartRow {
  std::int32_t number = 1;    // of the round
  std::int32_t stitches = 0;  // on the needles afterwards
  std::vector<ChartSquare> squares;
  friend bool operator==(const ChartRow&, const ChartRow&) = default;
};
struct Chart {
  std::int32_t columns = 0;
  std::vector<ChartRow> rows;  // the cast on first
};

// Columns are chosen so that a stitch stands above the one it is worked from wherever it can, and main wales
// keep their column all the way.
Chart chart_of(const Rounds& rounds);

}  // namespace knit
