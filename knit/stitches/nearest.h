// Stage 4, placement `nearest`: each stitch of the larger row hangs on the stitch of the smaller row that makes
// the wale edges as short as can be.
//
// A monotone matching of two closed rows that begins at both first stitches and never crosses the beginning of
// the round: each cell of the larger row has one link, each stitch of the smaller row one or two; the first stitch
// has one, unless all have two, or the row was turned to what is below it. Of all such matchings the one with the least sum of squared wale lengths (plus
// penalties, if asked for) is found by dynamic programming over stitches and doublings. Labels follow from the
// links: a doubled stitch is shaping, leaning by the side on which the nearest main stands. Mains are wales: up to
// six, spread over the cast on and carried from row to row along the links.
//
// Mirrored rounds are worked mirrored, right for left, unless every stitch is doubled: nothing here prefers a side.
// Only where two matchings are equally short (see ties.h) does one count by rule: the one that doubles later; and where
// two places are equally near, the first.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "knit/fabric/join.h"
#include "knit/fabric/stitch.h"

namespace knit {

struct NearestRows {
  std::span<const Stitch> below, above;
  std::span<const std::int32_t> mains;         // stitches of the row below; none: it is the cast on
  std::span<const std::uint8_t> shaped_below;  // per stitch below: 1 where shaping made it; may be empty
  bool first_may_double = false;               // where the row was turned so that wales are shortest
};

// In squared mesh units.
struct NearestPenalties {
  double stacking = 0.0;    // for shaping on what shaping made in the row below
  double from_mains = 0.0;  // times the squared distance, in stitches, to the place beside the nearest main
};

// Requires ceil(below / 2) <= above <= 2 * below. `row` is the row made.
Join plan_nearest(const NearestRows& rows, const NearestPenalties& penalties, std::int32_t row);

// A round has so many at most. Where loops met there may be more: of those the ones that stand nearest to even places.
inline constexpr std::int32_t most_mains = 6;
std::vector<std::int32_t> thinned_mains(std::span<const std::int32_t> mains, std::int32_t size);

// Per stitch of the row that a join makes: 1 where its shaping took part.
std::vector<std::uint8_t> shaped_by(const Join& join);

}  // namespace knit
