// Stage 4, stitch index, one smallest step at a time.
#pragma once

#include <cstdint>
#include <tuple>

#include "knit/model/event.h"
#include "knit/model/products.h"
#include "knit/stitches/index_events.h"

namespace knit {

enum class IndexPhase : std::uint8_t { count, space, place };
struct IndexWork {
  IndexPhase phase = IndexPhase::count;
  Shared<Transition> plan;  // from `place` on
  std::int32_t placed = 0;  // of plan->placed
  [[nodiscard]] auto fields() const { return std::tie(phase, plan, placed); }
  friend bool operator==(const IndexWork&, const IndexWork&) = default;
};

// Where a transition is planned.
struct TransitionAt {
  std::int32_t row;  // the one that it makes
  const Row& below;
  const Row* above;          // null: the cast on is the only row, and there is nothing to do
  const Transition* before;  // into the row below; null: that is the cast on
  bool last;                 // no row follows
};
// `transition`: the product, once it has ended; then `work` is that of the next one.
Advanced<IndexEvent> advance_index(const Parameters& parameters, const TransitionAt& at, IndexWork& work,
                                   Shared<Transition>& transition);

}  // namespace knit
