// The timeline's track: from positions to the screen and back, and what is marked on it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "app/panels/kit/frame.h"

namespace app {

struct Track {
  float left, right;  // where positions 0 and `steps` are
  float top, bottom;  // of the coloured stretches
  std::size_t steps;

  [[nodiscard]] float x_of(std::size_t position) const {
    if (steps == 0) return left;
    return left +
           (right - left) * static_cast<float>(static_cast<double>(position) / static_cast<double>(steps));
  }
  [[nodiscard]] std::size_t position_at(float x) const {
    const double share = std::clamp(static_cast<double>((x - left) / (right - left)), 0.0, 1.0);
    return static_cast<std::size_t>(std::llround(share * static_cast<double>(steps)));
  }
};

// Hits of break conditions, and the loop.
void draw_travel_marks(PanelFrame& frame, const Track& track);
// The round under the pointer, wherever it is.
void draw_pattern_marks(PanelFrame& frame, const Track& track);
// Of the step under the pointer, which is on the track.
void mean_round_under(PanelFrame& frame, const Track& track);

}  // namespace app
