// Pairs of short rows: what is chosen, where it is placed, and what is told of it.
//
// A pair is two short rows worked between two turns, out and back: one on the right side, one on the wrong side. It stands
// in a gap, between a full round and the next. On the tube's chart it is an arc of columns [from, to]; on the needles it is
// the stitches first..last of the round below, the round's first stitch being 0. A pair over the beginning of the round has
// first < 0 <= last; any other stays inside the round, 1 <= first and last <= stitches - 2. Lags are in rows, gains and
// prices in stitches that lag one row more than they may. Gaps count from 0.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace knit {

struct PairSettings {
  double turn_cost = 5.0;  // of a pair, in stitches of lag 1 above the threshold
  double turn_step = 4.0;  // stitches that turns stay apart
  int shortest = 4;        // stitches of a short row
  friend bool operator==(const PairSettings&, const PairSettings&) = default;
};

// Chosen on the chart. `to` may be beyond the last column: the arc then runs over column 0.
struct PairArc {
  std::int32_t gap = 0;
  std::int32_t from = 0, to = 0;  // columns of the turns: 0 <= from < columns, from < to < from + columns
  double gain = 0.0;              // of squared lag, before the price
  double price = 0.0;             // of a pair here: what turns cost, and turns that are near
  double lag = 0.0;               // the greatest on the arc before it
  [[nodiscard]] auto fields() const { return std::tie(gap, from, to, gain, price, lag); }
  friend bool operator==(const PairArc&, const PairArc&) = default;
};

// Placed on stitches. Pairs of one gap stand in the order in which they are worked: those over the beginning of the
// round first, the widest last; then the others by their first stitch, of equal ones the shorter first.
struct PairPlan {
  std::int32_t gap = 0;
  std::int32_t first = 0, last = 0;  // of the round below, both included
  double gain = 0.0, price = 0.0, lag = 0.0;
  std::int32_t moved = 0;  // the farthest that a turn was moved, in stitches
  [[nodiscard]] std::int32_t stitches() const { return last - first + 1; }  // of each of its two rows
  [[nodiscard]] bool over_beginning() const { return first < 0; }
  [[nodiscard]] auto fields() const { return std::tie(gap, first, last, gain, price, lag, moved); }
  friend bool operator==(const PairPlan&, const PairPlan&) = default;
};

// Why a pair that was chosen is not worked.
enum class DropReason : std::uint8_t {
  no_plain_stitch,  // to turn at, within three stitches
  too_few,          // stitches: under three
  too_many          // it would leave under two stitches of the round
};

struct DroppedPair {
  std::int32_t gap = 0;
  std::int32_t first = 0, last = 0;  // where it was to be
  DropReason reason = DropReason::no_plain_stitch;
  [[nodiscard]] std::int32_t stitches() const { return last - first + 1; }
  [[nodiscard]] auto fields() const { return std::tie(gap, first, last, reason); }
  friend bool operator==(const DroppedPair&, const DroppedPair&) = default;
};

// "Row 12: a short row over 9 stitches was left out: no plain stitch to turn at within 3 stitches." Row: of the round below.
std::string sentence_of(const DroppedPair& dropped, std::int32_t row);

// Of all gaps of a tube, one after the other.
struct PairPlans {
  std::vector<PairPlan> pairs;
  std::vector<DroppedPair> dropped;
  [[nodiscard]] auto fields() const { return std::tie(pairs, dropped); }
  friend bool operator==(const PairPlans&, const PairPlans&) = default;
};

// --- small steps ------------------------------------------------------------------------------------------------------

// The lag at the end of a gap, before any pair of this gap.
struct LagMeasured {
  std::int32_t gap = 0;
  std::int32_t column = 0;  // with the greatest
  double greatest = 0.0, least = 0.0;
  friend bool operator==(const LagMeasured&, const LagMeasured&) = default;
};

// The best arc of a gap. Taken if its gain is more than its price; else the gap is done.
struct ArcConsidered {
  std::int32_t gap = 0;
  std::int32_t from = 0, to = 0;
  bool taken = false;
  double gain = 0.0, price = 0.0;
  friend bool operator==(const ArcConsidered&, const ArcConsidered&) = default;
};

}  // namespace knit
