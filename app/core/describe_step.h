// The step at hand as things to see: candidates, anchor and band, labels placed so far, faces made so far.
#pragma once

#include <span>

#include "app/core/scene.h"
#include "app/core/session.h"

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

}  // namespace app
