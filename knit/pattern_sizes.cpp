#include <algorithm>
#include <cmath>
#include <numbers>

#include "knit/written_pattern.h"
#include "knit/yarn.h"

namespace knit {

namespace {

std::vector<std::int32_t> counts_of(const Rounds& rounds) {
  std::vector<std::int32_t> counts{rounds.cast_on};
  for (const Round& round : rounds.rounds) counts.push_back(round.after);
  return counts;
}

// Radii from end to end, with 0 for each end that is drawn in, and carried on beyond both ends by turning them
// about the end point: a smooth tip does so itself.
class Profile {
 public:
  Profile(const std::vector<std::int32_t>& counts, double stitches_per_cm) {
    if (is_drawn_in(counts.front())) radii_.push_back(0.0);
    for (const std::int32_t count : counts)
      radii_.push_back(count / stitches_per_cm / (2.0 * std::numbers::pi));
    if (is_drawn_in(counts.back())) radii_.push_back(0.0);
  }

  [[nodiscard]] double height(double step) const {
    double height = 0.0;
    for (std::ptrdiff_t i = 0; i + 1 < size(); ++i) {
      const double slope = std::min(std::abs(change_after(i)) / step, 1.0);
      height += step * std::sqrt(1.0 - slope * slope);
    }
    return height;
  }

 private:
  [[nodiscard]] std::ptrdiff_t size() const { return static_cast<std::ptrdiff_t>(radii_.size()); }
  [[nodiscard]] double radius(std::ptrdiff_t i) const {
    const std::ptrdiff_t last = size() - 1;
    if (i < 0) return 2.0 * radii_.front() - radius(std::min(-i, last));
    if (i > last) return 2.0 * radii_.back() - radius(std::max(2 * last - i, std::ptrdiff_t{0}));
    return radii_[static_cast<std::size_t>(i)];
  }
  // The straight line through six radii, three on each side.
  [[nodiscard]] double change_after(std::ptrdiff_t i) const {
    double products = 0.0;
    double squares = 0.0;
    for (std::ptrdiff_t k = 0; k < 3; ++k) {
      const double away = static_cast<double>(k) + 0.5;
      products += away * (radius(i + 1 + k) - radius(i - k));
      squares += 2.0 * away * away;
    }
    return products / squares;
  }

  std::vector<double> radii_;
};

}  // namespace

PatternSizes sizes_of(const Rounds& rounds, const Gauge& gauge) {
  const std::vector<std::int32_t> counts = counts_of(rounds);
  const double stitches_per_cm = gauge.stitches / 10.0;
  const double step = 10.0 / gauge.rounds;
  PatternSizes sizes;
  sizes.gauge = gauge;
  sizes.length_cm = static_cast<double>(counts.size()) * step;
  sizes.around_cm = *std::max_element(counts.begin(), counts.end()) / stitches_per_cm;
  sizes.height_cm = Profile(counts, stitches_per_cm).height(step);
  if (!is_drawn_in(counts.front())) sizes.height_cm += step / 2.0;
  if (!is_drawn_in(counts.back())) sizes.height_cm += step / 2.0;
  std::int64_t stitches = 0;
  for (const std::int32_t count : counts) stitches += count;
  const YarnNeeded yarn = yarn_needed(stitches, gauge);
  sizes.yarn_m = yarn.metres;
  sizes.yarn_with_spare_m = yarn.metres_with_spare;
  sizes.yarn_g = yarn.grams;
  sizes.weight_class = weight_class_of(gauge).number;
  return sizes;
}

std::vector<std::int32_t> stuffed_after(const Rounds& rounds) {
  if (!is_drawn_in(rounds.cast_on) || !is_drawn_in(rounds.last_count())) return {};
  constexpr double fewest = 12.0;
  const std::vector<std::int32_t> counts = counts_of(rounds);
  const double most = *std::max_element(counts.begin(), counts.end());
  const double wide = std::max(0.4 * most, fewest);
  const double neck = std::max(0.25 * most, fewest);
  std::vector<std::int32_t> after;
  bool narrowed = true;  // below a neck's width since the last wide round
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double count = counts[i];
    if (count >= wide) {
      const auto number = static_cast<std::int32_t>(i) + 1;
      if (narrowed) after.push_back(number);
      after.back() = number;
      narrowed = false;
    }
    narrowed = narrowed || count < neck;
  }
  return after;
}

}  // namespace knit
