// A stitch, and the name it goes by.
#pragma once

#include <compare>
#include <cstdint>
#include <glm/vec3.hpp>
#include <tuple>

#include "knit/mesh/mesh.h"

namespace knit {

using TubeId = std::int32_t;

// Rows are numbered in working order over the whole piece, from 1 and without a gap: the number that people see
// and that Place::row has.
using RowId = std::int32_t;

struct Stitch {
  glm::dvec3 position{0.0};
  VertexId vertex = no_vertex;  // the mesh vertex it was picked at; no_vertex when placed by arc
  [[nodiscard]] auto fields() const { return std::tie(position, vertex); }
  friend bool operator==(const Stitch&, const Stitch&) = default;
};

// A stitch by its row and its place there, from 0 in working order.
struct StitchRef {
  RowId row = 1;
  std::int32_t stitch = 0;
  [[nodiscard]] auto fields() const { return std::tie(row, stitch); }
  friend auto operator<=>(const StitchRef&, const StitchRef&) = default;
};

}  // namespace knit
