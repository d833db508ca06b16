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

// A square at the cursor: asks for the sweep, or ends it while it runs.
void draw_curve_button(PanelFrame& frame, const knit::ParameterInfo& info);
// Before the field, which will stand at the cursor: the marks where problems end, and stalls alone where that is elsewhere.
// The value of the one that was clicked.
std::optional<double> curve_marks(PanelFrame& frame, const knit::ParameterInfo& info, float width);
// Into the last item, the field.
void draw_curve(PanelFrame& frame, const knit::ParameterInfo& info);
// Whether the pointer is on what has a tip of its own: the square or a mark.
bool curve_is_pointed_at(const PanelFrame& frame, const knit::ParameterInfo& info);
// For the field's tip; empty while nothing is known.
std::string curve_words(PanelFrame& frame, const knit::ParameterInfo& info);

}  // namespace app
