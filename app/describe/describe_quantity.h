// The quantity that a step is about, drawn where it lives: a vertex's height along the axis with its time, the
// arc of the cast on, the closing gap along the ring with the band's edges, and how stitches share it.
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "app/session/session.h"
#include "knit/run/state.h"

namespace app {

// A bent line along a ring; at its middle `lift` beyond it, outward and ahead.
struct RingArc {
  double from = 0.0, to = 0.0;  // along the ring; to may lie beyond its length
  double lift = 0.0;
  glm::dvec3 ahead{0.0};  // the direction of knitting, of unit length
};
void add_arc(const knit::Ring& ring, const RingArc& arc, Colour colour, float width_px, Scene& scene);

// The closing gap of a row that has been closed, along its ring; nothing before.
std::optional<RingArc> gap_arc(const knit::State& state);

// Short lines across the ring where the band around the place `gap.from` begins and ends ahead of it.
void add_band_ticks(const knit::Ring& ring, const RingArc& gap, const knit::Band& band, Colour colour,
                    Scene& scene);

// Of the last step; each part belongs to one layer. Requires something open.
void describe_quantity(const Session& session, Scene& scene);

}  // namespace app
