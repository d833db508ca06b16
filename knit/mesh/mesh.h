// The mesh that comes in: positions and triangles, and what the stages need to know about its shape.
//
// Topology is read from positions, not from indices: vertices at exactly the same place are one corner of the
// surface (a UV seam is closed). `Input::twin` gives the lowest index at each place. Lengths are in mesh
// units. Thesis 3.1.2 (mesh import and data structures).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace knit {

using VertexId = std::uint32_t;
inline constexpr VertexId no_vertex = UINT32_MAX;
using Triangle = std::array<VertexId, 3>;
// 3 t + k: corner k of triangle t, and the side from it to the next corner.
using HalfEdge = std::uint32_t;
inline constexpr HalfEdge no_half_edge = UINT32_MAX;
constexpr HalfEdge next_in_triangle(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr HalfEdge previous_in_triangle(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }

struct Bounds {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};
  double radius = 0.0;  // greatest distance from the centre
  [[nodiscard]] glm::dvec3 centre() const;
  [[nodiscard]] double diagonal() const;
};

// A mesh as read from a file, not yet checked. Triangles are counter-clockwise seen from outside.
struct Mesh {
  std::string name;                   // for people: a file's stem or an example's name
  std::vector<glm::dvec3> positions;  // finite once checked
  std::vector<Triangle> triangles;    // in range once checked
  std::vector<std::array<VertexId, 2>>
      edges;  // of the file's polygons, each once, low index first: for drawing
};

// What becomes of an open edge: the first row, the last one, or whatever the run finds best.
enum class RimRole : std::uint8_t { by_itself, start, end };

// An edge that a mesh is open at, all the way round.
struct MeshRim {
  std::vector<VertexId>
      vertices;         // lowest indices at their places, in order round the rim, from the lowest on
  double length = 0.0;  // all the way round
  RimRole role = RimRole::by_itself;  // what who cut it open says
};

// A checked mesh with what every stage reads. Immutable; shared by all states of a run.
struct Input {
  Mesh mesh;
  Bounds bounds;
  glm::dvec3 centroid{0.0};              // mean of the distinct, referenced positions
  std::vector<VertexId> twin;            // per vertex: lowest index at the same position
  std::vector<std::uint8_t> referenced;  // per vertex: 1 if a triangle with three places uses it
  // Neighbours across an edge, by twins, ascending: those of v are neighbours[first_neighbour[v] .. [v + 1]).
  // Only lowest-index vertices have entries.
  std::vector<std::uint32_t> first_neighbour;
  std::vector<VertexId> neighbours;
  // Walking from triangle to triangle, by twins; triangles with two corners at one place are left out.
  std::vector<HalfEdge> across;        // per side: the same edge in the triangle beyond, if there is just one
  std::vector<HalfEdge> first_corner;  // per lowest-index vertex: one of its corners, if it has any
  std::vector<MeshRim> rims;           // by their lowest vertices; empty: the surface is closed
  // Around the triangles [i * boxed, (i + 1) * boxed): what a ray or a search may pass over.
  static constexpr std::size_t boxed = 64;
  struct Box {
    glm::dvec3 low{0.0}, high{0.0};
  };
  std::vector<Box> boxes;

  [[nodiscard]] std::span<const VertexId> neighbours_of(VertexId vertex) const;
  [[nodiscard]] bool adjacent(VertexId a, VertexId b) const;  // also true for twins of adjacent vertices
};

// Per vertex the lowest index at exactly the same position (-0 equals 0).
std::vector<VertexId> find_twins(const std::vector<glm::dvec3>& positions);

// Merges vertices at the same position; drops triangles that collapse and vertices that vanish. Order is
// kept.
Mesh weld(const Mesh& mesh);

Bounds bounds_of(const std::vector<glm::dvec3>& positions);

// Requires indices in range and finite positions (see check.h).
std::shared_ptr<const Input> make_input(Mesh mesh);

}  // namespace knit
