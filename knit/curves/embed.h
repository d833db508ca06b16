// Lines laid into a mesh: places on its edges become vertices, and the triangles in between are split, so that the
// line is a chain of edges. Vertices keep their numbers; new ones are appended. The mesh is a Mesh whose seams are
// sewn (sewn): corners at one place have one number.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

// A vertex (low == high), or the place (1 - along) low + along high of an edge, 0 < along < 1.
struct EdgePlace {
  VertexId low = no_vertex, high = no_vertex;
  double along = 0.0;
  [[nodiscard]] bool vertex() const { return low == high; }
  [[nodiscard]] glm::dvec3 position(const Mesh& mesh) const;
  friend auto operator<=>(const EdgePlace&, const EdgePlace&) = default;
};
EdgePlace at_vertex(VertexId vertex);
EdgePlace on_edge(VertexId a, VertexId b, double from_a);

// The same positions, every triangle by its corners' twins; triangles with two corners at one place are left out.
Mesh sewn(const Mesh& mesh);

// The vertices of the line, one for each place. Two neighbours in `places` must lie in one triangle; where lines cross
// inside it, not every piece of the line becomes an edge.
std::vector<VertexId> embed(Mesh& mesh, std::span<const EdgePlace> places, bool closed);

// A vertex where the surface is nearest to `point`: an old one within 5 % of the triangle's mean edge, else a new one
// on an edge or inside of a triangle.
VertexId insert_point(Mesh& mesh, const glm::dvec3& point);

using EdgeKey = std::pair<VertexId, VertexId>;  // low, high
EdgeKey edge_key(VertexId a, VertexId b);
std::vector<EdgeKey> edges_of(std::span<const Triangle> triangles);  // each once, ascending

// The open edges as rings, each as its triangles run along it.
std::vector<std::vector<VertexId>> boundary_rings(std::span<const Triangle> triangles);

}  // namespace knit
