// Whether the step to come is one of short rows, and what they are worked by.
#pragma once

#include "knit/model/settings.h"
#include "knit/run/state.h"

namespace knit {

enum class ShortRowsDue : std::uint8_t {
  none,
  plan,  // the tube that was taken up
  gap    // before the round to come
};
ShortRowsDue short_rows_due(const Parameters& parameters, const State& state);

// Null: it was not planned.
const PlannedPairs* pairs_of(const State& state, TubeId tube);

// Rows that a tube keeps at its two ends.
KeptRows rows_kept(const TubePlan& plan, TubeId tube);

// The tube's last row that is not short; null: none.
const Row* last_round(const Fabric& fabric, TubeId tube);

// Whether the round to come begins where its curve does: on the column in the middle of the arcs.
bool begins_on_curve(const Parameters& parameters, const State& state, const ContourWork& work);

}  // namespace knit
