// Where things of the knit mesh stand, finished or in the making.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "knit/insight/why.h"

namespace app {

// Of a row's stitches so far: finished, or kept in the making; of a bridge where the row is below 0. Empty: none.
std::vector<glm::dvec3> stitch_places(const knit::State& state, std::int32_t row);

// The stitches of rows, faces and column edges of strips as far as they are made.
struct MadeStrip {
  std::int32_t row = 2;  // the row above; below 0: a deal's, by its bridge's row
  std::span<const knit::Face> faces;
  std::span<const std::array<std::uint32_t, 2>> column_edges;
};
// Those of deals after those of rows, as far as they are sewn in.
std::vector<MadeStrip> made_strips(const knit::State& state);

// Whether a deal's faces are made: with the first strip above it; where none is above, once all strips are there.
bool is_sewn(const knit::Fabric& fabric, const knit::Deal& deal);
// What it sews together, as a strip that leads to no row.
knit::Strip strip_of(const knit::Deal& deal);
// The edges that a split or join adds: those of its bridge, and those that close the loops over it. A ring adds none: it
// has column edges. As many as edge_count.
std::vector<std::array<knit::StitchRef, 2>> edges_added(const knit::Deal& deal);

// A point, the two ends of an edge, the corners of a face; a label stands at its stitch of the larger row. Empty:
// it is not there.
std::vector<glm::dvec3> outline_of(const knit::Input& input, const knit::State& state,
                                   const knit::Element& thing);

}  // namespace app
