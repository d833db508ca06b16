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
  // What comes before the first stitch has a step a vertex: positions up to `prelude` take this share of the width, and
  // all others the rest alike (app/actions/playing.h).
  std::size_t prelude = 0;
  double prelude_share = 0.0;

  [[nodiscard]] float x_of(std::size_t position) const {
    if (steps == 0) return left;
    const bool inside = position < prelude;
    const double from = inside ? 0.0 : prelude_share;
    const double part = inside ? prelude_share : 1.0 - prelude_share;
    const std::size_t begin = inside ? 0 : prelude;
    const std::size_t count = inside ? prelude : steps - std::min(steps, prelude);
    const double along =
        count == 0 ? 1.0 : static_cast<double>(position - begin) / static_cast<double>(count);
    return left + (right - left) * static_cast<float>(from + part * along);
  }
  [[nodiscard]] std::size_t position_at(float x) const {
    const double share = std::clamp(static_cast<double>((x - left) / (right - left)), 0.0, 1.0);
    if (share < prelude_share)
      return static_cast<std::size_t>(std::llround(share / prelude_share * static_cast<double>(prelude)));
    const std::size_t rest = steps - std::min(steps, prelude);
    const double along = prelude_share < 1.0 ? (share - prelude_share) / (1.0 - prelude_share) : 1.0;
    return prelude + static_cast<std::size_t>(std::llround(along * static_cast<double>(rest)));
  }
};

// Hits of break conditions, and the loop.
void draw_travel_marks(PanelFrame& frame, const Track& track);
// The round under the pointer, wherever it is.
void draw_pattern_marks(PanelFrame& frame, const Track& track);
// Of the step under the pointer, which is on the track.
void mean_round_under(PanelFrame& frame, const Track& track);

}  // namespace app
