// What the panel of sweeps remembers: the form that a sweep is asked for with, and the points of its plots.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/compare/sweep_work.h"
#include "knit/model/settings_table.h"

namespace app {

enum class SweepFigure : std::uint8_t {
  problems,  // all of them; then those of one kind
  stalls,
  resampled,
  gaps_open,
  clamped,
  stitches,
  course_cv,
  wale_cv,
  rows,
  most_in_a_row,
  tubes,
  yarns,
  holders,
  left_out,
  uncovered  // percent
};
inline constexpr std::size_t sweep_figures = 15;
std::string_view name_of(SweepFigure figure);  // "Course CV"
std::string_view key_of(SweepFigure figure);   // "course-cv"

struct SweepForm {
  std::shared_ptr<const knit::Input> input;  // of the mesh that the axes' ranges were made for
  SweepAxis axis, second;
  bool grid = false;                           // the second one counts
  SweepFigure figure = SweepFigure::problems;  // of the heat map
  SweepFigure first = SweepFigure::problems;   // of the first of the three plots: all problems, or one kind
  SweepFigure third = SweepFigure::course_cv;  // of the last of the three plots
  std::optional<std::size_t> hovered;          // the run under the pointer in the last frame
  std::weak_ptr<const SweepWork> shown;  // the sweep whose plan was taken over, started here or by a script
};

// Around the present value, within what the parameter takes.
SweepAxis usual_axis(const knit::ParameterInfo& info, const knit::Parameters& parameters, int count);
// The value of a number or a count, and what stands for "auto"; none where the run itself finds it.
std::optional<double> present_value(const knit::ParameterInfo& info, const knit::Parameters& parameters);

// A count of problems: none is what one looks for.
inline bool counts_problems(SweepFigure figure) { return figure <= SweepFigure::clamped; }

int decimals_of(SweepFigure figure);

enum class SweepOutcome : std::uint8_t { pending, refused, stopped, finished };

// Of each run by its index; no value where it is not there yet, was refused, or has no such figure.
class SweepCache {
 public:
  using Values = std::vector<std::optional<double>>;
  void refresh(const std::shared_ptr<SweepWork>& work);
  [[nodiscard]] const Values& of(SweepFigure figure) const {
    return values_[static_cast<std::size_t>(figure)];
  }
  [[nodiscard]] double lowest(SweepFigure figure) const { return low_[static_cast<std::size_t>(figure)]; }
  [[nodiscard]] double highest(SweepFigure figure) const { return high_[static_cast<std::size_t>(figure)]; }
  [[nodiscard]] const std::vector<SweepOutcome>& outcomes() const { return outcomes_; }
  [[nodiscard]] std::size_t refused() const { return refused_; }
  [[nodiscard]] std::size_t stopped() const { return stopped_; }

 private:
  void read(std::size_t index, const SweepRun& run);

  std::shared_ptr<SweepWork> work_;
  std::size_t done_ = 0;
  std::vector<SweepOutcome> outcomes_;
  std::array<Values, sweep_figures> values_;
  std::array<double, sweep_figures> low_{}, high_{};
  std::size_t refused_ = 0, stopped_ = 0;
};

// Once all are known; requires a figure that counts problems. Narrowed down as soon as the work has done so: all problems and
// stalls.
std::optional<QuietStretch> quiet_stretch(const SweepWork& work, const SweepCache& cache, SweepFigure figure);
// "No stall from 0.0194 on, at 0.0185 not yet."
std::string words_of(const QuietStretch& quiet, SweepFigure figure);

}  // namespace app
