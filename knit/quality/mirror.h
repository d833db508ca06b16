// How far the knit mesh is from being its own mirror image.
#pragma once

#include <optional>

#include "knit/mesh/mesh.h"
#include "knit/quality/quality.h"
#include "knit/run/state.h"

namespace knit {

// The plane holds the mesh's centroid, the axis, and the direction in which rounds begin: from the middle of
// the first row with the most stitches to its first stitch. Each wale edge is reflected and set against the
// wale edge of its strip that is nearest, by the farther of the two ends. Nothing while there are no wale
// edges, or if that direction lies along the axis.
std::optional<MirrorError> mirror_error(const Input& input, const State& state, double stitch_width);

}  // namespace knit
