// The pattern: chart, written rounds, and knitting along.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

void draw_chart(PanelFrame& frame);       // in the view's place
void draw_knit_along(PanelFrame& frame);  // over the foot of either

}  // namespace app
