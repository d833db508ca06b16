// Stage 4, stitch index, one smallest step at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <tuple>

#include "knit/fabric/join.h"
#include "knit/fabric/row.h"
#include "knit/model/event.h"
#include "knit/model/products.h"
#include "knit/stitches/index_events.h"
#include "knit/stitches/repeats.h"

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
  RowId row;                                  // the one that it makes
  const LiveStitches& from;                   // what it takes
  std::span<const Stitch> below;              // the same as stitches
  std::span<const std::int32_t> mains;        // places among them, rising; none: nothing below is shaped yet
  std::span<const std::uint8_t> shaped;       // per stitch of them: 1 where shaping made it
  bool cast_on;                               // all of them were cast on
  const Row* above;                           // null: the cast on is the only row, and there is nothing to do
  bool follows;                               // its round begins where its wales are shortest
  std::optional<RepeatedRound> repeat;        // how a rhythm has it; none: by the placement
  bool last;                                  // no row follows
  std::span<const std::int32_t> marked = {};  // places below that turns left a mark on, rising
};
// A short row is planned one for one, whatever the placement. A round over short rows is planned on what lies under them: their
// stitches are those of `below`, `mains` and `shaped`, one for one with what it takes.
//
// The whole of it at once, as the placement that is set plans it; `from` is left to the caller. Requires a row above.
Join plan_row_join(const StitchSettings& settings, const StitchSize& stitch, const JoinAt& at);
// `join`: the product, once it has ended; then `work` is that of the next one.
Advanced<IndexEvent> advance_index(const StitchSettings& settings, const StitchSize& stitch, const JoinAt& at,
                                   IndexWork& work, Shared<Join>& join);

}  // namespace knit
