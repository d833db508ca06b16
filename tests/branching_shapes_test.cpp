// The examples that branch: closed, outward, of the right genus, of decent triangles.
#include "knit/mesh/branching_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <set>

#include "knit/import/check.h"
#include "knit/mesh/evening.h"
#include "knit/mesh/implicit.h"
#include "knit/mesh/shapes.h"
#include "knit/mesh/solids.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"

using namespace knit;

namespace {

struct Shape {
  const char* name;
  Mesh (*make)(double edge);
  double edge;  // the example's
  long genus;
  glm::dvec3 size;
};

const std::vector<Shape> shapes{{"heel", heel, 0.06, 0, {2.34, 2.19, 0.84}},
                                {"trousers", trousers, 0.06, 0, {1.26, 2.43, 0.81}},
                                {"y", letter_y, 0.055, 0, {1.98, 2.63, 0.60}},
                                {"starfish", starfish, 0.05, 0, {2.60, 2.48, 0.62}},
                                {"octopus", octopus, 0.07, 0, {2.23, 2.55, 2.23}},
                                {"mug", mug, 0.066, 1, {2.10, 1.60, 1.48}},
                                {"cup", cup, 0.07, 0, {1.98, 1.72, 1.98}},
                                {"double-torus", double_torus, 0.06, 2, {1.40, 2.56, 0.43}},
                                {"chain-of-three", chain_of_three, 0.055, 3, {1.10, 2.94, 1.10}}};

// Of this build.
std::vector<Shape> tried() {
  std::vector<Shape> some;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (test_support::is_tried(i)) some.push_back(shapes[i]);
  }
  return some;
}

double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += glm::dot(mesh.positions[a], glm::cross(mesh.positions[b], mesh.positions[c])) / 6.0;
  return sum;
}

// In degrees; 0 for a triangle without area.
double least_angle(const Mesh& mesh) {
  double least = 180.0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 one = mesh.positions[t[(k + 1) % 3]] - mesh.positions[t[k]];
      const glm::dvec3 other = mesh.positions[t[(k + 2) % 3]] - mesh.positions[t[k]];
      const double angle = std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
      least = std::min(least, angle * 180.0 / std::numbers::pi);
    }
  }
  return least;
}

std::size_t pieces(const Mesh& mesh) {
  std::vector<VertexId> root(mesh.positions.size());
  for (std::size_t v = 0; v < root.size(); ++v) root[v] = static_cast<VertexId>(v);
  const auto root_of = [&](VertexId v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    root[root_of(a)] = root_of(b);
    root[root_of(b)] = root_of(c);
  }
  std::set<VertexId> roots;
  for (std::size_t v = 0; v < root.size(); ++v) roots.insert(root_of(static_cast<VertexId>(v)));
  return roots.size();
}

// Every directed edge once, with its opposite; the edges listed are these; around every vertex its triangles are one
// fan: as many different neighbours as triangles, and one cycle of them.
void check_closed(const Mesh& mesh) {
  std::map<std::array<VertexId, 2>, int> uses;
  std::vector<std::map<VertexId, VertexId>> link(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++uses[{t[k], t[(k + 1) % 3]}];
      link[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
    }
  }
  bool closed = true;
  for (const auto& [edge, count] : uses)
    closed = closed && count == 1 && edge[0] != edge[1] && uses.count({edge[1], edge[0]}) == 1;
  CHECK(closed);
  CHECK(mesh.edges.size() * 2 == uses.size());
  bool fans = true;
  for (const auto& next : link) {
    if (next.empty()) {
      fans = false;
      continue;
    }
    std::size_t walked = 0;
    VertexId at = next.begin()->first;
    do {
      const auto step = next.find(at);
      if (step == next.end()) break;
      at = step->second;
      ++walked;
    } while (at != next.begin()->first && walked <= next.size());
    fans = fans && walked == next.size();
  }
  CHECK(fans);
}

long euler(const Mesh& mesh) {
  return static_cast<long>(mesh.positions.size()) - static_cast<long>(mesh.edges.size()) +
         static_cast<long>(mesh.triangles.size());
}

}  // namespace

