#include "app/compare/sweep_quiet.h"

#include <algorithm>
#include <cmath>

#include "app/session/sweep.h"

namespace app {

std::optional<QuietStretch> longest_quiet(const std::vector<double>& values, const std::vector<bool>& quiet) {
  std::size_t best = 0;
  std::size_t begin = 0;
  std::size_t length = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    length = quiet[i] ? length + 1 : 0;
    if (length < std::max<std::size_t>(1, best)) continue;
    best = length;
    begin = i + 1 - length;
  }
  if (best == 0) return std::nullopt;
  const std::size_t end = begin + best;
  QuietStretch stretch{values[begin], values[end - 1], begin == 0, end == values.size()};
  if (!stretch.from_first) stretch.not_yet = values[begin - 1];
  if (!stretch.to_last) stretch.no_more = values[end];
  return stretch;
}

namespace {

// False: no longer wanted.
bool narrow_end(double& good, double& bad, bool whole,
                const std::function<std::optional<bool>(double)>& is_quiet) {
  for (;;) {
    const double half = 0.5 * (good + bad);
    const double middle = whole ? std::floor(half) : tidied(half, quiet_digits);
    if (middle <= std::min(good, bad) || middle >= std::max(good, bad)) return true;
    const auto quiet = is_quiet(middle);
    if (!quiet) return false;
    (*quiet ? good : bad) = middle;
  }
}

}  // namespace

void narrow_down(QuietStretch& stretch, bool whole,
                 const std::function<std::optional<bool>(double)>& is_quiet) {
  if (stretch.not_yet && !narrow_end(stretch.from, *stretch.not_yet, whole, is_quiet)) return;
  if (stretch.no_more) narrow_end(stretch.to, *stretch.no_more, whole, is_quiet);
}

}  // namespace app
