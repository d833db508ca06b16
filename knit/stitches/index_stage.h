// Stage 4, stitch index, one smallest step at a time.
#pragma once

#include <cstdint>
#include <tuple>

#include "knit/fabric/join.h"
#include "knit/fabric/row.h"
#include "knit/model/event.h"
#include "knit/model/products.h"
#include "knit/stitches/index_events.h"

namespace knit {

enum class IndexPhase : std::uint8_t { count, space, place };
struct IndexWork {
  IndexPhase phase = IndexPhase::count;
  Shared<Join> plan;        // from `place` on
  std::int32_t placed = 0;  // of plan->placed
  [[nodiscard]] auto fields() const { return std::tie(phase, plan, placed); }
  friend bool operator==(const IndexWork&, const IndexWork&) = default;
};

// Where a join is planned.
struct JoinAt {
  RowId row;  // the one that it makes
  const Row& below;
  const LiveStitches& from;  // what it takes
  const Row* above;          // null: the cast on is the only row, and there is nothing to do
  const Join* before;        // into the row below; null: that is the cast on
  bool last;                 // no row follows
};
// `join`: the product, once it has ended; then `work` is that of the next one.
Advanced<IndexEvent> advance_index(const StitchSettings& settings, const StitchSize& stitch, const JoinAt& at,
                                   IndexWork& work, Shared<Join>& join);

}  // namespace knit
