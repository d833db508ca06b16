// Which tubes' loops wait on holders while another tube is worked.
#pragma once

#include <vector>

#include "knit/run/state.h"

namespace knit {

// In the order in which their loops came there. Loops that nothing takes any more are bound off and do not wait; of two that
// a deal in progress takes, both still do. Empty: none, or no tube is being worked.
std::vector<TubeId> waiting_tubes(const State& state);

}  // namespace knit
