// Runs beside each other.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

// Inside the side panel.
void draw_compare(PanelFrame& frame);  // the pinned run beside the one at hand
void draw_sweep(PanelFrame& frame);    // many values of a parameter

}  // namespace app
