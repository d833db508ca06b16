// Stage 1, its last step: vertices of equal time form levels, and the level where one tube ends is found.
// Thesis 3.2.1.
#pragma once

#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/heard.h"
#include "knit/model/products.h"

namespace knit {

// Sorts the referenced vertices by time; a gap of more than `tolerance` between neighbours begins a new
// level.
Levels group_levels(const Input& input, const std::vector<double>& times, const Criticals& criticals,
                    double tolerance, const Heard& heard = {});

}  // namespace knit
