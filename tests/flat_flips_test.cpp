// Flat parts of a surface get Delaunay triangles; whatever is not flat stays.
#include "knit/mesh/flat_flips.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "knit/mesh/polygon.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

bool has_edge(const std::vector<Triangle>& triangles, VertexId a, VertexId b) {
  return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return std::count(t.begin(), t.end(), a) + std::count(t.begin(), t.end(), b) == 2;
  });
}

// A kite whose long diagonal runs from 0 to 2, and whose tip may be lifted out of the plane.
std::vector<glm::dvec3> kite(double lift) {
  return {{-3.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 1.0, lift}};
}

}  // namespace

TEST_CASE("flat flips: the long diagonal of a flat kite gives way to the short one", "[flat_flips]") {
  std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}};
  CHECK(flip_flat_edges(triangles, kite(0.0)) == 1);
  CHECK(has_edge(triangles, 1, 3));
  CHECK_FALSE(has_edge(triangles, 0, 2));
  const auto positions = kite(0.0);
  for (const Triangle& t : triangles)
    CHECK(glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]).z > 0.0);
  CHECK(flip_flat_edges(triangles, positions) == 0);
}

TEST_CASE("flat flips: an edge of the shape stays", "[flat_flips]") {
  std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}};
  CHECK(flip_flat_edges(triangles, kite(0.5)) == 0);
  CHECK(has_edge(triangles, 0, 2));
}

TEST_CASE("flat flips: no edge is made that is there already", "[flat_flips]") {
  std::vector<glm::dvec3> positions = kite(0.0);
  positions.emplace_back(0.0, 0.0, 1.0);
  std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}, {1, 3, 4}};
  CHECK(flip_flat_edges(triangles, positions) == 0);
}

TEST_CASE("flat flips: corners on one circle keep their diagonal", "[flat_flips]") {
  const std::vector<glm::dvec3> square{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}};
  for (const bool other : {false, true}) {
    std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}};
    if (other) triangles = {{0, 1, 3}, {1, 2, 3}};
    const std::vector<Triangle> before = triangles;
    CHECK(flip_flat_edges(triangles, square) == 0);
    CHECK(triangles == before);
  }
}

TEST_CASE("flat flips: a polygon keeps its area, its direction and its rim", "[flat_flips]") {
  // An L whose corner is far from its ends.
  const std::vector<glm::dvec3> positions{{0.0, 0.0, 0.0}, {9.0, 0.0, 0.0}, {9.0, 1.0, 0.0},
                                          {1.0, 1.0, 0.0}, {1.0, 9.0, 0.0}, {0.0, 9.0, 0.0}};
  const std::vector<VertexId> corners{0, 1, 2, 3, 4, 5};
  std::vector<Triangle> triangles;
  triangulate(corners, positions, triangles);
  REQUIRE(triangles.size() == 4);
  double area = 0.0;
  for (const Triangle& t : triangles) {
    const double doubled = glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]).z;
    CHECK(doubled > 0.0);
    area += 0.5 * doubled;
  }
  CHECK(area == Approx(17.0));
  for (VertexId v = 0; v < 6; ++v) CHECK(has_edge(triangles, v, (v + 1) % 6));
}
