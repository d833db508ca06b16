// Where a stitch stands as its yarn knows it: its place on the helix of the knitting path, and the directions there.
//
//   place   a round's stitch i of m is moved by f = i/m - 1/2 of a row along its wale: so the last of a round stands level with
//           the first of the next. Where rounds begin elsewhere than those below, as after a split, f follows the stitch below and
//           comes nearer by a quarter of a row a row. A short row's stitches have the f of what they stand on
//   course  half the way from the stitch before to the one after, on the knitting path at either end of a round
//   wale    the mean of the wale edges in and out, twice [1 2 1]/4 along the row: neighbouring wales lean alike
//   out     the mean of the faces around
// Cost: stitches. Mesh units.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "knit/fabric/fabric.h"
#include "knit/yarn/loop_shape.h"
#include "knit/yarn/worked_from.h"

namespace knit {

// By number along the knitting path, as are `positions`. Requires a fabric with faces.
std::vector<LoopFrame> stitch_frames(const Fabric& fabric, std::span<const glm::dvec3> positions,
                                     std::span<const WorkedFrom> worked, std::span<const YarnPath> paths);

}  // namespace knit
