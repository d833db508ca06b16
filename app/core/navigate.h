// Moving through a run by item, row or stage.
#pragma once

#include <cstddef>

#include "app/core/session.h"

namespace app {

// The position that a step of one unit leads to, working the run out as far as needed.
// Forward: past the rest of the current row (stage). Back: to its beginning, or that of the one before.
std::size_t position_after(knit::Timeline& timeline, Unit unit, int direction);

// The position just after the last step at or before `place`, working the run out until then.
std::size_t position_at(knit::Timeline& timeline, const knit::Place& place);

// Where a step of this unit forwards leads, when that can be said before it is worked out.
std::optional<knit::Place> place_ahead(const knit::Timeline& timeline, Unit unit);

}  // namespace app
