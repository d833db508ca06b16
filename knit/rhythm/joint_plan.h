// The rhythm of a body that is not round: front and back halves shaped apart, in one rhythm (joint_search.h).
//
// It is wanted where a quarter of some row holds more than 1.5 stitches more or fewer than a quarter of the row: an equal number
// in every section would make the front too tight and the back too wide. A limb that has fewer than 24 stitches everywhere is
// so narrow that stuffing rounds it, and reads better in one rhythm. Every dial is tried; of the
// plans whose whole circumference stays within the tolerance, or else of all, the one with the least 1.5 x deviation in % (the
// worst of the whole and the halves) + 0.3 score is taken. A piece
// has six ways to shape a round at most: with more, it is planned again with the six that shape most rounds.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "knit/model/heard.h"
#include "knit/model/rhythm_settings.h"
#include "knit/rhythm/segment_search.h"
#include "knit/rhythm/tube_rhythm.h"

namespace knit {

// What each row's halves hold, in stitches; mirrored in themselves.
struct HalfIdeals {
  std::vector<double> front, back;
};

inline constexpr std::size_t most_ways_to_shape = 6;
inline constexpr double narrowest_in_halves = 24.0;  // stitches of the widest row

// Halves are shaped in pairs, and by as many stitches as they need.
bool may_plan_jointly(const RhythmSettings& settings);
bool wants_joint_plan(const HalfIdeals& ideals, const RhythmSettings& settings);
// `start_front`: of start.count, where that is given; 0: any. None: nothing fits, as with an odd count.
std::optional<RhythmPlan> plan_joint(const HalfIdeals& ideals, const RhythmSettings& settings,
                                     const RhythmStart& start = {}, std::int32_t start_front = 0,
                                     const Heard& heard = {});
// Within the tolerance, then by shape and words together, as rhythm_plan.h weighs them; of the shape the worst counts, of the
// whole or of a half.
bool halves_read_better(const RhythmPlan& one, const RhythmPlan& other);

}  // namespace knit
