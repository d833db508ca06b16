// Another size for a whole piece, a little larger or smaller, at which its rhythm reads better.
//
// All counts are multiples of the sections, so the widest row seldom has just what it holds. Each family of rhythm_plan.h
// has a size at which it has; within 4 % those are tried beside the size asked for, and 1 % of size weighs 0.15 lines. The gauge stays
// as it is: the finished height moves. Two plans: twice what one takes.
#pragma once

#include <optional>
#include <vector>

#include "knit/model/heard.h"
#include "knit/model/rhythm_settings.h"
#include "knit/rhythm/rhythm_plan.h"

namespace knit {

struct SizeFit {
  RhythmPlan asked;   // at the size asked for
  RhythmPlan fitted;  // at `fitted.size` times that
};
// Of a piece of one tube, cast on as its length says; `ideals` of its rows at the size asked for. None: no number of sections
// fits, or no other size reads better.
std::optional<SizeFit> fit_size(const std::vector<double>& ideals, RhythmSettings settings,
                                const Heard& heard = {});

}  // namespace knit
