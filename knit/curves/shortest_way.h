// Shortest ways over a surface, by Dijkstra's method on its vertices and 4 points of every edge; within a triangle every
// two of them are joined by a straight piece. Along a crease (an edge sharper than 40 degrees) a way costs half, so
// that it keeps to rims. Longer than the exact way by a few per cent at most: a line for the eye, not a ruler (that is
// knit/mesh/surface_distance.h).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "knit/curves/embed.h"
#include "knit/mesh/mesh.h"

namespace knit {

class ShortestWays {
 public:
  static constexpr std::uint32_t per_edge = 4;
  // `creases`: what a way along a crease costs, 1 for no rule. The mesh must be sewn and outlive this.
  explicit ShortestWays(const Mesh& mesh, double creases = 0.5);

  // From vertex to vertex, both included; empty if they are on different pieces.
  [[nodiscard]] std::vector<EdgePlace> way(VertexId from, VertexId to) const;
  // Per vertex the distance from the nearest of `sources`; infinite on other pieces.
  [[nodiscard]] std::vector<double> distances(std::span<const VertexId> sources) const;

 private:
  using Node = std::uint32_t;  // a vertex, or vertices + per_edge * edge + which point of it
  static constexpr Node no_node = UINT32_MAX;
  static constexpr std::size_t per_triangle = 3 + 3 * per_edge;
  struct Found {
    std::vector<double> length;
    std::vector<Node> before;
  };
  void measure_creases(double creases);
  [[nodiscard]] Found search(std::span<const VertexId> sources, VertexId until) const;
  [[nodiscard]] EdgePlace place(Node node) const;

  const Mesh& mesh_;
  std::vector<EdgeKey> edges_;
  std::vector<std::array<Node, per_triangle>> nodes_;     // per triangle: corners, then side by side
  std::vector<std::array<std::uint32_t, 3>> side_edges_;  // per triangle and side
  std::vector<double> cost_;                              // per edge
  std::vector<glm::dvec3> positions_;                     // per node
  std::vector<std::vector<std::uint32_t>> triangles_of_;  // per node
};

}  // namespace knit
