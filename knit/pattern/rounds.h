// The pattern as work for hands: what is done to which stitches, round by round, and the graph that comes out.
//
// Taken from the label joins, never from the arrays of Appendix A. Operations stand in working order and
// never cross the beginning of a round. Rounds are numbered as rows are: 1 is the cast on.
#pragma once

#include <cstdint>
#include <vector>

#include "knit/fabric/fabric.h"
#include "knit/run/state.h"
#include "knit/stitches/operations.h"

namespace knit {

struct Round {
  std::int32_t number = 2;
  std::vector<Operation> operations;
  std::int32_t before = 0, after = 0;  // stitches
  friend bool operator==(const Round&, const Round&) = default;
};

struct Rounds {
  std::int32_t cast_on = 0;
  std::vector<Round> rounds;  // the second row on
  [[nodiscard]] std::int32_t last_count() const { return rounds.empty() ? cast_on : rounds.back().after; }
  friend bool operator==(const Rounds&, const Rounds&) = default;
};

// Of the joins that are there. Requires at least one row, and a single chain of them: else there are limbs (knit/limbs).
Rounds rounds_of(const State& state);

// One stitch and what it was worked from: stitches `first`, `first` + 1 ... of the row below, `count` of them.
// A stitch made from the bar between two has count 0; `first` then says how many stitches of the row below
// stand before the bar.
struct GraphStitch {
  Hand hand = Hand::knit;
  std::int32_t first = 0, count = 0;
  friend bool operator==(const GraphStitch&, const GraphStitch&) = default;
};
struct KnitGraph {
  std::vector<std::vector<GraphStitch>> rows;  // the cast on first: its stitches have nothing below
  friend bool operator==(const KnitGraph&, const KnitGraph&) = default;
};

// Read off labels and links, without the operations: what a written pattern must lead back to. Of a single chain of rows.
KnitGraph graph_of(const State& state);

// Works the operations on live stitches. Requires that every round consumes exactly what is there.
KnitGraph graph_of(const Rounds& rounds);

}  // namespace knit