TEST_CASE("branching shapes: closed, in one piece, outward, of the right genus", "[shapes]") {
  for (const Shape& shape : tried()) {
    for (const double edge : {shape.edge, 0.08}) {
      const Mesh mesh = shape.make(edge);
      INFO(shape.name << " with edges of " << edge);
      CHECK(mesh.name == shape.name);
      check_closed(mesh);
      CHECK(euler(mesh) == 2 - 2 * shape.genus);
      CHECK(pieces(mesh) == 1);
      CHECK(volume(mesh) > 0.3);
      CHECK(check(mesh).findings.empty());
    }
  }
}

TEST_CASE("branching shapes: triangles are near equilateral and about as large as asked", "[shapes]") {
  for (const Shape& shape : tried()) {
    const Mesh mesh = shape.make(shape.edge);
    INFO(shape.name);
    CHECK(mesh.triangles.size() >= 2000);
    CHECK(mesh.triangles.size() <= 8000);
    CHECK(least_angle(mesh) > 25.0);
    double sum = 0.0;
    for (const auto& [a, b] : mesh.edges) {
      const double length = glm::distance(mesh.positions[a], mesh.positions[b]);
      CHECK(length > 0.5 * shape.edge);
      CHECK(length < 1.8 * shape.edge);
      sum += length;
    }
    CHECK(sum / static_cast<double>(mesh.edges.size()) == Approx(1.1 * shape.edge).epsilon(0.08));
  }
}

TEST_CASE("branching shapes: sizes, and what stands for which direction", "[shapes]") {
  for (const Shape& shape : tried()) {
    const Bounds bounds = bounds_of(shape.make(shape.edge).positions);
    INFO(shape.name);
    const glm::dvec3 size = bounds.high - bounds.low;
    for (int k = 0; k < 3; ++k) CHECK(size[k] == Approx(shape.size[k]).margin(0.02));
  }
  const Bounds starry = bounds_of(starfish(0.05).positions);
  CHECK(starry.high.y > 1.3);  // an arm is up, and none is down
  CHECK(starry.low.y > -1.2);
  const Bounds handled = bounds_of(mug(0.066).positions);
  CHECK(handled.high.x > 1.3);
  CHECK(handled.low.x > -0.8);
}

TEST_CASE("branching shapes: the same bits every time", "[shapes]") {
  for (const Shape& shape : tried()) {
    const Mesh once = shape.make(0.08);
    const Mesh again = shape.make(0.08);
    INFO(shape.name);
    CHECK(once.positions == again.positions);
    CHECK(once.triangles == again.triangles);
    CHECK(once.edges == again.edges);
  }
}

TEST_CASE("branching shapes: cup and mug have a level rim, its vertices last and in order", "[shapes]") {
  for (const Mesh& mesh : {cup(0.07), mug(0.066)}) {
    INFO(mesh.name);
    const double top = mesh.positions.back().y;
    std::size_t first = mesh.positions.size();
    while (first > 0 && mesh.positions[first - 1].y == top) --first;
    const std::size_t count = mesh.positions.size() - first;
    CHECK(count > 50);
    for (std::size_t v = 0; v < first; ++v) CHECK(mesh.positions[v].y < top);
    const std::set<std::array<VertexId, 2>> edges(mesh.edges.begin(), mesh.edges.end());
    const double radius = std::sqrt(mesh.positions[first].x * mesh.positions[first].x +
                                    mesh.positions[first].z * mesh.positions[first].z);
    for (std::size_t i = 0; i < count; ++i) {
      const auto here = static_cast<VertexId>(first + i);
      const auto next = static_cast<VertexId>(first + (i + 1) % count);
      CHECK(edges.count({std::min(here, next), std::max(here, next)}) == 1);
      CHECK(std::hypot(mesh.positions[here].x, mesh.positions[here].z) == Approx(radius));
    }
  }
}

