// What counts as a problem, by kinds, and how many of each a run has met: one definition for the list of problems, comparing,
// sweeps, lessons and the report.
//
// A problem is what a step did, or the stop. Findings about the mesh and remarks on the finished piece are none: they are
// told beside it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <string_view>

#include "knit/run/step.h"

namespace knit {

// Worst first.
enum class ProblemKind : std::uint8_t {
  stopped,        // the run ends there
  left_out,       // a limb or a hole that is smaller than a round
  row_resampled,  // what was picked could not be knitted, or hardly
  gap_left_open,  // outside the band
  band_missed,    // a stitch far from where it should be
  time_clamped,
  no_short_row,  // a pair of short rows, or a tube's chart for them, that could not be had
  count_
};
inline constexpr std::size_t problem_kinds = static_cast<std::size_t>(ProblemKind::count_);

// "stalls": what scripts call it.
std::string_view key_of(ProblemKind kind);
// "Stalls": of a figure.
std::string_view name_of(ProblemKind kind);

class ProblemCounts {
 public:
  // Nothing where the step is none. A stop at a stall counts as a stall, so that they are all there.
  void take(const Step& step, const Parameters& parameters);
  [[nodiscard]] std::size_t of(ProblemKind kind) const { return of_[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] std::size_t total() const { return std::accumulate(of_.begin(), of_.end(), std::size_t{0}); }
  friend bool operator==(const ProblemCounts&, const ProblemCounts&) = default;

 private:
  std::array<std::size_t, problem_kinds> of_{};
};

// "2 stalls, 1 row resampled", worst first; empty: none.
std::string words_of(const ProblemCounts& counts);

}  // namespace knit
