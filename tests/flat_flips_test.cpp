// Flat parts of a surface get Delaunay triangles; whatever is not flat stays.
#include "knit/mesh/flat_flips.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "knit/mesh/polygon.h"
#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"
#include "tests/support/catch.h"
#include "tests/support/rough_sphere.h"

using namespace knit;
using test_support::Dice;

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

// A box whose faces are grids of points that stand a little off, each cell with one of its diagonals as `dice` has it.
Mesh box_cut_by(std::uint32_t seed) {
  constexpr std::uint32_t cells = 8;
  const glm::dvec3 size{1.0, 1.5, 0.8};
  Mesh mesh;
  Dice off(3), diagonal(seed);
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool far : {false, true}) {
      const auto first = static_cast<VertexId>(mesh.positions.size());
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (std::uint32_t i = 0; i <= cells; ++i) {
        for (std::uint32_t j = 0; j <= cells; ++j) {
          const auto inside = [&](std::uint32_t k) { return k > 0 && k < cells; };
          glm::dvec3 p{0.0, 0.0, 0.0};
          p[axis] = far ? size[axis] : 0.0;
          const double du = off.between(-0.25, 0.25), dv = off.between(-0.25, 0.25);
          const bool moves = inside(i) && inside(j);
          p[u] = size[u] * (i + (moves ? du : 0.0)) / cells;
          p[v] = size[v] * (j + (moves ? dv : 0.0)) / cells;
          mesh.positions.push_back(p);
        }
      }
      for (std::uint32_t i = 0; i < cells; ++i) {
        for (std::uint32_t j = 0; j < cells; ++j) {
          const VertexId a = first + i * (cells + 1) + j, b = a + cells + 1, c = b + 1, d = a + 1;
          std::array<Triangle, 2> two{Triangle{a, b, c}, Triangle{a, c, d}};
          if (diagonal.below(2) == 1) two = {Triangle{a, b, d}, Triangle{b, c, d}};
          for (Triangle t : two) {
            if (!far) std::swap(t[1], t[2]);
            mesh.triangles.push_back(t);
          }
        }
      }
    }
  }
  return weld(mesh);
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

TEST_CASE("flat flips: however flat sides are cut into triangles, rows and stitches are the same",
          "[flat_flips]") {
  for (const TimingKind timing : {TimingKind::geodesic, TimingKind::harmonic}) {
    std::vector<std::int32_t> first;
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
      const auto input = make_input(box_cut_by(seed));
      Parameters parameters = default_parameters(input->bounds);
      parameters.timing.kind = timing;
      parameters.rows.source = RowSource::contours;
      Timeline timeline(input, resolved(parameters, *input));
      timeline.extend_to({Stage::stitches, 0, 0});
      std::vector<std::int32_t> counts;
      for (const auto& row : timeline.furthest().fabric.rows()) counts.push_back(size_of(*row));
      CAPTURE(timing, seed, counts.size());
      REQUIRE(counts.size() > 10);
      if (first.empty()) first = counts;
      CHECK(counts == first);
    }
  }
}
