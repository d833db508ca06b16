// The step at hand as things to see: candidates, anchor and band, labels placed so far, faces made so far.
#pragma once

#include <span>

#include "app/scene/scene.h"
#include "app/session/session.h"
#include "knit/run/state.h"

namespace app {

// Where the stitches of two neighbouring rows are, by their numbers along the knitting path.
struct StripPlaces {
  std::uint32_t first = 0;  // of the row below
  std::span<const knit::Stitch> below, above;
  [[nodiscard]] glm::vec3 at(std::uint32_t number) const;
};
StripPlaces places_of(const knit::State& state, std::size_t strip);

// The first `count` faces, or column edges, of a strip.
FaceShape faces_of(const Theme& theme, const knit::Strip& strip, std::size_t count,
                   const StripPlaces& places);
std::vector<Line> columns_of(const Theme& theme, const knit::Strip& strip, std::size_t count,
                             const StripPlaces& places);

void describe_step(const Session& session, Scene& scene);

// The band on the surface: around an anchor, from w - epsilon to w + epsilon.

// Requires something open and the scene's mesh set.
Band band_around(const Session& session, knit::VertexId anchor, const knit::Parameters& parameters,
                 const Scene& scene);

// The vertex that the walk measures from at the place shown: the one a person is asked to guess for, else the last
// step's, though the walk may have taken the next by then; so the band is the one that the verdict fell by.
knit::VertexId anchor_shown(const Session& session, knit::VertexId of_walk);

}  // namespace app
