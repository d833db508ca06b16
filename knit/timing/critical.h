// Stage 1, critical points of the time: where its level sets begin, part, join and end.
//
// Found by Banchoff's index: a vertex is regular when it is the middle one, by time, in exactly two of its
// triangles. Ties are broken by index; a flat part of the surface is then judged as one point, so that only
// what truly changes the level sets is left. T. Banchoff, "Critical points and curvature for embedded
// polyhedra", 1967.
#pragma once

#include <optional>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/heard.h"
#include "knit/model/products.h"

namespace knit {

Criticals find_criticals(const Input& input, const std::vector<double>& times, const Heard& heard = {});

// How many closed loops the level set at `time` has; vertices at `time` count as above it.
std::int32_t count_loops(const Input& input, const std::vector<double>& times, double time);

// Why the level set at `time` has several loops: the saddle below at which the tube parts, or the saddle above
// at which another end of the shape joins. `level` and `loops` are left as they are.
Split explain_split(const Input& input, const std::vector<double>& times, const Criticals& criticals,
                    double time);

// The first of the levels at or just after which the level sets are more than one loop.
std::optional<Split> find_split(const Input& input, const std::vector<double>& times,
                                const Criticals& criticals, const Levels& levels, const Heard& heard = {});

}  // namespace knit
