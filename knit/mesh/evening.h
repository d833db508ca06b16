// Evens out a mesh on a solid's surface: edges about equally long, triangles near equilateral, vertices on the surface.
//
// What it is given must be closed, oriented and manifold (as from surface_of), and it stays so: every change keeps the
// surface's shape, genus and orientation, and a change that would not is left out.
//
// M. Botsch, L. Kobbelt, "A remeshing approach to multiresolution modeling", 2004, 4 (here from fine to coarse only).
#pragma once

#include <optional>

#include "knit/mesh/implicit.h"

namespace knit {

// A level circle about the y axis along which the surface is highest, as on a cup. Vertices and edges come to lie on it
// exactly, so that it is level to the bit, and its vertices are numbered in order, behind all others: heights then have
// one crest there, where vertices beside it would have a row of little peaks.
struct Rim {
  double radius = 0.0;
  double y = 0.0;
};

// `edge`: how long edges shall be; the mesh's own should be shorter. Fills in the edges. Cost: some 60
// evaluations of the solid a vertex.
Mesh evened(const Mesh& mesh, const Solid& solid, double edge, const std::optional<Rim>& rim = std::nullopt);

}  // namespace knit
