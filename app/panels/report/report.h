// The report card: the run's figures.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

// Inside the side panel.
void draw_report_card(PanelFrame& frame);

}  // namespace app
