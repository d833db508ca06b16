// The settings of a first run on a mesh of which nobody has said anything: one that works.
#pragma once

#include "knit/mesh/mesh.h"
#include "knit/model/settings.h"

namespace knit {

// default_parameters() with timing, rows, placement and settling left to the run, which chooses by the mesh
// (knit/timing/choice.h, knit/rows/choice.h): stitches settle where rows come from contours. Resolved on the mesh.
Parameters first_parameters(const Input& input);

}  // namespace knit
