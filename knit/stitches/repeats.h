// Stage 4 for counts that are a rhythm: a shaping round is one repeat, once in every section.
//
// A section is a main and the stitches up to the next one; m of them before the round. By style, growing and shrinking:
//   pairs    K1, m1l, K(m - 1), m1r         K1, ssk, K(m - 5), k2tog; of 4: ssk, k2tog
//            so that a main has m1r before it and m1l after it, k2tog and ssk, each the mirror image of the other. One change
//            a section: after the main and before the next in turn
//   lines    Km, m1l                        K(m - 2), k2tog
//   centre   half, m1r or m1l, half         half, ssk or k2tog, half; the odd stitch on either side in turn
//   stagger  as lines and centre in turn    alike
// Where front and back halves are shaped apart, in pairs: 2 more or fewer in a half stand at its own main, on both sides of it; 4 more
// or fewer at the side mains too, on the half's side of them. Each half is its own mirror image.
// Mains are wales: shaping works with the cell beside it that is none, where there is one, and never across a main.
#pragma once

#include <cstdint>

#include "knit/fabric/join.h"
#include "knit/model/rhythm_settings.h"

namespace knit {

struct RepeatedRound {
  std::int32_t below = 0, above = 0;  // stitches, in whole sections
  std::int32_t sections = 1;
  RhythmStyle style = RhythmStyle::pairs;
  std::int32_t turn = 0;  // shaping rounds before it
  std::int32_t row = 2;   // the row made
  // Stitches of the front half, where halves are shaped apart; then there are four mains, at the back, side, front and side.
  std::int32_t front_below = 0, front_above = 0;
};

// Requires that a section changes by at most two, doubles or halves at most, and keeps a stitch. `from` is left open.
Join plan_repeats(const RepeatedRound& round);

}  // namespace knit
