// What the side of the step has for its neighbours.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

// No variable is pointed at any more, as the code is not to be seen.
void leave_variables(PanelFrame& frame);

}  // namespace app
