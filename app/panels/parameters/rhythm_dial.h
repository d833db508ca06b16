// Simplicity against the shape: a slider for the price of a rhythm and, beside it, what the plan makes of it: how long the
// pattern is, how far the circumference is off, and planned against ideal stitches row by row, with what is seen of their difference.
#pragma once

#include <cstdint>
#include <optional>

#include "app/explain/rhythm_figures.h"
#include "app/panels/kit/widgets.h"
#include "knit/model/settings_table.h"

namespace app {

// Of the run's pattern in its short form: `none` while the run is on its way, or has no such form.
struct PatternLength {
  std::size_t lines = 0, characters = 0;
};
class RhythmCache {
 public:
  void refresh(const knit::State& state);
  [[nodiscard]] const std::vector<RhythmFigures>& figures() const { return figures_; }
  [[nodiscard]] const std::optional<PatternLength>& length() const { return length_; }

 private:
  std::uint64_t key_ = 0;
  std::vector<RhythmFigures> figures_;
  std::optional<PatternLength> length_;
};

// The knob that has this slider.
bool is_rhythm_dial(const knit::ParameterInfo& info);
// As it is set, or as the plan was found with it.
double rhythm_dial_in_force(PanelFrame& frame);
// At the cursor, as wide as the panel. Changes `parameters` as a knob does; true while the slider is held.
bool draw_rhythm_dial(PanelFrame& frame, const knit::ParameterInfo& info, knit::Parameters& parameters);

}  // namespace app
