// The rhythm of a whole piece: of all numbers of sections, dials and sizes the plan that reads best within the tolerance.
//
//   score = lines + 0.3 max(0, changes without a rest - 2) + 0.04 shaping rounds + preference of k + (step sizes - 1)
//           + 0.15 |change of size in %|
// lines: 1 for a segment, 0.4 for a plain one of more than 3 rows; for a first round that changes the live stitches 1 where it is one
// repeat, else 4. If no plan is within the tolerance: the one with the least 1.5 x deviation in % + 0.3 score. What mirrors
// (ideals alike within 1 % of the widest from both ends) is planned by half.
// Large pieces (from some 50 cm on) are planned in small first, with rows and counts less by one factor, and only what comes out
// best there, one attempt for each dial, is planned at full size: all would take rows x widest row^2, 13 s for a ball of 200 cm.
// Segments: segment_search.h. Preferred: 4, 6, 8 and 12 changes, as published patterns have them.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "knit/model/heard.h"
#include "knit/model/rhythm_settings.h"
#include "knit/rhythm/segment_search.h"
#include "knit/rhythm/tube_rhythm.h"

namespace knit {

// What the rows hold, in stitches, if the piece is made `size` times as large. Positive, at least one row.
using IdealsAt = std::function<std::vector<double>(double size)>;
// Of what was measured at its own size: rows as far apart, so there are more or fewer of them, and straight lines between.
IdealsAt resized_ideals(std::vector<double> ideals);

// What a person may ask for; size is kept with a start after the first row. None: no number of sections fits what is asked.
std::optional<RhythmPlan> plan_rhythm(const IdealsAt& ideals, const RhythmSettings& settings,
                                      const RhythmStart& start = {}, const Heard& heard = {});
// What that takes at most, roughly: some hundredths of a second at 60 rows of 80 stitches, seconds at a thousand rows.
double microseconds_to_plan(double rows, double belt);

// The six dials that are tried, few rhythms first.
std::span<const double> rhythm_dials();
// The plan of one family at one dial: no choice but that of segments.
std::optional<RhythmPlan> plan_family(std::span<const double> ideals, const RhythmFamily& family, double dial,
                                      const RhythmStart& start = {}, const Heard& heard = {});

// What the plan's lines are worth, the less the better.
double rhythm_score(const RhythmPlan& plan, const RhythmStart& start);

// Whether the piece is alike from both ends.
bool is_mirrored(std::span<const double> ideals);

}  // namespace knit
