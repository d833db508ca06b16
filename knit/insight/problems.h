// Everything unusual in a run, worst first. Functions of steps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "knit/quality/measures.h"

namespace knit {

// Worst first.
enum class ProblemKind : std::uint8_t {
  stopped,        // the run ends there
  row_resampled,  // what was picked could not be knitted, or hardly
  gap_left_open,  // outside the band
  band_missed,    // a stitch far from where it should be
  time_clamped,
  count_
};

struct Problem {
  std::size_t step = 0;
  ProblemKind kind = ProblemKind::stopped;
  double size = 0.0;  // the larger, the worse among its kind
  friend bool operator==(const Problem&, const Problem&) = default;
};

// None exactly where is_unusual says so.
std::optional<Problem> problem_of(const Step& step, std::size_t index, const Parameters& parameters);

// Takes problems as a run grows. Worse kinds come first at any time; within a kind, the worst first once
// `finish` was called and the order of taking before, so that a growing run is never sorted again.
class ProblemRanking {
 public:
  void take(const Problem& problem);
  void finish();
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Problem& operator[](std::size_t i) const;

 private:
  std::array<std::vector<Problem>, static_cast<std::size_t>(ProblemKind::count_)> by_kind_;
  std::size_t size_ = 0;
  bool sorted_ = true;
};

}  // namespace knit
