// The current step as things to see: candidates, anchor and band, labels placed so far, faces made so far.
#pragma once

#include <span>

#include "app/scene/scene.h"
#include "app/session/session.h"
#include "knit/fabric/fabric.h"
#include "knit/run/state.h"

namespace app {

inline glm::vec3 place_on(const knit::KnittingPath& path, std::uint32_t number) {
  return glm::vec3(path.position(number));
}

// The first `count` faces, or column edges, of a strip.
FaceShape faces_of(const Theme& theme, const knit::Strip& strip, std::size_t count,
                   const knit::KnittingPath& path);
std::vector<Line> columns_of(const Theme& theme, const knit::Strip& strip, std::size_t count,
                             const knit::KnittingPath& path);

void describe_step(const Session& session, Scene& scene);

// The band on the surface: around an anchor, from w - epsilon to w + epsilon.

// Requires something open and the scene's mesh set.
Band band_around(const Session& session, knit::VertexId anchor, const knit::Parameters& parameters,
                 const Scene& scene);

// The vertex that the walk measures from at the place shown: the one a person is asked to guess for, else the last
// step's, though the walk may have taken the next by then; so the band is the one that the verdict fell by.
knit::VertexId anchor_shown(const Session& session, knit::VertexId of_walk);

}  // namespace app
