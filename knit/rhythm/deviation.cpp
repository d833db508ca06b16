#include "knit/rhythm/deviation.h"

#include <algorithm>
#include <cmath>

#include "knit/model/ties.h"

namespace knit {

std::vector<double> seen_deviations(std::span<const std::int32_t> counts, std::span<const double> ideals) {
  constexpr std::ptrdiff_t half = 3;
  const auto rows = static_cast<std::ptrdiff_t>(counts.size());
  const auto off = [&](std::ptrdiff_t row) {
    const auto at = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(row, 0, rows - 1));
    return counts[at] - ideals[at];
  };
  std::vector<double> seen;
  for (std::ptrdiff_t row = 0; row < rows; ++row) {
    double sum = (off(row - half) + off(row + half)) / 2.0;
    for (std::ptrdiff_t near = row - half + 1; near < row + half; ++near) sum += off(near);
    seen.push_back(sum / (2.0 * half));
  }
  return seen;
}

SeenDeviation seen_deviation(std::span<const std::int32_t> counts, std::span<const double> ideals) {
  constexpr double judged_alone = 24.0;
  constexpr double judged = 12.0;
  const double belt = *std::max_element(ideals.begin(), ideals.end());
  const std::vector<double> seen = seen_deviations(counts, ideals);
  SeenDeviation all;
  double squares = 0.0;
  double squares_alone = 0.0;
  std::int32_t alone = 0;
  const auto take = [&](double share, double& most, std::size_t row) {
    if (clearly_less(all.worst(), share, 1.0)) {
      all.row = static_cast<std::int32_t>(row);
      all.too_small = seen[row] < 0.0;
    }
    most = std::max(most, share);
  };
  for (std::size_t row = 0; row < seen.size(); ++row) {
    const double of_belt = 100.0 * std::abs(seen[row]) / belt;
    squares += of_belt * of_belt;
    if (ideals[row] >= std::min(judged, belt / 2.0)) take(of_belt, all.belt, row);
    if (ideals[row] < judged_alone) continue;
    const double of_row = 100.0 * std::abs(seen[row]) / ideals[row];
    squares_alone += of_row * of_row;
    ++alone;
    take(of_row, all.local, row);
  }
  all.rms =
      alone > 0 ? std::sqrt(squares_alone / alone) : std::sqrt(squares / static_cast<double>(seen.size()));
  return all;
}

}  // namespace knit
