#include "knit/short_rows/chart_mirror.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "knit/model/ties.h"

namespace knit {

namespace {

constexpr double most_heights = 0.4, most_widths = 0.2;  // in stitch heights
constexpr double level_step = 8.0;                       // a row

// Of each column its height, of each cell its width, in stitch heights.
struct Level {
  std::vector<double> heights, widths;
};

Level level_of(const TubeChart& chart, double level, double stitch_height) {
  Level made{heights_at(chart, level), {}};
  for (double& height : made.heights) height /= stitch_height;
  for (std::int32_t c = 0; c < chart.columns; ++c)
    made.widths.push_back(glm::distance(point_at(chart, level, c), point_at(chart, level, c + 1)) /
                          stitch_height);
  return made;
}

struct Unlike {
  double heights = 0.0, widths = 0.0;
  [[nodiscard]] bool too_much() const { return heights > most_heights || widths > most_widths; }
  [[nodiscard]] double sum() const { return heights + widths; }
};

void compare(const Level& level, std::size_t m, Unlike& unlike) {
  const std::size_t count = level.heights.size();
  double ahead = 0.0, most = 0.0, least = 0.0;
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t other = (m + count - j) % count;
    unlike.heights = std::max(unlike.heights, std::abs(level.heights[j] - level.heights[other]));
    ahead += level.widths[j] - level.widths[(other + count - 1) % count];
    most = std::max(most, ahead);
    least = std::min(least, ahead);
  }
  unlike.widths = std::max(unlike.widths, 0.5 * (most - least));
}

}  // namespace

std::optional<std::int32_t> mirror_of(const TubeChart& chart, double stitch_height) {
  std::vector<Level> levels;  // the last first: there the sides differ most
  for (double level = chart.last_level(); level > 0.0; level -= level_step)
    levels.push_back(level_of(chart, level, stitch_height));
  levels.push_back(level_of(chart, 0.0, stitch_height));
  const auto count = static_cast<std::size_t>(chart.columns);
  std::optional<std::int32_t> best;
  double best_sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t m = i % 2 == 0 ? (count - i / 2) % count : (i + 1) / 2;  // 0, 1, -1, 2, -2 ...
    Unlike unlike;
    for (const Level& level : levels) {
      if (unlike.too_much()) break;
      compare(level, m, unlike);
    }
    if (unlike.too_much() || (best && !clearly_less(unlike.sum(), best_sum, 1.0))) continue;
    best = static_cast<std::int32_t>(m);
    best_sum = unlike.sum();
  }
  return best;
}

}  // namespace knit
