#include "knit/settle/surface.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/mesh/closest_point.h"

namespace knit {

namespace {

// How far a triangle's outside may turn away from the stitch's: the cosine, a little more than a right angle, so that edges
// of boxes are gone round.
constexpr double most_turned = -0.3;

double squared_length(const glm::dvec3& v) { return glm::dot(v, v); }

std::array<glm::dvec3, 3> corners_of(const Input& input, std::uint32_t triangle) {
  const auto& [a, b, c] = input.mesh.triangles[triangle];
  return {input.mesh.positions[a], input.mesh.positions[b], input.mesh.positions[c]};
}

glm::dvec3 across(const std::array<glm::dvec3, 3>& corners) {
  return glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
}

// Whether the outside of the triangle looks away from the one that `normal` shows.
bool opposed(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& normal) {
  const glm::dvec3 outside = across(corners);
  const double along = glm::dot(outside, normal);
  return along < 0.0 && along * along > most_turned * most_turned * squared_length(outside);
}

}  // namespace

VertexNormals vertex_normals(const Input& input) {
  VertexNormals made;
  made.normals.assign(input.mesh.positions.size(), glm::dvec3(0.0));
  for (std::uint32_t t = 0; t < input.mesh.triangles.size(); ++t) {
    const glm::dvec3 outside = across(corners_of(input, t));
    for (const VertexId v : input.mesh.triangles[t]) made.normals[input.twin[v]] += outside;
  }
  for (std::size_t v = 0; v < made.normals.size(); ++v) {
    if (input.twin[v] != v) {
      made.normals[v] = made.normals[input.twin[v]];  // lower, so it is done
      continue;
    }
    const double length = glm::length(made.normals[v]);
    made.normals[v] = length > 0.0 ? made.normals[v] / length : glm::dvec3(0.0);
  }
  return made;
}

glm::dvec3 normal_at(const Input& input, const VertexNormals& normals, std::uint32_t triangle,
                     const glm::dvec3& point, const glm::dvec3& otherwise) {
  const auto [a, b, c] = corners_of(input, triangle);
  const auto& vertices = input.mesh.triangles[triangle];
  const glm::dvec3 outside = glm::cross(b - a, c - a);
  const double area = squared_length(outside);
  if (area <= 0.0) return otherwise;
  const double u = glm::dot(glm::cross(c - b, point - b), outside) / area;
  const double v = glm::dot(glm::cross(a - c, point - c), outside) / area;
  const glm::dvec3 mixed = u * normals.normals[vertices[0]] + v * normals.normals[vertices[1]] +
                           (1.0 - u - v) * normals.normals[vertices[2]];
  const double length = glm::length(mixed);
  return length > 1e-9 ? mixed / length : otherwise;
}

SurfaceWalk::SurfaceWalk(const Input& input, const VertexNormals& normals)
    : input_(&input), normals_(&normals), met_(input.mesh.triangles.size(), 0) {}

OnSurface SurfaceWalk::nearest(const OnSurface& from, const glm::dvec3& to) {
  ++walks_;
  queue_.assign(1, from.triangle);
  met_[from.triangle] = walks_;
  const double ball = squared_length(to - from.point);
  OnSurface best = from;
  double least = ball;
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const std::uint32_t triangle = queue_[next];
    const std::array<glm::dvec3, 3> corners = corners_of(*input_, triangle);
    const glm::dvec3 place = closest_on_triangle(to, corners);
    const double square = squared_length(place - to);
    if (next > 0 && (square > ball || opposed(corners, from.normal))) continue;
    if (square < least) {
      least = square;
      best.triangle = triangle;
      best.point = place;
    }
    for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
      const HalfEdge beyond = input_->across[side];
      if (beyond == no_half_edge || met_[beyond / 3] == walks_) continue;
      met_[beyond / 3] = walks_;
      queue_.push_back(beyond / 3);
    }
  }
  best.normal = normal_at(*input_, *normals_, best.triangle, best.point, from.normal);
  return best;
}

}  // namespace knit
