#include "knit/rows/contour_rows.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "knit/model/ties.h"
#include "knit/rows/lasting_counts.h"

namespace knit {

namespace {

std::int32_t rounded_stitches(double ideal) {
  return static_cast<std::int32_t>(std::clamp(rounded(ideal), 3.0, 1e6));
}

// Looks a few rows ahead, because a row that holds a stitch more or fewer may let its neighbours hold theirs.
class CountSearch {
 public:
  explicit CountSearch(std::span<const double> ideals) : ideals_(ideals) {}

  struct Best {
    std::int32_t count = 0;
    double cost = 0.0;
  };
  // For a row above `below` stitches (0: any count is free).
  [[nodiscard]] Best best_for(std::size_t row, std::int32_t below, int depth) const {
    if (depth == 0 || row >= ideals_.size()) return {};
    Best best{0, std::numeric_limits<double>::infinity()};
    for (const std::int32_t wanted : candidates(row)) {
      const std::int32_t count = within_limits(wanted, below);
      const double cost = misfit_of(ideals_[row], count) + best_for(row + 1, count, depth - 1).cost;
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
    const std::int32_t here = rounded_stitches(ideals_[row]);
    const std::int32_t next = row + 1 < ideals_.size() ? rounded_stitches(ideals_[row + 1]) : here;
    return {here, here - 1, here + 1, 2 * next, (next + 1) / 2};
  }

  std::span<const double> ideals_;
};

CountReason reason_of(const ChosenCount& chosen, std::int32_t below) {
  const std::int32_t rounded = rounded_stitches(chosen.ideal);
  if (chosen.count == rounded) return chosen.ideal < 2.5 ? CountReason::at_least_three : CountReason::ideal;
  if (chosen.count < rounded && chosen.count == 2 * below) return CountReason::at_most_double;
  if (chosen.count > rounded && below > 0 && chosen.count == (below + 1) / 2)
    return CountReason::at_least_half;
  return CountReason::room_ahead;
}

// What the rows hold, where they have what lasts: as if they held just that.
std::vector<double> lasting_ideals(std::vector<double> ideals, std::span<const std::int32_t> lasting) {
  for (std::size_t row = 0; row < ideals.size(); ++row) {
    if (lasting[row] != nearest_count(ideals[row])) ideals[row] = lasting[row];
  }
  return ideals;
}

}  // namespace

ChosenCount choose_count(std::span<const double> lengths, std::size_t row, std::int32_t below,
                         double stitch_width, std::int32_t cast_on) {
  ChosenCount chosen;
  chosen.ideal = lengths[row] / stitch_width;
  if (below == 0 && cast_on > 0) return {cast_on, CountReason::as_cast_on, chosen.ideal};
  std::vector<double> ideals;
  for (const double length : lengths) ideals.push_back(length / stitch_width);
  const std::vector<std::int32_t> lasting = lasting_counts(ideals);
  constexpr int rows_ahead = 4;
  const std::vector<double> wanted = lasting_ideals(ideals, lasting);
  chosen.count = CountSearch(std::span(wanted).subspan(row)).best_for(0, below, rows_ahead).count;
  chosen.reason = reason_of(chosen, below);
  const bool lasts = chosen.count == lasting[row] && lasting[row] != nearest_count(ideals[row]);
  if (lasts && chosen.reason == CountReason::room_ahead) chosen.reason = CountReason::would_be_undone;
  const bool changes = below > 0 && chosen.count != below && chosen.count == lasting[row];
  if (changes && chosen.reason == CountReason::ideal && is_undone(lasting, row))
    chosen.reason = CountReason::undone;
  return chosen;
}

}  // namespace knit
