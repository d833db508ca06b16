#include "knit/settle/surface.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/mesh/closest_point.h"
#include "knit/mesh/outside.h"

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

// Whether the outside of the triangle looks away from the one that `normal` shows. `inward`: its corners go round clockwise.
bool opposed(const std::array<glm::dvec3, 3>& corners, bool inward, const glm::dvec3& normal) {
  const glm::dvec3 outside = across(corners);
  const double along = inward ? -glm::dot(outside, normal) : glm::dot(outside, normal);
  return along < 0.0 && along * along > most_turned * most_turned * squared_length(outside);
}

// As closest_on_triangle, with fewer products: by the region of the triangle's plane in which the point lies.
// C. Ericson, "Real-Time Collision Detection", 2005, 5.1.5.
glm::dvec3 nearest_on(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& point) {
  constexpr double thin = 1e-8;  // of the product of two squared sides: there rounding would show
  const auto& [a, b, c] = corners;
  const glm::dvec3 ab = b - a, ac = c - a, ap = point - a;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  const double bb = squared_length(ab), cc = squared_length(ac), bc = glm::dot(ab, ac);
  const double area = bb * cc - bc * bc;
  if (!(area > thin * bb * cc)) return closest_on_triangle(point, corners);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const double d3 = d1 - bb, d4 = d2 - bc;
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double towards_c = d1 * d4 - d3 * d2;
  if (towards_c <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / bb * ab;
  const double d5 = d1 - bc, d6 = d2 - cc;
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double towards_b = d5 * d2 - d1 * d6;
  if (towards_b <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / cc * ac;
  const double towards_a = d3 * d6 - d5 * d4;
  if (towards_a <= 0.0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double whole = towards_a + towards_b + towards_c;
  return a + towards_b / whole * ab + towards_c / whole * ac;
}

// Whether the side's line is farther from the point than the ball reaches, so that the ball does not cross the side.
bool out_of_reach(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& point, double ball) {
  const glm::dvec3 side = to - from, away = point - from;
  const double square = squared_length(side), along = glm::dot(away, side);
  return squared_length(away) * square - along * along > ball * square;
}

}  // namespace

VertexNormals vertex_normals(const Input& input, const Heard& heard) {
  VertexNormals made;
  made.normals.assign(input.mesh.positions.size(), glm::dvec3(0.0));
  made.inward = inward_triangles(input);
  for (std::uint32_t t = 0; t < input.mesh.triangles.size(); ++t) {
    hear_at(heard, t, input.mesh.triangles.size());
    const auto& [a, b, c] = input.mesh.triangles[t];
    const glm::dvec3& corner = input.mesh.positions[a];
    const glm::dvec3 outside = glm::cross(input.mesh.positions[b] - corner, input.mesh.positions[c] - corner);
    for (const VertexId v : {a, b, c}) made.normals[input.twin[v]] += made.faces_in(t) ? -outside : outside;
  }
  for (std::size_t v = 0; v < made.normals.size(); ++v) {
    if (v % 8192 == 0) hear(heard, 1.0);
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

SurfaceWalk::SurfaceWalk(const Input& input, const VertexNormals& normals) { refer_to(input, normals); }

void SurfaceWalk::refer_to(const Input& input, const VertexNormals& normals) {
  input_ = &input;
  normals_ = &normals;
  if (met_.size() == input.mesh.triangles.size()) return;
  met_.assign(input.mesh.triangles.size(), 0);
  walks_ = 0;
}

OnSurface SurfaceWalk::nearest(const OnSurface& from, const glm::dvec3& to) {
  ++walks_;
  queue_.assign(1, from.triangle);
  met_[from.triangle] = walks_;
  const double ball = squared_length(to - from.point);
  OnSurface best = from;
  double least = ball;
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const std::uint32_t triangle = queue_[next];
    const auto& [a, b, c] = input_->mesh.triangles[triangle];
    const auto& positions = input_->mesh.positions;
    const std::array<glm::dvec3, 3> corners{positions[a], positions[b], positions[c]};
    const glm::dvec3 place = nearest_on(corners, to);
    const double square = squared_length(place - to);
    if (next > 0 && (square > ball || opposed(corners, normals_->faces_in(triangle), from.normal))) continue;
    if (square < least) {
      least = square;
      best.triangle = triangle;
      best.point = place;
    }
    for (std::uint32_t side = 0; side < 3; ++side) {
      const HalfEdge beyond = input_->across[3 * triangle + side];
      if (beyond == no_half_edge || met_[beyond / 3] == walks_) continue;
      if (out_of_reach(corners[side], corners[side < 2 ? side + 1 : 0], to, ball)) continue;
      met_[beyond / 3] = walks_;
      queue_.push_back(beyond / 3);
    }
  }
  best.normal = normal_at(*input_, *normals_, best.triangle, best.point, from.normal);
  return best;
}

}  // namespace knit
