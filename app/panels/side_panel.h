// The right column, whichever of its sides is shown.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

void draw_side_panel(PanelFrame& frame);

}  // namespace app
