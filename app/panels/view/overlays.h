// What lies over the scene.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

// The empty state: what to do while nothing is open.
void draw_welcome(PanelFrame& frame);
// At the first start: one line that says what this is, and the first lesson.
void draw_first_start(PanelFrame& frame);
inline constexpr const char* first_lesson = "what-it-does";
// Why the run stopped where it is shown, and the ways on.
void draw_stop_card(PanelFrame& frame);
// A session from before a crash.
void draw_rescue(PanelFrame& frame);
// What would make a mesh fit that is not.
void draw_repair_offer(PanelFrame& frame);
// Whether stitches are shown as placed, as settled or in the air, where there are several.
void draw_positions(PanelFrame& frame);
// From mesh to yarn, once there are faces; within a window.
bool has_looking_dial(const PanelFrame& frame);
void draw_looking_dial(PanelFrame& frame);
// What the colours say, in the lower right corner: the time's ramp, or the labels once there are any. Inside the
// view's window.
void draw_view_legend(PanelFrame& frame);

}  // namespace app
