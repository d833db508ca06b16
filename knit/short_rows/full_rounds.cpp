#include "knit/short_rows/full_rounds.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "knit/model/ties.h"

namespace knit {

namespace {

constexpr double nearest_share = 0.03;  // of the columns, that may be nearer
constexpr double least_spacing = 0.8, greatest_spacing = 1.25;
constexpr int halvings_of_spacing = 30, most_steps = 40;
constexpr double level_precision = 1e-9;

// The rounds that a spacing gives: where they are, and how much of another one is left at the end.
struct March {
  std::vector<double> levels;
  double rest = 0.0;  // of a spacing
  [[nodiscard]] double rounds() const { return static_cast<double>(levels.size() - 1) + rest; }
};

class Marcher {
 public:
  explicit Marcher(const TubeChart& chart) : chart_(chart) {}

  March march(double spacing) {
    March march{{0.0}, 0.0};
    std::int32_t steps = 0;
    begin_at(0.0);
    while (true) {
      const double level = march.levels.back();
      // The level after which the next round stands, looked for where the last one was.
      const auto least = static_cast<std::int32_t>(std::floor(level)) + 1, most = chart_.levels() - 1;
      std::int32_t high = std::clamp(least + steps, least, most);
      while (high < most && advanced(high) < spacing) ++high;
      while (high > least && advanced(high - 1) >= spacing) --high;
      steps = high - least;
      if (advanced(high) < spacing) break;
      march.levels.push_back(between(std::max(level, high - 1.0), high, spacing));
      begin_at(march.levels.back());
      if (march.levels.back() >= chart_.last_level()) break;
    }
    march.rest = march.levels.back() < chart_.last_level() ? advanced(chart_.levels() - 1) / spacing : 0.0;
    return march;
  }

 private:
  void begin_at(double level) { from_ = heights_at(chart_, level); }

  // What the columns have advanced, all but the nearest.
  double advanced(std::int32_t level) {
    const auto count = static_cast<std::size_t>(chart_.columns);
    return advanced(std::span(chart_.heights).subspan(static_cast<std::size_t>(level) * count, count));
  }
  double advanced_to(double level) { return advanced(heights_at(chart_, level)); }
  double advanced(std::span<const double> heights) {
    const double rank = nearest_share * static_cast<double>(from_.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(rank));
    // The least so far, rising, one more than the rank: of most columns one look shows that they are not among them.
    least_.assign(below + 2, INFINITY);
    for (std::size_t j = 0; j < from_.size(); ++j) {
      const double advance = heights[j] - from_[j];
      if (!(advance < least_.back())) continue;
      std::size_t at = least_.size() - 1;
      for (; at > 0 && advance < least_[at - 1]; --at) least_[at] = least_[at - 1];
      least_[at] = advance;
    }
    return least_[below] + (rank - std::floor(rank)) * (least_[below + 1] - least_[below]);
  }

  // Regula falsi, the end that stays counting half (Illinois): between two levels of the chart every column rises straight,
  // so that a few steps do.
  double between(double low, double high, double spacing) {
    int side = 0;  // that moved last
    double off_low = advanced_to(low) - spacing, off_high = advanced_to(high) - spacing;
    for (int i = 0; i < most_steps && high - low > level_precision && off_high > 0.0; ++i) {
      const double level = low + (high - low) * off_low / (off_low - off_high);
      const double off = advanced_to(level) - spacing;
      if (std::abs(off) <= 1e-12 * spacing) return level;
      if (off < 0.0) {
        low = level;
        off_low = off;
        if (side < 0) off_high *= 0.5;
      } else {
        high = level;
        off_high = off;
        if (side > 0) off_low *= 0.5;
      }
      side = off < 0.0 ? -1 : 1;
    }
    return high;
  }

  const TubeChart& chart_;
  std::vector<double> from_, least_;
};

}  // namespace

FullRounds full_rounds(const TubeChart& chart, double stitch_height) {
  Marcher marcher(chart);
  const double plain = marcher.march(stitch_height).rounds();
  const double wanted = std::max(2.0, rounded(plain));
  double low = least_spacing * stitch_height, high = greatest_spacing * stitch_height;
  FullRounds rounds;
  rounds.wanted = stitch_height;
  rounds.crowded = marcher.march(low).rounds() < wanted;
  for (int i = 0; i < halvings_of_spacing; ++i) {
    const double middle = 0.5 * (low + high);
    (marcher.march(middle).rounds() > wanted ? low : high) = middle;
  }
  rounds.spacing = high;
  rounds.levels = marcher.march(high).levels;
  // The last one falls on the rim, whatever rounding and the limits of the spacing have left.
  while (static_cast<double>(rounds.levels.size()) > wanted) rounds.levels.pop_back();
  rounds.levels.push_back(chart.last_level());
  return rounds;
}

}  // namespace knit
