// The mesh's surface as a net of triangles known by their edge lengths alone, with Delaunay edges: straight
// lines on the surface that need not be edges of the mesh. The surface itself is the same.
//
// On such a net no cotangent weight is negative. A. Bobenko, B. Springborn, "A discrete Laplace-Beltrami
// operator for simplicial surfaces", 2007; M. Fisher et al., "An algorithm for the construction of intrinsic
// Delaunay triangulations", 2006.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/heard.h"

namespace knit {

// Of a triangle: its edge lengths, edge k from corner k to corner k + 1.
using SideLengths = std::array<double, 3>;

struct IntrinsicMesh {
  // Places (lowest-index twins), all the same way round. Two edges may join the same two places, and an edge
  // may lead back to where it starts.
  std::vector<Triangle> triangles;
  std::vector<SideLengths> lengths;
  double mean_edge = 0.0;
  [[nodiscard]] auto fields() const { return std::tie(triangles, lengths, mean_edge); }
  friend bool operator==(const IntrinsicMesh&, const IntrinsicMesh&) = default;
};

// Flips edges until every one is Delaunay, but for rounding. Requires a mesh without errors (check.h); faces
// that point the other way are turned. Collapsed triangles are left out; those without area count as a hair
// high (see area_of), and flips join them to their neighbours. About a second for a million triangles.
IntrinsicMesh make_intrinsic(const Input& input, const Heard& heard = {});

// Never 0, however thin: 1e-14 of the longest side's square at least, so that cotangents stay finite.
double area_of(const SideLengths& lengths);

// Of the angle at each corner.
std::array<double, 3> cotangents_of(const SideLengths& lengths);

// Where the corner opposite edge `base` lies when that edge lies on the x axis from 0 on, the triangle above.
struct Apex {
  double x = 0.0, y = 0.0;
};
Apex lay_out(const SideLengths& lengths, std::size_t base);

// The edges around each vertex of an intrinsic net.

struct Spoke {
  VertexId end;  // the vertex itself, where an edge leads back
  double length;
};

// Those of vertex v are spokes[first[v] .. first[v + 1]); every edge is one at each of its ends, an open one at
// that from which its triangle runs.
struct Spokes {
  std::vector<std::uint32_t> first;
  std::vector<Spoke> spokes;
  [[nodiscard]] std::span<const Spoke> at(VertexId v) const {
    return std::span(spokes).subspan(first[v], first[v + 1] - first[v]);
  }
};
Spokes spokes_of(const IntrinsicMesh& intrinsic, std::size_t vertex_count, const Heard& heard = {});

// The way along edges to the vertex farthest from `start`: no less than the way straight over the surface.
double reach_along_edges(const Spokes& spokes, VertexId start, const Heard& heard = {});

}  // namespace knit
