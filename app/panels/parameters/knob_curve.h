// A knob that teaches: behind its field, what a sweep of it gave, and the value from which on there is no problem.
//
// The sweep is the session's own (as the side Sweep and `--sweep` have it): the button asks for one, workers beside the
// window do it, and what they have found is drawn as it comes. The button has its place whether or not anything is
// known, so nothing moves.
#pragma once

#include <optional>
#include <string>

#include "app/panels/kit/sweep_cache.h"
#include "app/panels/kit/widgets.h"

namespace app {

// The stitch's width and height, and epsilon.
bool has_curve(const knit::ParameterInfo& info);

// The longest stretch of values without a problem, once all are known.
struct QuietStretch {
  double from = 0.0, to = 0.0;
  bool from_first = false, to_last = false;
};
std::optional<QuietStretch> quiet_stretch(const SweepWork& work, const SweepCache& cache);
// "No problem from 0.0194 on."
std::string words_of(const QuietStretch& quiet);

// A square at the cursor: asks for the sweep, or ends it while it runs.
void draw_curve_button(PanelFrame& frame, const knit::ParameterInfo& info);
// Before the field, which will stand at the cursor: the mark that is clicked. Its value when it was.
std::optional<double> curve_mark(PanelFrame& frame, const knit::ParameterInfo& info, float width);
// Into the last item, the field.
void draw_curve(PanelFrame& frame, const knit::ParameterInfo& info);
// For the field's tip; empty while nothing is known.
std::string curve_words(PanelFrame& frame, const knit::ParameterInfo& info);

}  // namespace app
