// Where a function on the vertices, straight within each triangle, has one value: rings of places on edges.
#pragma once

#include <span>
#include <vector>

#include "knit/curves/embed.h"
#include "knit/mesh/mesh.h"

namespace knit {

struct LevelLines {
  std::vector<std::vector<EdgePlace>> rings;  // each place once, no place twice
  std::vector<std::vector<EdgePlace>> open;   // those that run into an open edge of the mesh
};

// Values nearer to the level than 0.03 of a mean edge count as on it, or else slivers would come of the cut. The level
// line is the border of all that lies above it. Not finite values are above.
LevelLines level_lines(const Mesh& mesh, std::span<const double> values, double level);

}  // namespace knit
