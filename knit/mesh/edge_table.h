// Every use of every edge by the triangles, grouped by edge: what adjacency and the mesh check are read from.
//
// A half-edge 3 t + k runs from corner k of triangle t to its next corner. Ends are twins (see mesh.h), so
// the two sides of a seam are one edge. A triangle with two corners at one place has no edges here: its
// neighbours touch.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

struct EdgeUse {
  VertexId high;            // the end with the higher index
  std::uint32_t half_edge;  // which triangle's side this is
};

// Uses of edges whose lower end is v: uses[first[v] .. first[v + 1]), ascending by high, then by half-edge.
struct EdgeTable {
  std::vector<std::uint32_t> first;
  std::vector<EdgeUse> uses;
};

// Requires indices in range and fewer than 2^32 / 3 triangles.
EdgeTable make_edge_table(std::span<const Triangle> triangles, std::span<const VertexId> twin);

// Triangle with each corner replaced by its twin, and whether two corners are then the same.
Triangle twins_of(const Triangle& triangle, std::span<const VertexId> twin);
bool collapsed(const Triangle& triangle);

// Each edge once, low index first, ascending. Requires ends below vertex_count; edges from a vertex to itself
// vanish.
std::vector<std::array<VertexId, 2>> unique_edges(std::span<const std::array<VertexId, 2>> edges,
                                                  std::size_t vertex_count);

// The edges of one triangle only, joined into loops: each from its lowest vertex on, in the direction in which the triangle
// there runs; by their lowest vertices. Where more than two such edges meet, somehow.
std::vector<std::vector<VertexId>> boundary_loops(std::span<const Triangle> triangles,
                                                  std::span<const VertexId> twin);

}  // namespace knit
