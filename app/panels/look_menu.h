// What the menus say about the program itself: how it looks, and what was opened lately.
#pragma once

#include "app/panels/panels.h"

namespace app {

void draw_recent_menu(PanelFrame& frame);  // inside the File menu
void draw_look_menus(PanelFrame& frame);   // inside the View menu

}  // namespace app
