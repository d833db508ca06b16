// The empty state: what to do while nothing is open.
#pragma once

#include "app/panels/panels.h"

namespace app {

void draw_welcome(PanelFrame& frame);

}  // namespace app
