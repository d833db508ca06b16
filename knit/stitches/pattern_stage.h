// Stage 6, pattern, one smallest step at a time: a line a row, the cast on first, the bind off last. Thesis 3.2.5.
// What it takes and makes is counted here; the words are set from the same operations by knit/pattern.
#pragma once

#include <cstdint>
#include <tuple>

#include "knit/fabric/join.h"
#include "knit/model/event.h"
#include "knit/model/products.h"
#include "knit/stitches/pattern_events.h"

namespace knit {

struct PatternWork {
  [[nodiscard]] auto fields() const { return std::tuple<>(); }
  friend bool operator==(const PatternWork&, const PatternWork&) = default;
};

// Which line is written.
struct LineAt {
  RowId row;
  std::int32_t stitches;  // of the row
  const Join* into;       // the row; null: it is the cast on
  bool bind_off;          // the last line, after that of the last row
  bool last_row;
};
// `line`: the product.
Advanced<PatternEvent> advance_pattern(const LineAt& at, Shared<CountedLine>& line);

}  // namespace knit
