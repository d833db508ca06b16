// Stage 1, timing: a linear Morse function gives each vertex a time in [0, 1]. Thesis 3.2.1, Algorithm 1.
#pragma once

#include <variant>

#include "knit/mesh/mesh.h"
#include "knit/model/products.h"
#include "knit/model/settings.h"
#include "knit/model/stopped.h"

namespace knit {

// Start and end of the knitting. Without picked vertices: the extreme ones along the axis (ties: nearest to
// the line through the centroid, then lowest index), and the time runs along the axis itself. With a picked
// vertex: along the line from start to end, as Algorithm 1 is printed. Stops with no_extent when both lie at
// one time, and with open_edge where an open mesh is to be timed otherwise than harmonically.
// Of an open mesh an open edge stands for a vertex (Ends::start_rim): with one edge that is the start and the vertex farthest
// from it, along edges, the end; of two the lower along the axis is the start, the other the end, unless their roles say
// otherwise. A picked vertex stays one where the edges leave it free. swap_ends changes the two.
std::variant<Ends, Stopped> find_ends(const Input& input, const TimingSettings& timing);

// Algorithm 1, line 7: not clamped.
double time_of(const Ends& ends, const glm::dvec3& position);

}  // namespace knit
