// The edges around each vertex of an intrinsic net.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "knit/intrinsic.h"

namespace knit {

struct Spoke {
  VertexId end;  // the vertex itself, where an edge leads back
  double length;
};

// Those of vertex v are spokes[first[v] .. first[v + 1]); every edge is one at each of its ends.
struct Spokes {
  std::vector<std::uint32_t> first;
  std::vector<Spoke> spokes;
  [[nodiscard]] std::span<const Spoke> at(VertexId v) const {
    return std::span(spokes).subspan(first[v], first[v + 1] - first[v]);
  }
};
Spokes spokes_of(const IntrinsicMesh& intrinsic, std::size_t vertex_count);

// The way along edges to the vertex farthest from `start`: no less than the way straight over the surface.
double reach_along_edges(const Spokes& spokes, VertexId start);

}  // namespace knit
