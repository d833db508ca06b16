// One curve laid into the mesh as a ring of edges: the level set of the exact surface distance (circle, band), of a plane,
// or shortest ways from point to point. Only the chosen ring is cut. Vertices keep their numbers; new ones are appended.
// Gives up with CurveRefused (refused.h).
#pragma once

#include <vector>

#include "knit/curves/cycle.h"
#include "knit/mesh/mesh.h"

namespace knit {

struct CutSizes {
  double diagonal = 0.0;  // of the mesh as it was: clicks lie within 1 % of it from the surface
  double radius = 0.0;    // of a circle that says none
  glm::dvec3 up{0.0, 1.0, 0.0};
};

// The ring's vertices in order; its last is joined with its first. Requires a sewn mesh (embed.h) and a kind other
// than farthest.
std::vector<VertexId> cut_cycle(Mesh& mesh, const Cycle& cycle, const CutSizes& sizes);

}  // namespace knit
