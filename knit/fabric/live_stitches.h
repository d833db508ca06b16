// What hangs on a needle or a holder and is worked on next: stitches of one row or of several, in working order.
//
// Kept as stretches of rows, so that a state's copy stays cheap: a round is one stretch whatever its size.
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "knit/fabric/stitch.h"

namespace knit {

struct StitchSpan {
  RowId row = 1;
  std::int32_t first = 0, count = 0;
  [[nodiscard]] auto fields() const { return std::tie(row, first, count); }
  friend bool operator==(const StitchSpan&, const StitchSpan&) = default;
};

struct LiveStitches {
  std::vector<StitchSpan> spans;
  bool closed = true;  // the first stitch follows the last: a round
  [[nodiscard]] bool empty() const { return spans.empty(); }
  [[nodiscard]] std::int32_t size() const {
    std::int32_t count = 0;
    for (const StitchSpan& span : spans) count += span.count;
    return count;
  }
  // Requires 0 <= i < size().
  [[nodiscard]] StitchRef at(std::int32_t i) const {
    auto span = spans.begin();
    while (i >= span->count) i -= (span++)->count;
    return {span->row, span->first + i};
  }
  [[nodiscard]] auto fields() const { return std::tie(spans, closed); }
  friend bool operator==(const LiveStitches&, const LiveStitches&) = default;
};

}  // namespace knit
