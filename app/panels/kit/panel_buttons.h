// Small buttons that close panels and open them again.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

// Of a cross, with the gap before it.
float room_for_cross(const PanelFrame& frame);
// At the right end of the line where the cursor is, which stays there: the panel's first.
void draw_cross(PanelFrame& frame, Panel panel);

// In the menu bar: one for each panel, lit while it is there. Their width, with the gap before them.
float room_for_toggles(const PanelFrame& frame);
void draw_toggles(PanelFrame& frame);

// "Parameters"
const char* name_of(Panel panel);

}  // namespace app
