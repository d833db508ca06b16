// How far planned counts are from what the rows hold, as it is seen.
//
// A row that changes by k leaves its ideal by up to k / 2 at once; fabric spreads that. So what is seen of a deviation is
// its mean over six rows, the two at the ends with half their weight (the window by which a finished piece's radius is
// measured too), and it counts where there is something to see: against the row's own ideal where that is 24 stitches or more,
// against the widest row where it is 12 or more (half the widest, on a piece narrower than 24).
#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace knit {

// In % of what they are measured against.
struct SeenDeviation {
  double local = 0.0;  // the largest, of the row's own ideal
  double belt = 0.0;   // the largest, of the widest row's
  double rms = 0.0;    // root of the mean square, where and of what `local` is; of the widest row if nowhere
  std::int32_t row = 0;    // from 0, where the larger of the two is
  bool too_small = false;  // there: fewer stitches than the row holds
  [[nodiscard]] double worst() const { return local > belt ? local : belt; }
  [[nodiscard]] auto fields() const { return std::tie(local, belt, rms, row, too_small); }
  friend bool operator==(const SeenDeviation&, const SeenDeviation&) = default;
};

// Per row, in stitches. Both are of the same rows, at least one.
std::vector<double> seen_deviations(std::span<const std::int32_t> counts, std::span<const double> ideals);
SeenDeviation seen_deviation(std::span<const std::int32_t> counts, std::span<const double> ideals);

}  // namespace knit
