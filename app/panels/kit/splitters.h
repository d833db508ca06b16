// The lines between the panels, which can be dragged.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

void draw_splitters(PanelFrame& frame);

}  // namespace app
