// The surface with its vertices in a total order, in which no vertex is a multi-saddle: what the graph of tubes is exact on.
//
// Vertices are ordered by (value, index): rank. Nothing compares values alone, so no two vertices are equal, and a flat
// part is ordered like any other. A vertex whose link changes sides more than four times (a multi-saddle) is unfolded:
// one vertex after another is split off at the same place, with the next rank, until each has two runs of upper
// neighbours; two triangles without area join the halves. The surface stays what it was.
// Open edges, at each of which the field is the same all the way round, are closed by a cone (RimCap).
// Flat parts are cut into triangles anew (knit/mesh/flat_flips.h), so that level curves do not hang on how a file cut them.
// algorithm: triangles by the corner that is their middle by rank (T. Banchoff, "Critical points and curvature for
// embedded polyhedra", 1970); a vertex that is the middle of two triangles is regular, of none an extremum.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <tuple>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/heard.h"

namespace knit {

// An open edge is closed by a cone without area of time: all its corners have the rim's value.
struct RimCap {
  VertexId apex = 0;     // of the Morse surface: a minimum or a maximum
  std::int32_t rim = 0;  // of Input::rims
  friend bool operator==(const RimCap&, const RimCap&) = default;
};

struct MorseSurface {
  std::vector<glm::dvec3> positions;
  std::vector<double> values;          // of the field
  std::vector<VertexId> origin;        // the vertex of the mesh (lowest-index twin) that each comes from
  std::vector<Triangle> triangles;     // all the same way round, counter-clockwise seen from outside
  std::vector<std::uint32_t> rank;     // of each vertex, from 0 without a gap
  std::vector<std::uint32_t> by_rank;  // and back
  std::int32_t unfolded = 0;           // vertices added
  std::vector<RimCap> caps;            // as the mesh and the field say
  std::vector<HalfEdge>
      across;  // each half-edge's other side, until tubes are found; empty: to be worked out
  [[nodiscard]] auto fields() const {
    return std::tie(positions, values, origin, triangles, rank, by_rank, unfolded);
  }
  friend bool operator==(const MorseSurface&, const MorseSurface&) = default;
};

// Requires a mesh without errors (check.h) and a value for each vertex of it. Faces that point the other way are turned;
// collapsed ones and vertices of no face are left out. At each open edge the field is at its least or its greatest.
MorseSurface make_morse(const Input& input, std::span<const double> field, const Heard& heard = {});

// Of a surface made by hand: `positions`, `values` and `triangles` are there, the rest is worked out.
MorseSurface order_and_unfold(MorseSurface surface, const Heard& heard = {});

}  // namespace knit
