// A rhythm in sentences, for whoever knits it: what it is, what it costs in shape, how wide the piece comes out, and what
// comes nearer where no rhythm stays within the tolerance. What has no rhythm has no sentence.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "knit/rhythm/segments.h"
#include "knit/rhythm/tube_rhythm.h"

namespace knit {

// "8 increases every 2nd round 6 times, every 3rd round 3 times, then 8 decreases every round 4 times"; of more than six rhythms
// "9 rounds of 6 increases, 1 to 4 rounds apart, then ..."; empty: nothing shapes.
// With `halves` it says too which of them a change is for: "2 increases in front every round twice".
std::string segments_sentence(std::span<const RhythmSegment> segments, bool halves = false);

// `widest_ideal`: the stitches that the widest row holds; `stitches_in_10_cm`: of the gauge.
std::vector<std::string> rhythm_sentences(const TubeRhythm& rhythm, double widest_ideal,
                                          double stitches_in_10_cm);

}  // namespace knit
