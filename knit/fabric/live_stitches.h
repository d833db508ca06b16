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

// Of a round: the stitches from `first` on, `count` of them, round and round.
struct LiveStitches;
LiveStitches stretch_of(const LiveStitches& live, std::int32_t first, std::int32_t count);

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
  // After what is there; a stretch that goes on with the last one is one with it.
  void append(const StitchSpan& span) {
    if (span.count == 0) return;
    StitchSpan* last = spans.empty() ? nullptr : &spans.back();
    if (last != nullptr && last->row == span.row && last->first + last->count == span.first) {
      last->count += span.count;
    } else {
      spans.push_back(span);
    }
  }
  void append(const LiveStitches& more) {
    for (const StitchSpan& span : more.spans) append(span);
  }
  [[nodiscard]] auto fields() const { return std::tie(spans, closed); }
  friend bool operator==(const LiveStitches&, const LiveStitches&) = default;
};

inline LiveStitches stretch_of(const LiveStitches& live, std::int32_t first, std::int32_t count) {
  LiveStitches stretch{{}, live.closed};
  std::int32_t skip = first, left = count;
  while (left > 0) {
    for (const StitchSpan& span : live.spans) {
      const std::int32_t skipped = skip < span.count ? skip : span.count;
      const std::int32_t taken = left < span.count - skipped ? left : span.count - skipped;
      stretch.append({span.row, span.first + skipped, taken});
      skip -= skipped;
      left -= taken;
    }
  }
  return stretch;
}

// An arc of a round, as a short row takes it.
inline LiveStitches arc_of(const LiveStitches& live, std::int32_t first, std::int32_t count) {
  LiveStitches arc = stretch_of(live, first, count);
  arc.closed = false;
  return arc;
}

// The place of a stitch among them; -1: it is none of them.
inline std::int32_t place_in(const LiveStitches& live, const StitchRef& ref) {
  std::int32_t place = 0;
  for (const StitchSpan& span : live.spans) {
    const std::int32_t i = ref.stitch - span.first;
    if (span.row == ref.row && i >= 0 && i < span.count) return place + i;
    place += span.count;
  }
  return -1;
}

// The same round, begun at its stitch `first`.
inline LiveStitches begun_at(const LiveStitches& live, std::int32_t first) {
  return stretch_of(live, first, live.size());
}

}  // namespace knit
