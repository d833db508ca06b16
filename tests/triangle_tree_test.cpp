#include "knit/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "knit/mesh/shapes.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
const Corners right_angle{glm::dvec3(0, 0, 0), glm::dvec3(4, 0, 0), glm::dvec3(0, 3, 0)};

// Numbers in [-1, 1), the same in every run.
class Numbers {
 public:
  double next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 11U) / 4503599627370496.0 - 1.0;
  }
  glm::dvec3 point(double size) { return {size * next(), size * next(), size * next()}; }

 private:
  std::uint64_t state_ = 7;
};

double by_trying_all(const Mesh& mesh, const glm::dvec3& point) {
  double best = infinite;
  for (const auto& [a, b, c] : mesh.triangles) {
    best = std::min(best,
                    distance_to_triangle(point, {mesh.positions[a], mesh.positions[b], mesh.positions[c]}));
  }
  return best;
}

// Scattered small triangles, every fourth one without area: a line, or a point.
Mesh scattered(std::size_t count) {
  Numbers numbers;
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 first = numbers.point(1.0);
    const glm::dvec3 side = numbers.point(0.1);
    const auto v = static_cast<VertexId>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {first, first + side, first + numbers.point(0.1)});
    if (i % 4 == 1) mesh.positions.back() = first + 3.0 * side;
    if (i % 4 == 3) mesh.positions[v + 1] = mesh.positions[v + 2] = first;
    mesh.triangles.push_back({v, v + 1, v + 2});
  }
  return mesh;
}

}  // namespace

TEST_CASE("triangle tree: distance to a triangle, in each of its regions", "[closeness]") {
  CHECK(distance_to_triangle({1, 1, 2}, right_angle) == Approx(2.0));
  CHECK(distance_to_triangle({1, 1, -2}, right_angle) == Approx(2.0));
  CHECK(distance_to_triangle({1, 1, 0}, right_angle) == 0.0);
  CHECK(distance_to_triangle({2, -3, 4}, right_angle) == Approx(5.0));   // an edge
  CHECK(distance_to_triangle({-3, 1, 4}, right_angle) == Approx(5.0));   // another
  CHECK(distance_to_triangle({5, 5.5, 0}, right_angle) == Approx(5.0));  // the long one
  CHECK(distance_to_triangle({-3, -4, 0}, right_angle) == Approx(5.0));  // a corner
  CHECK(distance_to_triangle({7, -4, 0}, right_angle) == Approx(5.0));
  CHECK(distance_to_triangle({0, 6, 4}, right_angle) == Approx(5.0));
}

TEST_CASE("triangle tree: triangles without area are the lines and points that they are", "[closeness]") {
  const glm::dvec3 a(0, 0, 0);
  const glm::dvec3 b(1, 0, 0);
  const glm::dvec3 c(3, 0, 0);
  CHECK(distance_to_triangle({2, 2, 0}, {a, b, c}) == Approx(2.0));
  CHECK(distance_to_triangle({2, 2, 0}, {a, c, b}) == Approx(2.0));
  CHECK(distance_to_triangle({2, 2, 0}, {c, a, a}) == Approx(2.0));
  CHECK(distance_to_triangle({3, 4, 0}, {a, a, a}) == Approx(5.0));
  const Corners sliver{a, c, glm::dvec3(1.5, 1e-14, 0)};
  CHECK(distance_to_triangle({2, 2, 0}, sliver) == Approx(2.0));
  CHECK(distance_to_triangle({1.5, 0, 3}, sliver) == Approx(3.0));
}

TEST_CASE("triangle tree: finds what trying all finds", "[closeness]") {
  Numbers numbers;
  for (const std::size_t count : {1U, 4U, 5U, 9U, 300U}) {
    const Mesh mesh = scattered(count);
    const TriangleTree tree(mesh.positions, mesh.triangles);
    for (int i = 0; i < 300; ++i) {
      const glm::dvec3 point = numbers.point(1.5);
      CHECK(tree.distance(point) == by_trying_all(mesh, point));
    }
  }
}

TEST_CASE("triangle tree: a closed surface, many triangles at one place, and none", "[closeness]") {
  const Mesh mesh = sphere(24, 13, false);
  const TriangleTree tree(mesh.positions, mesh.triangles);
  Numbers numbers;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 point = numbers.point(1.2);
    CHECK(tree.distance(point) == by_trying_all(mesh, point));
  }
  for (const glm::dvec3& corner : mesh.positions) CHECK(tree.distance(corner) < 1e-15);

  Mesh pile = mesh;
  pile.triangles.assign(1000, mesh.triangles.front());
  CHECK(TriangleTree(pile.positions, pile.triangles).distance({0, 0, 0}) == by_trying_all(pile, {0, 0, 0}));
  CHECK(TriangleTree(mesh.positions, {}).distance({0, 0, 0}) == infinite);
}
