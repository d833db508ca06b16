// From an order and its markers to deals: what lies on the needle and on each holder, stitch by stitch, and the gaps numbered
// as they are cast on.
//
// Invariants: before a piece's first round the needle has what its first row is worked on, from the marker; every holder and
// every gap is used up in the end. O(stitches of all loops).
#pragma once

#include <optional>

#include "knit/order/limb_markers.h"
#include "knit/order/limb_pieces.h"

namespace knit {

struct LimbLayout {
  LimbPlan plan;             // deals and ends; no rounds yet
  std::int32_t offsets = 0;  // holders that are entered elsewhere than at their first stitch
};

// Nothing where a stretch that is held lies about the marker.
std::optional<LimbLayout> lay_out(const LimbTubes& tubes, const LimbRuns& runs, const LimbMarkers& markers);

// Adds the rounds of each piece, from the marker on, and how the last ones are grafted.
void add_rounds(const LimbTubes& tubes, const LimbRuns& runs, const LimbMarkers& markers, LimbPlan& plan);

}  // namespace knit
