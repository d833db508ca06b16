// Yarn that makes room for itself: where loops overlap they come apart, and the rest gives way. For a look from near; no physics.
//
// On places along the curves, two from each control point to the next; then control points are fitted to them. In an iteration every point moves 1.2 times as far as to
// the weighted mean of where it is pulled:
//   length    1      so that each piece between two points is as long as it was, half by each of its ends
//   bending   1/4    half way to the middle of its two neighbours
//   contact   2      so that points nearer than a diameter, and more than 3/4 of a stitch's width apart along their yarn, are a
//                    diameter apart, half by each
//   home      1/50   to where it was
// Pairs that may touch are looked for in a grid, anew every ten iterations. One thread, in the order of the yarn: the same bits.
// Points touch here, not the pieces between them, so that a loop may slip past another: a lifted bar in thirteen is, in the worst
// of five examples, no longer crossed as its stitch asks. More iterations do not mend that. Of the yarn that lay deeper than a
// quarter of its thickness in other yarn, 4.5 to 6.3 % of all in those, 0.8 to 1.3 % of all are left (yarn_curve_test).
// Cost of an iteration: points, and each tenth n log n. Mesh units.
#pragma once

#include "knit/yarn/yarn.h"

namespace knit {

inline constexpr int most_yarn_easing = 1000;

// `iterations` 0: as it is. Thirty are enough.
Yarn eased_yarn(Yarn yarn, double stitch_width, int iterations);

}  // namespace knit
