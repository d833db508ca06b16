// Cycles laid into a mesh as rings of edges: the surface stays what it was, and the ring is where it was drawn, on
// whatever triangles.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "knit/curves/cut.h"
#include "knit/curves/embed.h"
#include "knit/curves/level_loop.h"
#include "knit/curves/shortest_way.h"
#include "knit/mesh/shapes.h"
#include "knit/mesh/surface_distance.h"
#include "tests/support/bodies.h"
#include "tests/support/cycles.h"

using namespace knit;
using namespace test_support;

namespace {

double area_of_all(const Mesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const auto& p = mesh.positions;
    sum += 0.5 * glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
  }
  return sum;
}

CutSizes sizes_of(const Mesh& mesh) {
  return {.diagonal = bounds_of(mesh.positions).diagonal(), .radius = 0.1, .up = {0.0, 1.0, 0.0}};
}

using Line = std::vector<glm::dvec3>;

Line places_of(const Mesh& mesh, const std::vector<VertexId>& ring) {
  Line line;
  for (const VertexId v : ring) line.push_back(mesh.positions[v]);
  return line;
}

double away_from(const glm::dvec3& point, const Line& line) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < line.size(); ++i) {
    const glm::dvec3 side = line[(i + 1) % line.size()] - line[i];
    const double along = std::clamp(glm::dot(point - line[i], side) / glm::dot(side, side), 0.0, 1.0);
    least = std::min(least, glm::length(line[i] + along * side - point));
  }
  return least;
}

// The farthest that a point of one closed line is from the other line.
double apart(const Line& a, const Line& b) {
  double most = 0.0;
  for (const glm::dvec3& point : a) most = std::max(most, away_from(point, b));
  for (const glm::dvec3& point : b) most = std::max(most, away_from(point, a));
  return most;
}

// Every edge has two triangles still, the surface is as large as it was, and no triangle is without area.
void check_whole(const Mesh& before, const Mesh& after) {
  CHECK(boundary_rings(after.triangles).size() == boundary_rings(before.triangles).size());
  CHECK(area_of_all(after) == Approx(area_of_all(before)).epsilon(1e-12));
  for (const Triangle& t : after.triangles) {
    const auto& p = after.positions;
    CHECK(glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])) > 0.0);
  }
  const auto count = [](std::size_t size) { return static_cast<std::ptrdiff_t>(size); };
  CHECK(count(after.positions.size()) - count(edges_of(after.triangles).size()) +
            count(after.triangles.size()) ==
        count(before.positions.size()) - count(edges_of(before.triangles).size()) +
            count(before.triangles.size()));
}

void check_ring(const Mesh& mesh, const std::vector<VertexId>& ring) {
  const std::vector<EdgeKey> edges = edges_of(mesh.triangles);
  std::vector<VertexId> once = ring;
  std::sort(once.begin(), once.end());
  CHECK(std::adjacent_find(once.begin(), once.end()) == once.end());
  for (std::size_t i = 0; i < ring.size(); ++i)
    CHECK(std::binary_search(edges.begin(), edges.end(), edge_key(ring[i], ring[(i + 1) % ring.size()])));
}

}  // namespace

TEST_CASE("curves cut: a circle is where the surface is so far away", "[curves]") {
  const Mesh before = icosphere(4);
  Mesh mesh = sewn(before);
  const auto ring = cut_cycle(mesh, circle_at(on_ball(2.4, 0.5), 0.6, CycleEnd::start), sizes_of(mesh));
  check_whole(before, mesh);
  check_ring(mesh, ring);
  for (const VertexId v : ring) {
    const double angle = std::acos(glm::dot(glm::normalize(mesh.positions[v]), on_ball(2.4, 0.5)));
    CHECK(angle == Approx(0.6).margin(0.006));
  }
  CHECK(std::equal(before.positions.begin(), before.positions.end(), mesh.positions.begin()));
}

TEST_CASE("curves cut: only along the ring that was chosen", "[curves]") {
  // A plane across both arms of a ring shape.
  const Mesh before = torus(48, 24, 1.0, 0.3);
  Mesh mesh = sewn(before);
  Cycle plane = through(CycleKind::plane, {{1.3, 0.0, 0.0}}, CycleEnd::start);
  plane.normal = {0.0, 0.1, 1.0};
  const auto ring = cut_cycle(mesh, plane, sizes_of(mesh));
  check_whole(before, mesh);
  check_ring(mesh, ring);
  for (std::size_t v = before.positions.size(); v < mesh.positions.size(); ++v)
    CHECK(mesh.positions[v].x > 0.0);
  for (const VertexId v : ring)
    CHECK(std::abs(glm::dot(mesh.positions[v], glm::dvec3(0.0, 0.1, 1.0))) < 0.01);
}

TEST_CASE("curves cut: a vertex close to the level is taken in place of a sliver", "[curves]") {
  const Mesh ball = icosphere(3);
  std::vector<double> heights;
  for (const glm::dvec3& p : ball.positions) heights.push_back(p.y);
  const LevelLines lines = level_lines(ball, heights, 0.001);
  REQUIRE(lines.rings.size() == 1);
  CHECK(lines.open.empty());
  std::size_t at_vertices = 0;
  for (const EdgePlace& place : lines.rings[0]) {
    if (place.vertex()) ++at_vertices;
    if (!place.vertex()) CHECK(std::min(place.along, 1.0 - place.along) > 0.02);
  }
  CHECK(at_vertices > 10);
}

