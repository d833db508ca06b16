// In which order tubes are worked: the one that is least trouble to knit, as the written pattern counts trouble
// (knit/order/limb_order.h).
//
// What an order costs hangs on where the yarn is when a loop is dealt, and so on every link of the stitches below it. So all rows
// are worked out once in the order of fewest holders, begun and linked as the settings say; the cheapest order is looked for
// among these stitches. Which loop a join begins on, and which side of a ring is cast on first, follows from the order; where that
// is another than before, rows are worked out once more, and the order is looked for again among those. Where each order makes
// the rows that another is cheapest on, the cheapest of them on its own rows is taken.
// So yarns and holders are just the pattern's, whatever is set. A setting that is changed midway finds the order made.
// Cost: the rows, their links and the search (limb_order.h), mostly once or twice, four times at most.
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
  const RowsSettings& rows;
  const StitchSettings& stitches;  // the placement chosen
};
// The plan with its tubes in that order, its yarns and holders as the pattern counts them. As it is where fewer than two tubes have
// rows, or no order can be worked.
TubePlan in_knitters_order(const UnorderedTubes& at, const TubePlan& plan);

// About what that takes, before anything is planned.
double microseconds_to_order(const TubeGraph& graph, const StitchSize& stitch);

}  // namespace knit
