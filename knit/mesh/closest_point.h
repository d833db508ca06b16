// The place on a surface that is nearest to a point, by trying every triangle whose box is near: exact up to rounding, for a few
// points.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "knit/mesh/mesh.h"

namespace knit {

// Slivers and triangles without area too.
glm::dvec3 closest_on_triangle(const glm::dvec3& point, const std::array<glm::dvec3, 3>& corners);

// Of equally near places that of the first triangle. Requires a triangle.
glm::dvec3 closest_on_surface(const Input& input, const glm::dvec3& point);

}  // namespace knit
