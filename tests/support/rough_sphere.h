// Spheres without any order in their triangles, and other changes to meshes that a surface does not feel.
#pragma once

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "knit/mesh/shapes.h"

namespace test_support {

// The same on every machine, as the standard's distributions are not.
class Dice {
 public:
  explicit Dice(unsigned seed) : bits_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_()) / 4294967295.0;
  }
  std::size_t below(std::size_t count) { return bits_() % count; }

 private:
  std::mt19937 bits_;
};

// Turns the edge k of triangle t over in its quad, unless a triangle would then face inwards or the new edge
// is there already.
inline void turn_over(knit::Mesh& mesh, std::map<std::array<knit::VertexId, 2>, std::size_t>& triangle_at,
                      std::size_t t, std::size_t k) {
  const auto& p = mesh.positions;
  const auto outward = [&](const knit::Triangle& f) {
    const glm::dvec3 normal = glm::cross(p[f[1]] - p[f[0]], p[f[2]] - p[f[0]]);
    return glm::dot(normal, p[f[0]]) > 0.05 * glm::dot(p[f[1]] - p[f[0]], p[f[1]] - p[f[0]]);
  };
  const auto [a, b, c] =
      std::array{mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]};
  const std::size_t s = triangle_at.at({b, a});
  const knit::Triangle& other = mesh.triangles[s];
  const knit::VertexId d = other[0] + other[1] + other[2] - a - b;
  const knit::Triangle one{c, a, d};
  const knit::Triangle two{d, b, c};
  if (triangle_at.count({c, d}) > 0 || triangle_at.count({d, c}) > 0 || !outward(one) || !outward(two))
    return;
  triangle_at.erase({a, b});
  triangle_at.erase({b, a});
  mesh.triangles[t] = one;
  mesh.triangles[s] = two;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle_at[{one[i], one[(i + 1) % 3]}] = t;
    triangle_at[{two[i], two[(i + 1) % 3]}] = s;
  }
}

// An icosphere whose vertices have slid about and whose edges are turned over at random: needles and caps.
inline knit::Mesh rough_sphere(unsigned subdivisions, unsigned seed) {
  knit::Mesh mesh = knit::icosphere(subdivisions);
  mesh.edges.clear();
  Dice dice(seed);
  const double slide =
      0.4 * glm::distance(mesh.positions[mesh.triangles[0][0]], mesh.positions[mesh.triangles[0][1]]);
  for (glm::dvec3& p : mesh.positions) {
    const glm::dvec3 by{dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)};
    p = glm::normalize(p + slide * by);
  }
  std::map<std::array<knit::VertexId, 2>, std::size_t> triangle_at;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      triangle_at[{mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]}] = t;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::size_t triangle = dice.below(mesh.triangles.size());  // before the edge, whatever the compiler
    turn_over(mesh, triangle_at, triangle, dice.below(3));
  }
  return mesh;
}

// With vertices and triangles in another order. `moved` says where each vertex went.
struct Shuffled {
  knit::Mesh mesh;
  std::vector<knit::VertexId> moved;
};
inline Shuffled shuffled(const knit::Mesh& mesh, unsigned seed) {
  Dice dice(seed);
  Shuffled result{mesh, std::vector<knit::VertexId>(mesh.positions.size())};
  std::iota(result.moved.begin(), result.moved.end(), knit::VertexId{0});
  for (std::size_t i = result.moved.size(); i > 1; --i)
    std::swap(result.moved[i - 1], result.moved[dice.below(i)]);
  for (std::size_t v = 0; v < result.moved.size(); ++v)
    result.mesh.positions[result.moved[v]] = mesh.positions[v];
  for (knit::Triangle& triangle : result.mesh.triangles) {
    for (knit::VertexId& v : triangle) v = result.moved[v];
    std::rotate(triangle.begin(), triangle.begin() + static_cast<std::ptrdiff_t>(dice.below(3)),
                triangle.end());
  }
  for (std::size_t i = result.mesh.triangles.size(); i > 1; --i)
    std::swap(result.mesh.triangles[i - 1], result.mesh.triangles[dice.below(i)]);
  return result;
}

// p -> scale * p + shift.
inline knit::Mesh placed(knit::Mesh mesh, const glm::dvec3& scale,
                         const glm::dvec3& shift = glm::dvec3(0.0)) {
  for (glm::dvec3& p : mesh.positions) p = scale * p + shift;
  return mesh;
}

}  // namespace test_support
