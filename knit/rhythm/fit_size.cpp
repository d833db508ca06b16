#include "knit/rhythm/fit_size.h"

#include <utility>

namespace knit {

std::optional<SizeFit> fit_size(const std::vector<double>& ideals, RhythmSettings settings,
                                const Heard& heard) {
  constexpr double of_the_work = 0.35;  // at one size, of that at all
  const IdealsAt at = resized_ideals(ideals);
  settings.fit_size = FitSize::off;
  std::optional<RhythmPlan> asked = plan_rhythm(at, settings, {}, part_of(heard, 0.0, of_the_work));
  settings.fit_size = FitSize::on;
  std::optional<RhythmPlan> fitted = plan_rhythm(at, settings, {}, part_of(heard, of_the_work, 1.0));
  if (!asked || !fitted || fitted->size == 1.0) return std::nullopt;
  return SizeFit{*std::move(asked), *std::move(fitted)};
}

}  // namespace knit
