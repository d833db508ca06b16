// How close the knit mesh and the mesh that came in are to each other: distances both ways, and areas.
//
// Distances are sampled: on the knit mesh at every stitch, at the middle of every edge and face, and at the
// middles of the lines from a face's middle to its corners; on the mesh at every vertex (once a place) and at
// the middle of every triangle. Quads count as two triangles, cut between their first and third corner. Mesh
// units; nearest points are exact.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "knit/mesh/mesh.h"
#include "knit/quality/coverage.h"
#include "knit/run/state.h"

namespace knit {

struct Distances {
  std::size_t samples = 0;
  double mean = 0.0, max = 0.0;
};

struct Closeness {
  Distances knit_to_mesh, mesh_to_knit;  // the ends of the tube stay open, which mesh_to_knit shows
  double diagonal = 0.0;                 // of the mesh's bounding box
  double knit_area = 0.0, mesh_area = 0.0;
  std::optional<Coverage> coverage;          // once all faces are there, and where a stitch's size was given
  std::shared_ptr<const Closeness> placed;   // likewise: as stitches were placed. Null: nothing has settled
  std::shared_ptr<const Closeness> relaxed;  // likewise: in the air. Null: it has not been relaxed
};

// Nothing while there are no faces. Takes about a second a million triangles; meant for a worker.
std::optional<Closeness> measure_closeness(const Input& input, const State& state);
// With the coverage, which takes about as long again; and all of it as placed, where stitches have settled, and the
// distances in the air, where the piece has been relaxed.
std::optional<Closeness> measure_closeness(const Input& input, const State& state, double stitch_width,
                                           double stitch_height);

}  // namespace knit
