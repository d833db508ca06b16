// The list of segments with the least cost, for one number of sections: a dynamic programme over rows and counts.
//
//   J = sum over rows of weight_r (n_r - c_r)^2 + the prices of segments and changes,  weight_r = min(1, c_r / 12)
// c_r are the ideals (stitches that the row holds), n_r the counts, multiples of `sections` all of them; the few rows about a
// pole are drawn together and count less. State: (row, count, how the last segment ended). With S_n[b] the cost of rows
// before b at the count n, a stretch of rows a to b - 1 at one count costs S_n[b] - S_n[a], so a segment goes on from its
// last turn in constant time:
//   F(r + L, n, plain)    <- F(r, n, t) + S_n[r + 1 + L] - S_n[r + 1] + price        unless t is plain
//   F(r + pq, n + qd, .)  <- F(r, n, t) + the q turns, each at two counts + price    p <= 12, q <= 40
// A segment is given up where its count is far from the ideal: more than max(1.6 k, belt / 10) + 2.
// Cost: rows x counts x 4 x the segments that stay near; a plain one goes on row by row. Among equal costs
// (knit/model/ties.h: the same counts in other words) the first found: segments by where they begin, plain ones first, then + before -, by p, pre before
// post, by q.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "knit/model/heard.h"
#include "knit/rhythm/segments.h"

namespace knit {

// A round changes by j stitches in every section: `one`, `two` or either.
struct RhythmFamily {
  std::int32_t sections = 4;
  bool one = false, two = true;
  [[nodiscard]] std::int32_t changes() const { return sections * (two ? 2 : 1); }
  friend bool operator==(const RhythmFamily&, const RhythmFamily&) = default;
};

struct RhythmPrices {
  double rhythm = 0.0;    // of a segment that shapes
  double plain = 0.0;     // of one that does not
  double change = 0.0;    // of a row that changes
  double unrested = 0.0;  // more, for one right after another
  double single = 0.0;    // more, for a segment of one change a section where two may be
};
// `dial`: what a rhythm costs beside the shape. One unit is 1 % of the widest row, rms, over all rows.
RhythmPrices rhythm_prices(const RhythmFamily& family, double dial, std::span<const double> ideals);

// How the segment before ended.
enum class SegmentEnd : std::uint8_t { start, plain, changed, rested };

// Where a plan begins: at the first row with any count of at most max(12, 2.6 c), or `count` if it is not 0; or after a row
// that is made. On live stitches the first row may have any count that one round makes of them; another than theirs costs a
// rhythm more, and three more where that round is no repeat.
struct RhythmStart {
  std::int32_t row = 0;    // from 0
  std::int32_t count = 0;  // after row 0 it is needed
  SegmentEnd ended = SegmentEnd::start;
  std::int32_t live = 0;  // that row 0 is worked on with any count; 0: it is cast on
  friend bool operator==(const RhythmStart&, const RhythmStart&) = default;
};

struct SegmentTask {
  std::span<const double> ideals;
  RhythmFamily family;
  RhythmPrices prices;
  RhythmStart start = {};
  bool half = false;  // the opening half of a piece that mirrors: all costs twice, any count at its end
  std::int32_t last =
      0;  // the count of the last row; 0: any of at most max(12, 2.6 c), or any at all if there is none
  Heard heard = {};
};

struct FoundSegments {
  double cost = 0.0;
  std::int32_t first = 0;  // count of the row it begins with
  std::vector<RhythmSegment> segments;
};
// None: no list of segments leads from the start to the end.
std::optional<FoundSegments> find_segments(const SegmentTask& task);

// How many sections make `live` stitches `count` in one round that is one repeat, of any number of sections: each changes by one or,
// where pairs stand beside mains, by two if that is possible. A single change in the round is one section. 0: no number does.
std::int32_t sections_to_begin(std::int32_t live, std::int32_t count, bool in_pairs);

// Whether a round may change so: one repeat in every section, growing by one new stitch for each that is there at most,
// shrinking by pairs of stitches that are there.
bool may_change(std::int32_t section, std::int32_t change);

}  // namespace knit
