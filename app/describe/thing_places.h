// Where things of the knit mesh stand, finished or in the making.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "knit/insight/why.h"

namespace app {

// Of a row's stitches so far: finished, or kept in the making. Empty: none.
std::vector<glm::dvec3> stitch_places(const knit::State& state, std::int32_t row);

// The stitches of rows, faces and column edges of strips as far as they are made.
struct MadeStrip {
  std::int32_t row = 2;  // the row above
  std::span<const knit::Face> faces;
  std::span<const std::array<std::uint32_t, 2>> column_edges;
};
std::vector<MadeStrip> made_strips(const knit::State& state);

// A point, the two ends of an edge, the corners of a face; a label stands at its stitch of the larger row. Empty:
// it is not there.
std::vector<glm::dvec3> outline_of(const knit::Input& input, const knit::State& state,
                                   const knit::Element& thing);

}  // namespace app
