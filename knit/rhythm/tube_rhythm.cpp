#include "knit/rhythm/tube_rhythm.h"

#include <algorithm>

namespace knit {

std::int32_t TubeRhythm::turn(std::int32_t row) const {
  const auto end = plan.roles.begin() + (row - from);
  return static_cast<std::int32_t>(std::count(plan.roles.begin(), end, RowRole::change));
}

}  // namespace knit
