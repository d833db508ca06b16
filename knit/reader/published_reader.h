// Reads patterns with limbs as they are published, without headings that prove anything, on a needle and named holders.
//
// Understood beside rounds, cast ons and ends (pattern_reader.h) are
//   sections      "First leg", "Thumb:", "LEGS (make 2)"; in MATERIALS, NOTES and their like nothing is worked
//   labels        "Dividing rnd:", "Next rnd (dec):"; work without a label where a count or a holder proves it
//   holding       "place sts on a holder", "k8, place next 9 sts on waste yarn for thumb, CO 1 st over the gap, k to end"
//   taking        "k7, then k across held 7 sts of first leg", "return the thumb sts to the needles", "place 9 held sts on the needle"
//   waste yarn    "with waste yarn k5 for thumb, slip these 5 sts back to left needle and knit them again"
//   edges         "pick up and knit 2 sts in the gap", "CO 4 sts" within a round
//   repeats       "rep rnds 3-4 twice more", "work last 2 rnds until 8 sts remain", "k to marker", "decreasing 4 sts evenly"
//   twins         "work as for first leg"
//   two live ends "three-needle bind off", "graft", "kitchener": as many stitches on both
// Proved: every count that is stated, what each line takes against what is there, that holders and needle are empty in the end.
// Each line with a mistake is named once; the reading goes on (published_work.h). No graph is handed on: such words do not say
// where the beginning of a round goes. O(tokens and stitches).
#pragma once

#include <string_view>

#include "knit/reader/pattern_reader.h"

namespace knit {

// Whether stitches are put on a holder there and work goes on, or are taken off one.
bool has_held_stitches(std::string_view text);
ReadPattern read_published(std::string_view text);

}  // namespace knit
