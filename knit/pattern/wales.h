// Wales of a pattern: chains of stitches worked one from another, and a column of the chart for each.
#pragma once

#include <cstdint>
#include <vector>

#include "knit/pattern/rounds.h"

namespace knit {

using Wale = std::int32_t;

// Wales are numbered in one order, in working order from the beginning of the round, that agrees with every
// row. A stitch goes on with the wale that it is worked from; an increase begins one; a decrease ends one and
// goes on with the other: with a main if one of the two is, else with the one that comes to lie on top.
struct Wales {
  std::vector<std::vector<Wale>> rows;  // of every stitch, the cast on first
  std::vector<Hand> hand;               // per wale: how it begins; knit: it is cast on
  std::vector<std::int32_t> begins;     // per wale: its first row, from 0
};

// Requires that every round consumes exactly what is there. `slips_back`, of each round: it begins with the last stitch of the
// round before, that a decrease takes together with the first; the first one's wale goes on. Empty: no round does.
Wales wales_of(const Rounds& rounds, const std::vector<std::uint8_t>& slips_back = {});

// One column for each wale for all its life, so that every row's wales stand in the row's order, in as few
// columns as that can be done with: wales that never meet share one, a row without either between them.
struct WaleColumns {
  std::vector<std::int32_t> of;  // per wale
  std::int32_t width = 0;
};
WaleColumns columns_of(const Wales& wales);

}  // namespace knit
