// The rhythm of a tube that begins on live stitches, as a deal left them.
//
// Two ways to begin are tried, and the better plan is taken as in rhythm_plan.h:
//   from the live stitches  their number is one of whole sections; the first round may be a repeat already
//   from the first round    it makes a number of whole sections of them, at most double and at least half; if that is another
//                           number than theirs, one that this round makes in one repeat is wanted (sections_to_begin); where
//                           there is none, it is shaped where the surface asks for it
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "knit/model/heard.h"
#include "knit/model/rhythm_settings.h"
#include "knit/rhythm/joint_plan.h"
#include "knit/rhythm/tube_rhythm.h"

namespace knit {

// With fewer there is nothing to repeat.
inline constexpr std::int32_t fewest_rows_in_rhythm = 3;

struct BeginsOn {
  std::int32_t live = 0;
  bool shared =
      false;  // twins may take the plan over: it begins with the first round, whatever they stand on
};
struct LiveRhythm {
  std::int32_t from = 0;  // -1: the first of the plan's counts is that of the live stitches
  RhythmPlan plan;
};
// Ideals: of the tube's rows. None: no number of sections fits.
std::optional<LiveRhythm> plan_rhythm_on(std::span<const double> ideals, const RhythmSettings& settings,
                                         const BeginsOn& on, const Heard& heard = {});
// The same with front and back halves apart (joint_plan.h). From the live stitches only if their number is even: both halves are.
// They are taken to part as the first row does, for no mains stand in them yet.
std::optional<LiveRhythm> plan_halves_on(const HalfIdeals& ideals, const RhythmSettings& settings,
                                         const BeginsOn& on, const Heard& heard = {});

// Whether one round makes the plan's first count of so many; of none it is cast on.
bool may_begin_on(const RhythmPlan& plan, std::int32_t live);

}  // namespace knit
