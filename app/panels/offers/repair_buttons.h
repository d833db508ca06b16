// Repairs of what the open mesh was only warned of, a button each; they open it again, repaired.
#pragma once

#include <string>

#include "app/panels/kit/frame.h"

namespace app {

// `mark`: what their names begin with. False: there is nothing to repair.
bool draw_repair_buttons(PanelFrame& frame, const std::string& mark);

}  // namespace app
