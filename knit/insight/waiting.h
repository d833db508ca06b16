// Which tubes' loops wait on holders while another tube is worked.
#pragma once

#include <vector>

#include "knit/run/state.h"

namespace knit {

// In the order in which their loops came there. Loops that nothing takes any more are bound off and do not wait; of two that
// a deal in progress takes, both still do. Empty: none, or no tube is being worked.
std::vector<TubeId> waiting_tubes(const State& state);

// The same with their stitches, at every step: in a stage after the rows, as it was when the row to come there was worked.
std::vector<LiveLoop> waiting_loops(const State& state);
// While this row is worked, of all that are made; requires has_row(row). Cost: the rows before it.
std::vector<LiveLoop> waiting_loops(const TubePlan& plan, const Fabric& fabric, RowId row);

}  // namespace knit
