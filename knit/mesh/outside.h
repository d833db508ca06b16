// Which way the surface's outside is, whatever way the file's triangles face.
//
// Flooded from triangle to triangle: neighbours go through their edge in opposite directions. Of each piece the way that more
// triangles face holds; where the volume is then negative, all are turned, so that a mesh turned inside out has its outside
// out. Takes time and memory as there are triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

// Per triangle 1 if its corners go round clockwise seen from outside; empty if that is so of none.
std::vector<std::uint8_t> inward_triangles(const Input& input);

}  // namespace knit
