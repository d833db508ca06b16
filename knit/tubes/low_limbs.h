// Limbs that are left out and so low that they are told together: a rough surface has hundreds. A hole is always told by itself.
#pragma once

#include <cstdint>

#include "knit/tubes/plan.h"

namespace knit {

inline constexpr double low_limb = 0.05;  // lower than so much of a round

bool is_low(const TubePlan& plan, const LeftOut& left_out);

struct LowLimbs {
  std::int32_t count = 0;
  const LeftOut* highest = nullptr;  // of the plan; null: there are none
  // Of the surface, at most: the sum of height x girth over its area, since a limb's curves are no longer than its girth.
  double share = 0.0;
};
LowLimbs low_limbs(const TubeGraph& graph, const TubePlan& plan);

}  // namespace knit
