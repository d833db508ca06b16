// Reads patterns with limbs as they are published, without headings that prove anything: counts on a needle and on holders.
//
// Understood beside rounds, cast ons and ends (pattern_reader.h) are
//   sections      "First leg", "Thumb:", "LEGS (make 2)"
//   holding       "place sts on a holder", "k8, place next 9 sts on waste yarn for thumb, CO 1 st over the gap, k to end"
//   taking        "k7, then k across held 7 sts of first leg", "knit across the held sts", "place 9 held sts on the needle"
//   edges         "pick up and knit 2 sts", "CO 4 sts" within a round
//   twins         "work as for first leg"
//   two live ends "three-needle bind off", "graft", "kitchener": as many stitches on both
// Proved: every count that is stated, what each line takes against what is there, holders used up in the end. The first mistake
// ends the reading. No graph is handed on: such words do not say where the beginning of a round goes. O(tokens).
#pragma once

#include <string_view>

#include "knit/reader/pattern_reader.h"

namespace knit {

// Whether stitches are put on a holder there and taken again.
bool has_held_stitches(std::string_view text);
ReadPattern read_published(std::string_view text);

}  // namespace knit