TEST_CASE("surface_of: any field gives a closed surface", "[shapes]") {
  const GridBlock block{{-1.3, -1.3, -1.3}, {1.3, 1.3, 1.3}};
  const Solid shell = [](const glm::dvec3& p) { return std::abs(glm::length(p) - 0.8) - 0.2; };
  const Mesh spheres = surface_of(shell, block, 0.1);
  CHECK(pieces(spheres) == 2);
  CHECK(volume(spheres) == Approx(4.0 / 3.0 * std::numbers::pi * (1.0 - 0.216)).epsilon(0.02));
  // Zero at very many of the grid's points, which counts as outside.
  const Solid steps = [](const glm::dvec3& p) {
    return std::max({std::round(8.0 * std::abs(p.x)), std::round(8.0 * std::abs(p.y)),
                     std::round(8.0 * std::abs(p.z))}) -
           6.0;
  };
  for (const Solid& solid : {shell, steps}) {
    Mesh mesh = surface_of(solid, block, 0.125);
    REQUIRE_FALSE(mesh.triangles.empty());
    std::set<std::array<VertexId, 2>> edges;
    for (const Triangle& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        edges.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
    mesh.edges.assign(edges.begin(), edges.end());
    check_closed(mesh);
  }
  CHECK(surface_of([](const glm::dvec3&) { return 1.0; }, block, 0.1).triangles.empty());
}

TEST_CASE("evened: vertices lie on the surface", "[shapes]") {
  const Solid ball = [](const glm::dvec3& p) { return ball_distance(p, {{0.1, 0.2, 0.3}, 0.9}); };
  const Mesh mesh = evened(surface_of(ball, {{-1.0, -1.0, -1.0}, {1.3, 1.3, 1.4}}, 0.09), ball, 0.1);
  check_closed(mesh);
  CHECK(euler(mesh) == 2);
  CHECK(least_angle(mesh) > 25.0);
  double farthest = 0.0;
  for (const glm::dvec3& p : mesh.positions) farthest = std::max(farthest, std::abs(ball(p)));
  CHECK(farthest < 1e-9);
}

TEST_CASE("solids: distances, and what melts", "[shapes]") {
  CHECK(ball_distance({0.0, 3.0, 0.0}, {{0.0, 1.0, 0.0}, 0.5}) == Approx(1.5));
  const Ball low{{0.0, 0.0, 0.0}, 0.4};
  const Ball high{{0.0, 2.0, 0.0}, 0.2};
  CHECK(limb_distance({1.0, 1.0, 0.0}, low, high) == Approx(0.7));
  CHECK(limb_distance({0.0, -1.0, 0.0}, low, high) == Approx(0.6));
  CHECK(limb_distance({0.0, 3.0, 0.0}, std::vector<Ball>{low, high}) == Approx(0.8));
  CHECK(ring_distance({0.0, 1.0, 0.3}, 1.0, 0.1) == Approx(0.2));
  CHECK(ring_distance({0.0, 0.0, 0.0}, 1.0, 0.1) == Approx(0.9));
  // A quarter turn of radius 1 from (0, -1): its centre is the origin; then up by 2.
  const std::vector<Bend> quarter{{1.0, 0.5 * std::numbers::pi}};
  const BentLine line(-1.0, quarter, 2.0);
  CHECK(glm::length(line.end() - glm::dvec2(1.0, 2.0)) < 1e-12);
  CHECK(line.distance({0.0, -1.5}) == Approx(0.5));
  CHECK(line.distance({0.5, -0.5}) == Approx(1.0 - std::sqrt(0.5)));
  CHECK(line.distance({0.7, 1.0}) == Approx(0.3));
  CHECK(line.distance({1.0, 2.5}) == Approx(0.5));
  CHECK(melted({0.03, 0.5}, 0.1) == Approx(0.03));  // far from the other: as if alone
  CHECK(melted({0.3, 0.5}, 0.1) == Approx(0.3));
  CHECK(melted({0.1, 0.02}, 0.1) == melted({0.02, 0.1}, 0.1));
  CHECK(melted({0.02, 0.02}, 0.1) == Approx(0.1 - 0.08 * std::sqrt(2.0)));  // the furrow is filled
  CHECK(common_part(0.3, -0.5, 0.1) == Approx(0.3));
  CHECK(common_part(-0.02, -0.02, 0.1) == Approx(-0.1 + 0.08 * std::sqrt(2.0)));
}
