#include "knit/rows/contour_rows.h"

#include <algorithm>
#include <array>
#include <limits>

#include "knit/model/ties.h"

namespace knit {

namespace {

std::int32_t rounded_stitches(double length, double stitch_width) {
  return static_cast<std::int32_t>(std::clamp(rounded(length / stitch_width), 3.0, 1e6));
}

// What a count costs: over its stitches, the squared share by which they come out too wide or too narrow.
double misfit(double length, std::int32_t count, double stitch_width) {
  const double off = length / (count * stitch_width) - 1.0;
  return count * off * off;
}

// Looks a few rows ahead, because a row that holds a stitch more or fewer may let its neighbours hold theirs.
class CountSearch {
 public:
  CountSearch(std::span<const double> lengths, double stitch_width)
      : lengths_(lengths), stitch_width_(stitch_width) {}

  struct Best {
    std::int32_t count = 0;
    double cost = 0.0;
  };
  // For a row above `below` stitches (0: any count is free).
  [[nodiscard]] Best best_for(std::size_t row, std::int32_t below, int depth) const {
    if (depth == 0 || row >= lengths_.size()) return {};
    Best best{0, std::numeric_limits<double>::infinity()};
    for (const std::int32_t wanted : candidates(row)) {
      const std::int32_t count = within_limits(wanted, below);
      const double cost =
          misfit(lengths_[row], count, stitch_width_) + best_for(row + 1, count, depth - 1).cost;
      if (clearly_less(cost, best.cost, 1.0)) best = {count, cost};
    }
    return best;
  }

 private:
  [[nodiscard]] static std::int32_t within_limits(std::int32_t count, std::int32_t below) {
    if (below == 0) return std::max(count, 3);
    return std::clamp(count, std::max(3, (below + 1) / 2), 2 * below);
  }
  // The rounded count first, so that it wins a tie.
  [[nodiscard]] std::array<std::int32_t, 5> candidates(std::size_t row) const {
    const std::int32_t here = rounded_stitches(lengths_[row], stitch_width_);
    const std::int32_t next =
        row + 1 < lengths_.size() ? rounded_stitches(lengths_[row + 1], stitch_width_) : here;
    return {here, here - 1, here + 1, 2 * next, (next + 1) / 2};
  }

  std::span<const double> lengths_;
  double stitch_width_;
};

}  // namespace

ChosenCount choose_count(std::span<const double> lengths, std::int32_t below, double stitch_width,
                         std::int32_t cast_on) {
  ChosenCount chosen;
  chosen.ideal = lengths.front() / stitch_width;
  if (below == 0 && cast_on > 0) return {cast_on, CountReason::as_cast_on, chosen.ideal};
  const std::int32_t rounded = rounded_stitches(lengths.front(), stitch_width);
  if (chosen.ideal < 2.5) chosen.reason = CountReason::at_least_three;
  constexpr int rows_ahead = 4;
  chosen.count = CountSearch(lengths, stitch_width).best_for(0, below, rows_ahead).count;
  if (chosen.count == rounded) return chosen;
  chosen.reason = CountReason::room_ahead;
  if (chosen.count < rounded && chosen.count == 2 * below) chosen.reason = CountReason::at_most_double;
  if (chosen.count > rounded && below > 0 && chosen.count == (below + 1) / 2)
    chosen.reason = CountReason::at_least_half;
  return chosen;
}

}  // namespace knit
