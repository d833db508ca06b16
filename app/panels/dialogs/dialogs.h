// The menus, the lesson, and what opens over the window.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

void draw_menu(PanelFrame& frame);
void draw_lesson(PanelFrame& frame);  // in the strip below the view
void draw_help(PanelFrame& frame);
void draw_glossary(PanelFrame& frame);
void draw_action_palette(PanelFrame& frame);
void draw_go_to(PanelFrame& frame);
void draw_open_dialog(PanelFrame& frame);
void draw_save_dialog(PanelFrame& frame);
void draw_figure_dialog(PanelFrame& frame);  // size, stretch and rate of what is saved
void draw_animation_progress(PanelFrame& frame);

// Opens the dialog that asks where to; the key is that of an export.
void ask_to_save(PanelFrame& frame, std::string_view key);

}  // namespace app
