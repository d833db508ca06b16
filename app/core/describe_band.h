// The band on the surface: around an anchor, from w - epsilon to w + epsilon.
#pragma once

#include "app/core/scene.h"
#include "app/core/session.h"

namespace app {

// Requires something open and the scene's mesh set.
Band band_around(const Session& session, knit::VertexId anchor, const knit::Parameters& parameters,
                 const Scene& scene);

// The vertex that the walk measures from at the place shown: the one a person is asked to guess for, else the last
// step's, though the walk may have taken the next by then; so the band is the one that the verdict fell by.
knit::VertexId anchor_shown(const Session& session, knit::VertexId of_walk);

}  // namespace app
