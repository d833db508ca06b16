// The knitted thing as yarn: one curve through all loops in the order in which hands make them, a new one where a yarn begins.
//
// Each stitch is a loop [loop_shape.h] from its base, the head of what it is worked from, to its own head. So what hangs on what
// is in the frames alone, and the curve is pulled through as hands pull it:
//   k            base: its parent's head
//   k2tog, ssk   base: the mean of both parents' heads, 0.92 wide; the parents' heads go there too, the one on top (k2tog: the
//                second, ssk: the first) 0.6 r out, the other 1.4 r in
//   m1l, m1r     base: the middle of the two stitches beside the bar, 0.7 wide, 1.3 r in. The bar, the strand between them, is
//                lifted as a twisted loop; those two heads and what is worked from them move apart by 0.21 of a width, the next two
//                by half of that
//   cast on      base: its own frame, a wale below; the loop is twisted
//   bridge       half a loop high, used from above and from below
// After the last row: up to 12 live stitches are drawn together by a strand through them; more are bound off in a chain, each loop
// out of a stitch and out of the loop before. Live stitches of two tubes that face each other are grafted by a row of loops.
//
// Not drawn as hands do it, and counted: an increase where no single strand lies between the two stitches (beside a deal, or
// lifted already) is a half hitch; where the yarn would run far to its next stitch it is cut. How a turn of short rows closes its
// gap (a wrap, a double stitch) is not drawn: the yarn goes up to the next row there. Ends are not woven in.
// Cost: 12 points a stitch, no solver. Mesh units.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "knit/fabric/fabric.h"
#include "knit/model/settings.h"
#include "knit/yarn/yarn_curve.h"

namespace knit {

// A stitch is four yarns wide: neighbouring heads just touch.
inline constexpr double radius_of_width = 0.125;

struct YarnCounts {
  std::int32_t bars = 0;                               // lifted for increases
  std::int32_t half_hitches = 0;                       // increases without a bar
  std::int32_t cuts = 0;                               // the yarn begins anew although hands would go on
  std::int32_t turns = 0;                              // of short rows
  std::int32_t bound_off = 0, drawn = 0, grafted = 0;  // stitches
  friend bool operator==(const YarnCounts&, const YarnCounts&) = default;
};

struct Yarn {
  std::vector<YarnCurve> curves;  // in working order
  YarnCounts counts;
  friend bool operator==(const Yarn&, const Yarn&) = default;
};

// Requires a fabric with faces, and positions by number along the knitting path. `radius` 0: an eighth of a stitch's width.
Yarn make_yarn(const Fabric& fabric, std::span<const glm::dvec3> positions, const StitchSize& stitch,
               double radius = 0.0);

}  // namespace knit
