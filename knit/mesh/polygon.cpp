#include "knit/mesh/polygon.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "knit/mesh/flat_flips.h"

namespace knit {

namespace {

// Twice the signed area of a, b, c; positive counter-clockwise.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The polygon seen along its normal's largest component, counter-clockwise.
std::vector<glm::dvec2> flattened(std::span<const VertexId> corners,
                                  const std::vector<glm::dvec3>& positions) {
  const glm::dvec3 origin = positions[corners[0]];
  glm::dvec3 normal(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal += glm::cross(positions[corners[i]] - origin, positions[corners[i + 1]] - origin);
  glm::length_t drop = 0;
  for (glm::length_t axis = 1; axis < 3; ++axis)
    if (glm::abs(normal[axis]) > glm::abs(normal[drop])) drop = axis;
  const glm::length_t u = (drop + 1) % 3;
  const glm::length_t v = (drop + 2) % 3;
  std::vector<glm::dvec2> flat;
  flat.reserve(corners.size());
  for (const VertexId corner : corners) {
    const glm::dvec3 p = positions[corner] - origin;
    flat.push_back(normal[drop] < 0.0 ? glm::dvec2(p[v], p[u]) : glm::dvec2(p[u], p[v]));
  }
  return flat;
}

void cut_quad(std::span<const VertexId> q, const std::vector<glm::dvec3>& positions,
              std::vector<Triangle>& triangles) {
  const std::vector<glm::dvec2> p = flattened(q, positions);
  const bool inside_02 = turn(p[0], p[1], p[2]) > 0.0 && turn(p[0], p[2], p[3]) > 0.0;
  const bool inside_13 = turn(p[0], p[1], p[3]) > 0.0 && turn(p[1], p[2], p[3]) > 0.0;
  const glm::dvec3 d02 = positions[q[2]] - positions[q[0]];
  const glm::dvec3 d13 = positions[q[3]] - positions[q[1]];
  const bool cut_02 = inside_02 != inside_13 ? inside_02 : glm::dot(d02, d02) < glm::dot(d13, d13);
  if (cut_02) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  } else {
    triangles.push_back({q[0], q[1], q[3]});
    triangles.push_back({q[1], q[2], q[3]});
  }
}

// What is left of the polygon while ears are cut off, as a circle of corners.
struct Remainder {
  std::vector<glm::dvec2> flat;
  std::vector<std::size_t> next;
  std::vector<std::size_t> previous;
  std::vector<std::uint8_t> reflex;  // only these can lie in an ear
  std::vector<std::size_t> reflex_list;

  void set_reflex(std::size_t i) {
    reflex[i] = turn(flat[previous[i]], flat[i], flat[next[i]]) > 0.0 ? 0 : 1;
  }

  [[nodiscard]] bool is_ear(std::size_t i) const {
    if (reflex[i] != 0) return false;
    const glm::dvec2& a = flat[previous[i]];
    const glm::dvec2& b = flat[i];
    const glm::dvec2& c = flat[next[i]];
    for (const std::size_t r : reflex_list) {
      const glm::dvec2& p = flat[r];
      if (reflex[r] == 0 || p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
    }
    return true;
  }

  void cut(std::size_t i) {
    next[previous[i]] = next[i];
    previous[next[i]] = previous[i];
    reflex[i] = 0;
    set_reflex(previous[i]);
    set_reflex(next[i]);
  }
};

Remainder whole(std::span<const VertexId> corners, const std::vector<glm::dvec3>& positions) {
  const std::size_t count = corners.size();
  Remainder rest{flattened(corners, positions), {}, {}, std::vector<std::uint8_t>(count, 0), {}};
  for (std::size_t i = 0; i < count; ++i) {
    rest.next.push_back((i + 1) % count);
    rest.previous.push_back((i + count - 1) % count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    rest.set_reflex(i);
    // Cutting an ear never makes a convex corner reflex in a simple polygon.
    if (rest.reflex[i] != 0) rest.reflex_list.push_back(i);
  }
  return rest;
}

}  // namespace

void triangulate(std::span<const VertexId> corners, const std::vector<glm::dvec3>& positions,
                 std::vector<Triangle>& triangles) {
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  if (corners.size() == 4) return cut_quad(corners, positions, triangles);
  Remainder rest = whole(corners, positions);
  std::size_t at = 0;
  for (std::size_t left = corners.size(); left > 2; --left) {
    std::size_t tries = left;
    while (tries > 0 && !rest.is_ear(at)) at = rest.next[at], --tries;
    triangles.push_back({corners[rest.previous[at]], corners[at], corners[rest.next[at]]});
    const std::size_t after = rest.next[at];
    rest.cut(at);
    at = rest.next[after];  // one corner further, so that a convex polygon does not become a fan of slivers
  }
  flip_flat_edges(std::span(triangles).last(corners.size() - 2), positions);
}

}  // namespace knit
