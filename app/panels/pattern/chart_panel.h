// A chart's squares on a draw list: shared by the chart and by the knit-along strip.
#pragma once

#include <imgui.h>

#include "knit/pattern/chart.h"

namespace app {

struct SquareLook {
  float side = 16.0f;
  bool lit = false;  // of the round at hand
  bool hovered = false;
};

// One square with its symbol; `low` is its upper left corner.
void draw_square(ImDrawList& list, ImVec2 low, const knit::ChartSquare& square, const SquareLook& look);

}  // namespace app
