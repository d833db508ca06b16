// The last step: what it did, its pseudo-code, what there is to see, and lists of rows, candidates, problems and
// breaks.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

// Inside the side panel.
void draw_step_side(PanelFrame& frame);

// No variable is pointed at any more, as the code is not to be seen.
void leave_variables(PanelFrame& frame);

}  // namespace app
