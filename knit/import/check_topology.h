// How the triangles hang together, by position: part of check.h, which puts it into words.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

struct SurfacePiece {
  VertexId lowest = no_vertex;  // its lowest vertex
  std::size_t triangles = 0;
};

// Vertices are lowest indices at their place. Collapsed triangles (two corners at one place) are left out.
struct Topology {
  std::vector<SurfacePiece> pieces;  // triangles connected across edges, in order of their first triangle
  std::size_t open_edges = 0;        // of one triangle only
  std::vector<VertexId> holes;       // the lowest vertex of each connected boundary, ascending
  std::vector<std::array<VertexId, 2>> crowded_edges;  // of three or more triangles
  std::vector<VertexId> pinched;                       // more than one fan of triangles; ascending
  // Meaningless when there are crowded edges:
  VertexId one_sided_at = no_vertex;  // a vertex where no orientation fits, if there is one
  std::vector<std::size_t>
      minority;  // triangles to flip so that all neighbours agree, the fewer ones of each piece
};

// Positive where triangles face outwards; meaningful for a closed surface, and in parts of the bounds' cube.
double signed_volume(const Mesh& mesh, const Bounds& bounds);

// How often a closed surface of one piece closes upon itself, like a ring or a mug: 0 for a ball, 1 for a torus. By
// Euler's V - E + F = 2 - 2 g. Such a shape is not one tube along any time.
std::size_t handles_of(const Input& input);

// Of the vertices that triangles use. Requires indices in range, and at least one triangle.
Bounds bounds_of_used(const Mesh& mesh);

// Requires indices in range.
Topology study_topology(std::span<const Triangle> triangles, std::span<const VertexId> twin);

}  // namespace knit