TEST_CASE("curves cut: points are set into triangles, on edges or taken as they are", "[curves]") {
  const Mesh before = icosphere(2);
  const Triangle t = before.triangles[7];
  const std::array<glm::dvec3, 3> p{before.positions[t[0]], before.positions[t[1]], before.positions[t[2]]};
  Mesh mesh = before;
  CHECK(insert_point(mesh, p[0] + 0.01 * (p[1] - p[0])) == t[0]);
  CHECK(mesh.triangles == before.triangles);
  CHECK(insert_point(mesh, 0.4 * p[0] + 0.3 * p[1] + 0.3 * p[2]) == before.positions.size());
  CHECK(mesh.triangles.size() == before.triangles.size() + 2);
  check_whole(before, mesh);
  Mesh split = before;
  const VertexId middle = insert_point(split, 0.5 * (p[1] + p[2]));
  CHECK(glm::length(split.positions[middle] - 0.5 * (p[1] + p[2])) < 1e-12);
  CHECK(split.triangles.size() == before.triangles.size() + 2);
  check_whole(before, split);
}

TEST_CASE("curves cut: ways are hardly longer than the shortest", "[curves]") {
  const Mesh ball = icosphere(3);
  const auto input = make_input(ball);
  std::vector<VertexId> all;
  for (VertexId v = 0; v < ball.positions.size(); ++v) all.push_back(v);
  const std::vector<double> exact = surface_distances(*input, 0, all);
  const VertexId source = 0;
  const std::vector<double> found = ShortestWays(ball, 1.0).distances(std::span(&source, 1));
  double most = 1.0;
  for (const VertexId v : all) {
    CHECK(found[v] >= exact[v] - 1e-9);
    if (v != 0) most = std::max(most, found[v] / exact[v]);
  }
  CHECK(most < 1.03);
}

TEST_CASE("curves cut: four clicks follow the rim of a lid", "[curves]") {
  const Mesh before = cylinder(32, 1.0, 2.0, 8);
  for (const double height : {0.0, 2.0}) {
    Mesh mesh = sewn(before);
    std::vector<glm::dvec3> clicks;
    for (int i = 0; i < 4; ++i) {
      const TurnPoint at = turn_point(2 * static_cast<unsigned long>(i), 8);
      clicks.emplace_back(at.sine, height, -at.cosine);
    }
    const auto ring = cut_cycle(mesh, through(CycleKind::path, clicks, CycleEnd::start), sizes_of(mesh));
    CHECK(ring.size() == 32);
    for (const VertexId v : ring) CHECK(mesh.positions[v].y == height);
    check_whole(before, mesh);
  }
}

TEST_CASE("curves cut: without the rule for creases a way cuts across the lid", "[curves]") {
  const Mesh mesh = cylinder(32, 1.0, 2.0, 8);
  std::vector<VertexId> rim;
  for (VertexId v = 0; v < mesh.positions.size(); ++v)
    if (mesh.positions[v].y == 0.0 && glm::length(mesh.positions[v]) > 0.99) rim.push_back(v);
  const auto inside = [&](const std::vector<EdgePlace>& way) {
    return std::any_of(way.begin(), way.end(),
                       [&](const EdgePlace& place) { return glm::length(place.position(mesh)) < 0.9; });
  };
  CHECK(inside(ShortestWays(mesh, 1.0).way(rim[0], rim[8])));
  CHECK_FALSE(inside(ShortestWays(mesh).way(rim[0], rim[8])));
}

TEST_CASE("curves cut: the same curves on three triangulations of a sphere", "[curves]") {
  constexpr double width = 0.1;
  const Cycle circle = circle_at(on_ball(2.4, 0.5), 0.6, CycleEnd::start);
  const Cycle path =
      through(CycleKind::path, {on_ball(0.8, 0.3), on_ball(0.6, 1.6), on_ball(0.7, 3.0), on_ball(0.9, 4.6)},
              CycleEnd::end);
  for (const Cycle& cycle : {circle, path}) {
    std::vector<Line> lines;
    for (const Mesh& ball : {icosphere(4), icosphere(3), sphere(30, 17)}) {
      Mesh mesh = sewn(ball);
      lines.push_back(places_of(mesh, cut_cycle(mesh, cycle, sizes_of(mesh))));
    }
    for (std::size_t i = 1; i < lines.size(); ++i) {
      INFO(word_of(cycle.kind) << " on triangulation " << i << ": " << apart(lines[0], lines[i]) / width
                               << " w");
      CHECK(apart(lines[0], lines[i]) < 0.5 * width);
    }
  }
}

TEST_CASE("curves cut: a band is as wide as it says", "[curves]") {
  const Mesh before = cylinder(48, 1.0, 4.0, 24);
  Mesh mesh = sewn(before);
  Cycle band = through(CycleKind::band, {{1.0, 1.5, 0.0}, {1.0, 2.5, 0.0}}, CycleEnd::start);
  band.radius = 0.5;
  const auto ring = cut_cycle(mesh, band, sizes_of(mesh));
  check_whole(before, mesh);
  check_ring(mesh, ring);
  for (const VertexId v : ring) {
    const glm::dvec3& p = mesh.positions[v];
    const double round = std::atan2(p.z, p.x);
    const double beyond = p.y - std::clamp(p.y, 1.5, 2.5);
    CHECK(std::hypot(round, beyond) == Approx(0.5).margin(0.02));
  }
}
