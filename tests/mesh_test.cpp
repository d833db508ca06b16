#include "knit/mesh/mesh.h"

#include <cmath>
#include <limits>

#include "knit/mesh/shapes.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

std::vector<VertexId> neighbours(const Input& input, VertexId v) {
  const auto span = input.neighbours_of(v);
  return {span.begin(), span.end()};
}

// Two triangles side by side whose common edge is a seam: 1 and 2 are at the places of 3 and 4.
Mesh seam() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 5, 4}};
  mesh.edges = {{0, 1}, {0, 2}, {1, 2}, {3, 4}, {3, 5}, {4, 5}};
  return mesh;
}

}  // namespace

TEST_CASE("mesh: twins are the lowest index at exactly the same place", "[mesh]") {
  const double tiny = std::nextafter(1.0, 2.0);
  CHECK(find_twins({{0, 0, 1}, {1, 2, 3}, {-0.0, 0, 1}, {1, 2, 3}, {1, 2, 3}}) ==
        std::vector<VertexId>{0, 1, 0, 1, 1});
  CHECK(find_twins({{1, 0, 0}, {tiny, 0, 0}, {0, 1, 0}, {0, 0, 1}}) == std::vector<VertexId>{0, 1, 2, 3});
  CHECK(find_twins({}).empty());
}

TEST_CASE("mesh: many vertices that are no numbers are no slower than others", "[mesh]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<glm::dvec3> positions(300000, glm::dvec3(nan, 0, 0));
  CHECK(find_twins(positions).size() == positions.size());
}

TEST_CASE("mesh: bounds", "[mesh]") {
  const Bounds bounds = bounds_of({{1, -2, 3}, {-1, 2, 7}});
  CHECK(bounds.low == glm::dvec3(-1, -2, 3));
  CHECK(bounds.high == glm::dvec3(1, 2, 7));
  CHECK(bounds.centre() == glm::dvec3(0, 0, 5));
  CHECK(bounds.diagonal() == Approx(6.0));
  CHECK(bounds_of({}).diagonal() == 0.0);
  CHECK(std::isfinite(bounds_of({{-1e300, 0, 0}, {1e300, 1e300, 0}}).diagonal()));
}

TEST_CASE("mesh: welding merges a seam and keeps the order", "[mesh]") {
  const Mesh welded = weld(seam());
  CHECK(welded.positions == std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  CHECK(welded.triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
  CHECK(welded.edges == std::vector<std::array<VertexId, 2>>{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}});
}

TEST_CASE("mesh: welding drops what collapses, and leaves indices out of range out of range", "[mesh]") {
  Mesh mesh = seam();
  mesh.triangles.push_back({1, 3, 5});  // 1 and 3 are one place
  mesh.triangles.push_back({0, 1, 5});
  mesh.triangles.push_back({60, 1, 60});
  const Mesh welded = weld(mesh);
  REQUIRE(welded.triangles.size() == 4);
  CHECK(welded.triangles[2] == Triangle{0, 1, 3});
  CHECK(welded.triangles[3] == Triangle{60, 1, 60});
}

TEST_CASE("mesh: neighbours are read across a seam", "[mesh]") {
  const auto input = make_input(seam());
  CHECK(input->twin == std::vector<VertexId>{0, 1, 2, 1, 2, 5});
  CHECK(neighbours(*input, 0) == std::vector<VertexId>{1, 2});
  CHECK(neighbours(*input, 1) == std::vector<VertexId>{0, 2, 5});
  CHECK(neighbours(*input, 3) == neighbours(*input, 1));
  CHECK(neighbours(*input, 5) == std::vector<VertexId>{1, 2});
  CHECK(input->adjacent(0, 4));
  CHECK(input->adjacent(3, 2));
  CHECK_FALSE(input->adjacent(0, 5));
  CHECK_FALSE(input->adjacent(1, 3));
}

TEST_CASE("mesh: the centroid counts each used place once", "[mesh]") {
  Mesh mesh = seam();
  mesh.positions.push_back({100, 100, 100});
  const auto input = make_input(mesh);
  CHECK(input->centroid == glm::dvec3(0.5, 0.5, 0));
  CHECK(input->bounds.high == glm::dvec3(1, 1, 0));
  CHECK(input->referenced == std::vector<std::uint8_t>{1, 1, 1, 1, 1, 1, 0});
  CHECK(neighbours(*input, 6).empty());
}

TEST_CASE("mesh: neighbours are ascending and mutual, 6 on average on a closed surface", "[mesh]") {
  const auto input = make_input(sphere(16, 9, true));
  std::size_t places = 0;
  for (VertexId v = 0; v < input->twin.size(); ++v) {
    if (input->twin[v] != v) continue;
    ++places;
    VertexId last = 0;
    for (const VertexId other : input->neighbours_of(v)) {
      CHECK((last == 0 || other > last));
      CHECK(input->twin[other] == other);
      CHECK(input->adjacent(other, v));
      last = other;
    }
  }
  CHECK(places == 2 + 8 * 16);
  CHECK(input->neighbours.size() == 6 * places - 12);  // twice the edges: 3 V - 6
  CHECK(input->first_neighbour.size() == input->twin.size() + 1);
}

TEST_CASE("mesh: one can walk across a seam, and round a triangle that has collapsed", "[mesh]") {
  Mesh mesh = seam();
  mesh.triangles.insert(mesh.triangles.begin(), {1, 2, 3});  // 1 and 3 are one place
  mesh.positions.push_back({100, 100, 100});
  const auto input = make_input(mesh);
  std::vector<HalfEdge> across(9, no_half_edge);
  across[4] = 8;  // from 1 to 2, and from 4 to 3
  across[8] = 4;
  CHECK(input->across == across);
  CHECK(input->first_corner == std::vector<HalfEdge>{3, 6, 8, no_half_edge, no_half_edge, 7, no_half_edge});
}

TEST_CASE("mesh: on a closed surface every side has one across, which leads back", "[mesh]") {
  const auto input = make_input(sphere(16, 9, true));
  const auto& triangles = input->mesh.triangles;
  const auto ends = [&](HalfEdge h) {
    const VertexId a = input->twin[triangles[h / 3][h % 3]];
    const VertexId b = input->twin[triangles[h / 3][(h + 1 - h / 3 * 3) % 3]];
    return std::array{a, b};
  };
  REQUIRE(input->across.size() == 3 * triangles.size());
  for (HalfEdge h = 0; h < input->across.size(); ++h) {
    const HalfEdge other = input->across[h];
    REQUIRE(other < input->across.size());
    CHECK(input->across[other] == h);
    CHECK(ends(other) == std::array{ends(h)[1], ends(h)[0]});
    CHECK(input->first_corner[ends(h)[0]] != no_half_edge);
  }
}

TEST_CASE("mesh: an empty mesh makes an empty input", "[mesh]") {
  const auto input = make_input({});
  CHECK(input->neighbours.empty());
  CHECK(input->bounds.diagonal() == 0.0);
}
