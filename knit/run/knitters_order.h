// In which order tubes are worked: the one that is least trouble to knit, as the written pattern counts trouble
// (knit/order/limb_order.h).
//
// What an order costs hangs on where the yarn is when a loop is dealt, and so on every link of the stitches below it. So all rows
// are worked out once in the order of fewest holders, and linked as placement `nearest` does; the cheapest order is looked for
// among these stitches. Which loop a join begins on, and which side of a ring is cast on first, follows from the order; where that
// is another than before, rows are worked out once more, and the order is looked for again among those.
// Only the mesh, its time and the stitch's size decide; where rounds begin, the cast on's count and the placement are left alone, so
// that changing them works no tube anew. With those as they are by default yarns and holders are just the pattern's; with others
// the holders are, and a yarn may have to be moved at a split more often.
// Cost: the rows, their links and the search (limb_order.h), once or twice.
#pragma once

#include "knit/mesh/mesh.h"
#include "knit/model/settings.h"
#include "knit/tubes/plan.h"

namespace knit {

struct UnorderedTubes {
  const Input& input;
  const Timing& timing;
  const TubeGraph& graph;
  const StitchSize& stitch;
};
// The plan with its tubes in that order, its yarns and holders as the pattern counts them. As it is where fewer than two tubes have
// rows, or no order can be worked.
TubePlan in_knitters_order(const UnorderedTubes& at, const TubePlan& plan);

// About what that takes, before anything is planned.
double microseconds_to_order(const TubeGraph& graph, const StitchSize& stitch);

}  // namespace knit
