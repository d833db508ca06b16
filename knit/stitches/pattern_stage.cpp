#include "knit/stitches/pattern_stage.h"

#include <utility>

#include "knit/stitches/operations.h"

namespace knit {

namespace {

// Counted by its operations, not by the row's size, so that a line that does not add up shows.
CountedLine counted(const LineAt& at) {
  if (at.bind_off) return {at.row, at.stitches, 0};
  if (at.into == nullptr) return {at.row, 0, at.stitches};
  const OperationCount sum = count(operations_of(*at.into));
  return {at.row, sum.consumed, sum.produced};
}

}  // namespace

Advanced<PatternEvent> advance_pattern(const LineAt& at, Shared<CountedLine>& line) {
  const CountedLine written = counted(at);
  line = Shared(CountedLine(written));
  // The last row has one line more, which binds it off.
  return {LineWritten{written.consumed, written.produced}, at.bind_off   ? Ended::stage
                                                           : at.last_row ? Ended::step
                                                                         : Ended::row};
}

}  // namespace knit
