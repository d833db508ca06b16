#include "knit/mesh/closest_point.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace knit {

namespace {

glm::dvec3 closest_on_side(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 side = to - from;
  const double square = glm::dot(side, side);
  return square > 0.0 ? from + std::clamp(glm::dot(point - from, side) / square, 0.0, 1.0) * side : from;
}

double square_of(const glm::dvec3& v) { return glm::dot(v, v); }

}  // namespace

// Above the triangle the foot of the perpendicular, else the nearest place on a side.
glm::dvec3 closest_on_triangle(const glm::dvec3& point, const std::array<glm::dvec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double square = square_of(normal);
  if (square > 0.0) {
    const auto inside = [&](const glm::dvec3& from, const glm::dvec3& to) {
      return glm::dot(glm::cross(to - from, point - from), normal) >= 0.0;
    };
    if (inside(a, b) && inside(b, c) && inside(c, a))
      return point - (glm::dot(point - a, normal) / square) * normal;
  }
  glm::dvec3 best = closest_on_side(point, a, b);
  for (const glm::dvec3& other : {closest_on_side(point, b, c), closest_on_side(point, c, a)}) {
    if (square_of(other - point) < square_of(best - point)) best = other;
  }
  return best;
}

glm::dvec3 closest_on_surface(const Input& input, const glm::dvec3& point) {
  constexpr double but_for_rounding = 1.0 - 1e-12;
  const Mesh& mesh = input.mesh;
  glm::dvec3 best = point;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < input.boxes.size(); ++i) {
    const auto& [low, high] = input.boxes[i];
    const glm::dvec3 beside = glm::max(glm::max(low - point, point - high), glm::dvec3(0.0));
    if (square_of(beside) * but_for_rounding > least) continue;
    const std::size_t end = std::min((i + 1) * Input::boxed, mesh.triangles.size());
    for (std::size_t t = i * Input::boxed; t < end; ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const glm::dvec3 place =
          closest_on_triangle(point, {mesh.positions[a], mesh.positions[b], mesh.positions[c]});
      if (square_of(place - point) >= least) continue;
      least = square_of(place - point);
      best = place;
    }
  }
  return best;
}

}  // namespace knit
