// Where a round begins and which way it runs: the plane across the direction of knitting.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

namespace knit {

// Seen along `along`, angles about the centre rise counter-clockwise from `right` towards `ahead`: working
// order, beginning on the side of `right`. All three are unit vectors at right angles.
struct RowFrame {
  glm::dvec3 along, right, ahead;
};

// Rounds begin on the side of `start`; without one towards -z, or -x where that lies along the direction.
inline RowFrame row_frame(const glm::dvec3& direction, const std::optional<glm::dvec3>& start) {
  const glm::dvec3 d = glm::normalize(direction);
  const auto across = [&](const glm::dvec3& v) { return v - glm::dot(v, d) * d; };
  glm::dvec3 right = start ? across(glm::normalize(*start)) : across({0, 0, -1});
  if (glm::length(right) < 1e-6) right = across({0, 0, -1});
  if (glm::length(right) < 1e-6) right = across({-1, 0, 0});
  right = glm::normalize(right);
  return {d, right, glm::cross(right, d)};
}

// Whether a loop runs against working order: its signed area about the frame is negative.
inline bool runs_backwards(std::span<const glm::dvec3> loop, const RowFrame& frame,
                           const glm::dvec3& centre) {
  double area = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::dvec3 a = loop[i] - centre;
    const glm::dvec3 b = loop[(i + 1) % loop.size()] - centre;
    area += glm::dot(a, frame.right) * glm::dot(b, frame.ahead) -
            glm::dot(b, frame.right) * glm::dot(a, frame.ahead);
  }
  return area < 0.0;
}

}  // namespace knit
