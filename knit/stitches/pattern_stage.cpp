#include "knit/stitches/pattern_stage.h"

#include <utility>

#include "knit/stitches/pattern.h"

namespace knit {

Advanced<PatternEvent> advance_pattern(const LineAt& at, Shared<PatternLine>& line) {
  PatternLine written = at.bind_off          ? bind_off_line(at.row, at.stitches)
                        : at.into == nullptr ? cast_on_line(at.stitches)
                                             : round_line(*at.into);
  const LineWritten step{written.consumed, written.produced};
  line = Shared(std::move(written));
  // The last row has one line more, which binds it off.
  return {step, at.bind_off ? Ended::stage : at.last_row ? Ended::step : Ended::row};
}

}  // namespace knit
