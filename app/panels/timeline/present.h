// What stands about the view while presenting (View::presenting).
#pragma once

#include <string>

#include "app/panels/kit/frame.h"

namespace app {

// "Row 7 of 64: 33 stitches"; before there are rows, the stage.
std::string row_and_count(const knit::Timeline& timeline);

void draw_large_caption(PanelFrame& frame);
void draw_thin_timeline(PanelFrame& frame);
void draw_ring(const PanelFrame& frame);

}  // namespace app
