// Stage 1, its last step: vertices of equal time form levels, and the level where one tube ends is found.
//
// A level set of a linear time on a closed surface is one loop as long as no saddle and no second minimum or
// maximum has been passed. Such critical points are found by Banchoff's index: the triangles in which a
// vertex is the middle one.
#pragma once

#include <vector>

#include "knit/mesh.h"
#include "knit/products.h"

namespace knit {

// Sorts the referenced vertices by time; a gap of more than `tolerance` between neighbours begins a new
// level.
Levels group_levels(const Input& input, const std::vector<double>& times, double tolerance);

// How many closed loops the level set at `time` has. `time` must not be the time of a vertex.
std::int32_t count_loops(const Input& input, const std::vector<double>& times, double time);

// The first level at or after which the level sets are more than one loop.
std::optional<Split> find_split(const Input& input, const std::vector<double>& times, const Levels& levels);

}  // namespace knit
