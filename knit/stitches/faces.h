// Stage 5, faces: quads and triangles between two rows, read off the labels. Thesis 3.2.4-3.2.5.
//
// Cells b, b + 1 of the larger row (cyclic) hang on the same stitch: a triangle; on neighbours: a quad. So
// there are min(p, n) quads and |n - p| triangles a strip. Faces run (prev i, cur j, cur j + 1, prev i + 1),
// counter-clockwise seen from outside. A quad is a main's when its cell is; a triangle carries its shaping
// label.
#pragma once

#include "knit/model/products.h"

namespace knit {

// `first_below`: the number, along the knitting path, of the first stitch of the row below; the row above
// follows it.
Strip build_strip(const Transition& transition, std::uint32_t first_below);

}  // namespace knit
