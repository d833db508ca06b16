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
  // Of short rows, worked before the round or within it (passes.h); they leave both counts as they are.
  std::vector<ShortRowPair> pairs = {};
  friend bool operator==(const Round&, const Round&) = default;
};

struct Rounds {
  std::int32_t cast_on = 0;
  std::vector<Round> rounds;  // the second row on
  // At an open edge of the mesh: not drawn in, however few stitches there are.
  bool begins_open = false, ends_open = false;
  [[nodiscard]] std::int32_t last_count() const { return rounds.empty() ? cast_on : rounds.back().after; }
  // The same work.
  friend bool operator==(const Rounds& a, const Rounds& b) {
    return a.cast_on == b.cast_on && a.rounds == b.rounds;
  }
};

// Whether nothing is done in it but knit stitches.
bool knits_plain(const Round& round);

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
// What is worked between two turns, or between a turn and the beginning of the round, on stitches that the next round works
// once more. Each stitch hangs on the one that is on top of its column, and hands its own up.
struct GraphShortRow {
  std::int32_t row = 0;  // of `rows`, that it stands on: 0 is the cast on
  std::int32_t first =
      0;  // on which stitch of it, in working order; negative: before the beginning of the round
  std::int32_t stitches = 0;  // rising from there, on the wrong side falling
  bool wrong_side = false;
  std::int32_t worked = 0;  // so many stitches of the row above are there by then
  friend bool operator==(const GraphShortRow&, const GraphShortRow&) = default;
};
struct KnitGraph {
  // The cast on first: its stitches have nothing below. Above short rows a stitch is worked on what they left of its column,
  // and `first` still counts those of the row below.
  std::vector<std::vector<GraphStitch>> rows;
  std::vector<GraphShortRow> short_rows = {};  // in working order
  friend bool operator==(const KnitGraph&, const KnitGraph&) = default;
};

// Read off labels and links, without the operations: what a written pattern must lead back to. Of a single chain of rows.
KnitGraph graph_of(const State& state);

// Works the operations on live stitches. Requires that every round consumes exactly what is there, and that its short rows can
// be worked.
KnitGraph graph_of(const Rounds& rounds);

}  // namespace knit
