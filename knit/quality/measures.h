// Figures about a run: edge lengths, shaping, what is unusual. Pure functions of state and steps.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "knit/model/settings.h"
#include "knit/run/state.h"
#include "knit/run/step.h"

namespace knit {

struct LengthFigures {
  std::size_t count = 0;
  double mean = 0.0, cv = 0.0, low = 0.0, high = 0.0;  // cv: standard deviation / mean
};

LengthFigures figures_of(std::span<const double> lengths);
LengthFigures course_figures(const State& state);  // edges along rows, the closing ones too
LengthFigures wale_figures(const State& state);    // column edges

struct ShapingFigures {
  std::int32_t increases = 0, decreases = 0, max_in_a_row = 0;
};
ShapingFigures shaping_figures(const State& state);
RowId most_shaped_row(const State& state);  // the first that changes by `max_in_a_row`; 0: none changes

struct FaceCounts {
  std::size_t quads = 0, triangles = 0;
};
FaceCounts count_faces(const State& state);

// Vertices - edges + faces of the knit mesh as it stands: 0 for an open tube, finished.
std::int64_t euler_characteristic(const State& state);

// Worth a line in the list of problems: a stall, a jump repaired, a gap left open outside the band, a time
// clamped, a stop.
bool is_unusual(const Step& step, const Parameters& parameters);

}  // namespace knit
