// Where the timeline's track stands: from positions to the screen and back.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

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

}  // namespace app
