// Stage 3, rows from contours: the surface cut at one value of a field, as closed polylines in working order.
//
// A vertex at the value counts as above it, so every cut crosses edges and never stops at a vertex; on a closed
// surface each cut falls into closed loops. On each crossed edge the field is taken to run straight.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/products.h"
#include "knit/rows/frame.h"

namespace knit {

// One entry a value (they must rise strictly): its loops, longest first; none where the surface is pinched to a point. Loops run in the frame's working
// order; the first point is where the loop crosses the half-plane from its centre towards frame.right (of
// several crossings the one nearest to the start of the cut below). `times` names the cuts.
std::vector<Cut> cut_surface(const Input& input, const std::vector<double>& field,
                             std::span<const double> values, std::span<const double> times,
                             const RowFrame& frame);

}  // namespace knit
