// A plane along the axis in which a shape is its own mirror image.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <tuple>

namespace knit {

struct MirrorPlane {
  glm::dvec3 point{0.0}, normal{1.0, 0.0, 0.0};  // the normal is a unit vector across the axis
  glm::dvec3 back{0.0, 0.0, -1.0};  // within the plane, across the axis: a unit vector; rounds begin there
  [[nodiscard]] double height(const glm::dvec3& p) const { return glm::dot(p - point, normal); }
  [[nodiscard]] glm::dvec3 reflect(const glm::dvec3& p) const { return p - 2.0 * height(p) * normal; }
  [[nodiscard]] auto fields() const { return std::tie(point, normal, back); }
  friend bool operator==(const MirrorPlane&, const MirrorPlane&) = default;
};

}  // namespace knit
