// What holds the last loops: a strand drawn through them, a chain, or the row that grafts them to others.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "knit/yarn/loop_shape.h"

namespace knit {

inline constexpr std::size_t drawn_together = 12;  // live stitches, at most

// Over one leg of a loop and under the other, in the order of its row; with both ends, 13 points.
std::vector<glm::dvec3> drawn_through(const LoopFrame& head, double stitch_width);

// The head of a loop of the chain: it lies on its side along the edge, and the next stitch's chain loop comes out of it.
LoopFrame chained(const LoopFrame& next, double radius);

// The head of a loop that is grafted to what comes from the other side, between two stitches there: upside down, knitting is
// knitting half a stitch aside.
LoopFrame facing(const LoopFrame& other, const LoopFrame& next);

}  // namespace knit
