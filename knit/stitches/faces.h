// Stage 5, faces: quads and triangles between two rows, read off the labels. Thesis 3.2.4-3.2.5.
//
// A short row's strip ends on either side with a triangle: (below, above, beside), labelled as a turn, with the
// stitch that hangs beside the stretch as its apex.
//
// Cells b, b + 1 of the larger row (cyclic) hang on the same stitch: a triangle; on neighbours: a quad. So
// there are min(p, n) quads and |n - p| triangles a strip. Faces run (prev i, cur j, cur j + 1, prev i + 1),
// counter-clockwise seen from outside. A quad is a main's when its cell is; a triangle carries its shaping
// label.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "knit/fabric/fabric.h"
#include "knit/fabric/join.h"
#include "knit/fabric/strip.h"

namespace knit {

// `below`, `above`: the numbers along the knitting path of the stitches that the join takes and makes; `beside`: of those
// before and after the stretch that a short row is worked over.
Strip build_strip(const Join& join, std::span<const std::uint32_t> below,
                  std::span<const std::uint32_t> above,
                  const std::optional<std::array<std::uint32_t, 2>>& beside = {});
// Of a join whose row is there.
Strip build_strip(const Fabric& fabric, const Join& join);

}  // namespace knit
