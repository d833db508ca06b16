// Menus that live beside what they open.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

void draw_figure_menu(PanelFrame& frame);  // inside the File menu
void draw_lesson_menu(PanelFrame& frame);

}  // namespace app
