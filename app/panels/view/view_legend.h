// What the colours in the view say, in its lower right corner: the time's ramp, or the labels once there are any.
#pragma once

#include "app/panels/kit/panels.h"

namespace app {

// Inside the view's window.
void draw_view_legend(PanelFrame& frame);

}  // namespace app
