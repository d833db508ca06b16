// The empty state: what to do while nothing is open.
#pragma once

#include "app/panels/kit/panels.h"

namespace app {

void draw_welcome(PanelFrame& frame);

}  // namespace app
