// The timeline: transport, units and speed, and the track.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

void draw_timeline(PanelFrame& frame);

}  // namespace app
