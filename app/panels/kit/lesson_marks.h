// Controls that a page of a lesson lights: brought into view once, and framed.
#pragma once

#include <string>

#include "app/panels/kit/frame.h"

namespace app {

// After an item: scrolls to it when the page opens that lights this control.
void bring_lit_into_view(PanelFrame& frame, const std::string& control);
// A glowing frame around each, where it stands in this frame.
void draw_lit_controls(PanelFrame& frame);

}  // namespace app
