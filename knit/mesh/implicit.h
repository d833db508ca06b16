// Surfaces of solids: where a signed field is zero, as a triangle mesh. Examples are made of them.
//
// A solid is a function of a place: negative inside, positive outside, about a distance near its surface. Lengths are
// in mesh units. The solid must lie inside the block, with more than a cell to spare; a part thinner than a cell may be
// missed. Nothing else can go wrong: any field gives a mesh that is closed, oriented outwards and manifold.
//
// A. Doi, A. Koide, "An efficient method of triangulating equi-valued surfaces by using tetrahedral cells", 1991.
#pragma once

#include <functional>
#include <glm/vec3.hpp>

#include "knit/mesh/mesh.h"

namespace knit {

using Solid = std::function<double(const glm::dvec3& place)>;

struct GridBlock {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};
};

// By a grid of cubes with sides of `cell`. Triangles are of all sizes and forms (see evening.h); edges are left empty.
Mesh surface_of(const Solid& solid, const GridBlock& block, double cell);

// Moves a place near the surface onto it, by as many steps of Newton's method, each of four evaluations.
glm::dvec3 onto_surface(const Solid& solid, glm::dvec3 place, int times);

}  // namespace knit
