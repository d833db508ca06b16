// The shortest way along the surface between vertices, exact on the triangle mesh: the ruler of the metric
// `geodesic`.
//
// Windows of straight lines are unfolded over edges from the source outwards (J. Chen, Y. Han, "Shortest
// paths on a polyhedron", 1990; S.-Q. Xin, G.-J. Wang, 2009, for the order and the filters). Vertices at the
// same place are one (Input::twin). Mesh units.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

inline constexpr double not_reached = std::numeric_limits<double>::infinity();

// From `source` to each of `targets`, as far as `radius`; beyond it, `not_reached`. Twins of the source are
// at 0.
std::vector<double> surface_distances(const Input& input, VertexId source, std::span<const VertexId> targets,
                                      double radius = not_reached);

}  // namespace knit
