// Where a sweep of one axis has no problem: the longest stretch of its values, and its ends narrowed down.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "knit/insight/problem_counts.h"

namespace app {

// The longest stretch of values whose runs finish and have none of what is counted.
struct QuietStretch {
  double from = 0.0, to = 0.0;
  bool from_first = false, to_last = false;
  std::optional<double> not_yet{},
      no_more{};  // the values tried before it and after it; none at an end of the axis
  friend bool operator==(const QuietStretch&, const QuietStretch&) = default;
};

// What has its ends narrowed down: all problems, then stalls alone.
inline constexpr std::array<std::optional<knit::ProblemKind>, 2> narrowed_kinds{
    std::nullopt, knit::ProblemKind::band_missed};
// As many digits as a number on screen has: what is read can be typed.
inline constexpr int quiet_digits = 5;

// Of rising values and as many answers. Of equally long stretches the last: larger values are the safer ones.
std::optional<QuietStretch> longest_quiet(const std::vector<double>& values, const std::vector<bool>& quiet);

// Halves the gap between each end and the value tried beyond it until no number of `quiet_digits` digits (no whole number) lies
// between. Invariant: an end is quiet and the value beyond it is not, whatever lies between other values. Runs: about
// log2(gap / last digit) an end, 7 to 10. `is_quiet` answers for one value; none: no longer wanted, it ends as it is.
void narrow_down(QuietStretch& stretch, bool whole,
                 const std::function<std::optional<bool>(double)>& is_quiet);

}  // namespace app
