// What a sweep's runs gave, against the value: a line, or a map of a grid. Each is one item at the cursor.
#pragma once

#include <imgui.h>
#include <optional>
#include <string>

#include "app/panels/kit/frame.h"
#include "app/panels/kit/sweep_cache.h"

namespace app {

struct SweepPlot {
  std::string name;  // of the item and its mark: "sweep/problems"
  SweepFigure figure = SweepFigure::problems;
  const SweepWork& work;
  const SweepCache& cache;
  std::optional<double> present, second_present;  // current values, of the first and the second parameter
  std::optional<std::size_t> lit;                 // the run pointed at in any plot
};

// Of a plot in a frame: the run under the pointer, and whether it was clicked.
struct SweepPointed {
  std::optional<std::size_t> run;
  bool clicked = false;
};
SweepPointed draw_sweep_line(PanelFrame& frame, const SweepPlot& plot, ImVec2 size);
// The first parameter runs to the right, the second one up.
SweepPointed draw_sweep_map(PanelFrame& frame, const SweepPlot& plot, ImVec2 size);

}  // namespace app
