#include "knit/insight/problems.h"

#include <algorithm>
#include <cmath>

namespace knit {

namespace {

// How many times larger the larger one is.
double ratio(std::int32_t a, std::int32_t b) {
  const auto [low, high] = std::minmax({std::max(a, 1), std::max(b, 1)});
  return static_cast<double>(high) / low;
}

}  // namespace

std::optional<Problem> problem_of(const Step& step, std::size_t index, const Parameters& parameters) {
  if (!is_unusual(step, parameters)) return std::nullopt;
  const double width = parameters.stitch.width;
  if (const auto* resampled = get_if<RowResampled>(step))
    return Problem{index, ProblemKind::row_resampled, ratio(resampled->from, resampled->to)};
  if (const auto* shared = get_if<GapShared>(step))
    return Problem{index, ProblemKind::gap_left_open, std::abs(shared->gap_after - width) / width};
  if (const auto* missed = get_if<BandMissed>(step))
    return Problem{index, ProblemKind::band_missed, std::abs(missed->distance - width) / width};
  if (is<VertexTimed>(step)) return Problem{index, ProblemKind::time_clamped, 0.0};
  return Problem{index, ProblemKind::stopped, 0.0};
}

void ProblemRanking::take(const Problem& problem) {
  by_kind_[static_cast<std::size_t>(problem.kind)].push_back(problem);
  ++size_;
  sorted_ = false;
}

void ProblemRanking::finish() {
  if (sorted_) return;
  for (auto& problems : by_kind_) {
    std::stable_sort(problems.begin(), problems.end(),
                     [](const Problem& a, const Problem& b) { return a.size > b.size; });
  }
  sorted_ = true;
}

const Problem& ProblemRanking::operator[](std::size_t i) const {
  std::size_t kind = 0;
  while (i >= by_kind_[kind].size()) i -= by_kind_[kind++].size();
  return by_kind_[kind][i];
}

}  // namespace knit
