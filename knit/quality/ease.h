// What settling did (knit/settle): the same stitches where they were placed, and where they settled.
//
// Rows, links and faces are the same at both; only positions differ. A pattern is judged by where stitches settle.
#pragma once

#include <cstddef>
#include <optional>

#include "knit/mesh/mesh.h"
#include "knit/run/state.h"

namespace knit {

// With its stitches where they were placed, as if nothing had settled.
State placed_state(const State& state);

// How far stitches are from where they were placed, straight through the air, in mesh units.
struct EaseMoves {
  double mean = 0.0, most = 0.0;
  StitchRef of;  // that went farthest
};
// None where nothing has settled.
std::optional<EaseMoves> measure_moves(const State& state);

// Where one stitch was placed, and where it is.
struct StitchMove {
  glm::dvec3 from{0.0}, to{0.0};
};
// None where nothing has settled. Requires a stitch of a finished row or bridge.
std::optional<StitchMove> move_of(const State& state, const StitchRef& stitch);

// Faces that lie with their inside out: whose normal looks away from the mesh's at the nearest place to their middle.
// The mesh's is that of the vertices, interpolated, and out is where most faces look. Cost: a look into a tree a face.
struct TurnedFaces {
  std::size_t faces = 0;
  StitchRef at;  // a corner of the first
};
TurnedFaces measure_turned(const Input& input, const State& state);

}  // namespace knit
