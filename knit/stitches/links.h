// Stage 4, its last part: which stitch of the smaller row each cell of the larger row hangs on.
//
// A shaping label works together with a partner cell: away from its main (an M1R or SSK after a main with the
// cell after it, an M1L or K2tog before a main with the cell before it). Where a section has fewer free cells
// than labels, the label after the main works with the main and the other with the cell before it. Never
// across the beginning of the row. Guaranteed: every stitch has one or two links up and one or two down.
#pragma once

#include "knit/fabric/join.h"

namespace knit {

// Fills partner and link from labels, below and above.
void link_cells(Join& join);

// Fills link from labels and partner.
void link_by_partners(Join& join);

}  // namespace knit
