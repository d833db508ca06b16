// What there is to see of rows from contours, of isolines and of critical points.
#pragma once

#include <memory>

#include "app/scene/scene.h"
#include "app/session/session.h"
#include "knit/run/state.h"

namespace app {

// A closed polyline through a ring's points.
void add_loop(const knit::Ring& ring, Colour colour, float width_px, std::vector<Line>& lines);

// The row in the making.
void describe_contours(const Session& session, const knit::ContourWork& work, Scene& scene);

// Level sets at equal steps of time.
std::shared_ptr<const std::vector<Line>> isolines_of(const Theme& theme, const knit::Input& input,
                                                     const knit::Timing& timing);

// Minima, saddles and maxima; with their names while they are news or why the run stopped.
void describe_criticals(const Session& session, Scene& scene);

}  // namespace app
