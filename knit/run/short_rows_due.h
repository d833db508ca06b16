// Whether the step to come is one of short rows, and what they are worked by.
#pragma once

#include "knit/model/settings.h"
#include "knit/run/state.h"

namespace knit {

enum class ShortRowsDue : std::uint8_t {
  none,
  choice,  // whether there shall be any, before all rows
  plan,    // the tube that was taken up
  gap      // before the round to come
};
ShortRowsDue short_rows_due(const Parameters& parameters, const State& state);

// Null: it was not planned.
const PlannedPairs* pairs_of(const State& state, TubeId tube);

// Rows that a tube keeps at its two ends: `beside` at an event, because near a saddle a level has a corner, where lag is
// partly a phantom; none at a cast on or a bind off; and those that are too short to be a round.
KeptRows rows_kept(const TubePlan& plan, TubeId id, std::int32_t beside);

// Whether it has rows enough between those.
bool can_be_charted(const TubePlan& plan, TubeId id, std::int32_t beside);

ChosenFor to_choose_for(const Parameters& parameters);

// As asked for, or as chosen: before the first row for this stitch at these prices, then whatever the stitch is; no_short_rows: there
// are none.
std::int32_t rows_beside_events(const Parameters& parameters, const State& state);

// Whether the tube's rounds begin in the middle of its arcs: it stands on nothing, and nobody said otherwise.
bool begins_in_middle(const Parameters& parameters, const TubePlan& plan, TubeId tube, const KeptRows& kept);

// The tube's last row that is not short; null: none.
const Row* last_round(const Fabric& fabric, TubeId tube);

// Whether the round to come begins where its curve does: on the column in the middle of the arcs.
bool begins_on_curve(const Parameters& parameters, const State& state, const ContourWork& work);

}  // namespace knit
