// The surface cut at one value of a field.
#include "knit/rows/contour.h"

#include <cmath>
#include <numbers>

#include "tests/support/bodies.h"
#include "tests/support/catch.h"

using namespace knit;
using test_support::field_along;

namespace {

constexpr double pi = std::numbers::pi;
const glm::dvec3 up(0.0, 1.0, 0.0);

struct Cutter {
  std::shared_ptr<const Input> input;
  std::vector<double> field;
  RowFrame frame;
  [[nodiscard]] std::vector<Cut> cut(const std::vector<double>& values) const {
    return cut_surface(*input, field, values, values, frame);
  }
  [[nodiscard]] Cut cut(double value) const { return cut(std::vector{value}).front(); }
};

Cutter cutter_of(const Mesh& mesh, const glm::dvec3& axis = up) {
  const auto input = make_input(mesh);
  return {input, field_along(*input, axis), row_frame(axis, std::nullopt)};
}

// Every loop is a closed polyline at the value, without repeated points, its arcs right, in working order.
void check_sound(const Cutter& cutter, const Cut& cut) {
  std::int32_t points = 0;
  for (const auto& loop : cut.loops) {
    const std::size_t n = loop->points.size();
    points += static_cast<std::int32_t>(n);
    REQUIRE(n >= 3);
    CHECK(loop->ordered_by == OrderedBy::cut);
    CHECK(loop->vertices.empty());
    REQUIRE(loop->arc.size() == n);
    double arc = 0.0;
    double area = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const glm::dvec3& here = loop->points[i];
      const glm::dvec3& next = loop->points[(i + 1) % n];
      CHECK(loop->arc[i] == Approx(arc).margin(1e-12));
      CHECK(here != next);
      arc += glm::distance(here, next);
      area += glm::dot(glm::cross(next - loop->points[0], here - loop->points[0]), cutter.frame.along);
    }
    CHECK(loop->length == Approx(arc));
    CHECK(area > 0.0);
  }
  CHECK(points <= cut.edges + static_cast<std::int32_t>(cut.loops.size()));  // each may begin within an edge
  for (std::size_t i = 1; i < cut.loops.size(); ++i) CHECK(cut.loops[i - 1]->length >= cut.loops[i]->length);
}

double farthest_apart(const Ring& a, const Ring& b) {
  REQUIRE(a.points.size() == b.points.size());
  double far = 0.0;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    far = std::max(far, glm::distance(a.points[i], b.points[i]));
  return far;
}

// Points nearer to the one before than rounding count once.
std::vector<glm::dvec3> places_of(const Ring& ring) {
  std::vector<glm::dvec3> places;
  for (const glm::dvec3& p : ring.points)
    if (places.empty() || glm::distance(p, places.back()) > 1e-12) places.push_back(p);
  while (places.size() > 1 && glm::distance(places.front(), places.back()) <= 1e-12) places.pop_back();
  return places;
}

// Polygons of equally many points over one another, from y = 0 up, one apart, closed by a point at each end.
Mesh loft(const std::vector<std::vector<glm::dvec3>>& layers) {
  const auto n = static_cast<VertexId>(layers.front().size());
  const auto top = static_cast<VertexId>(1 + n * layers.size());
  Mesh mesh;
  mesh.positions.emplace_back(0.0, -1.0, 0.0);
  for (std::size_t j = 0; j < layers.size(); ++j)
    for (const glm::dvec3& p : layers[j]) mesh.positions.emplace_back(p.x, static_cast<double>(j), p.z);
  mesh.positions.emplace_back(0.0, static_cast<double>(layers.size()), 0.0);
  for (VertexId i = 0; i < n; ++i) {
    const VertexId next = (i + 1) % n;
    mesh.triangles.push_back({0, 1 + i, 1 + next});
    for (VertexId low = 1; low + n < top; low += n) {
      mesh.triangles.push_back({low + i, low + n + i, low + n + next});
      mesh.triangles.push_back({low + i, low + n + next, low + next});
    }
    mesh.triangles.push_back({top - n + i, top, top - n + next});
  }
  return mesh;
}

// In the plane of y, at `turn` of a whole one from -z on, in working order about y.
glm::dvec3 polar(double radius, double turn) {
  return {radius * std::sin(2.0 * pi * turn), 0.0, -radius * std::cos(2.0 * pi * turn)};
}

std::vector<glm::dvec3> circle() {
  std::vector<glm::dvec3> points(48);
  for (std::size_t i = 0; i < 48; ++i) points[i] = polar(1.0, static_cast<double>(i) / 48.0);
  return points;
}

}  // namespace

TEST_CASE("contour: a sphere's cuts are circles, whatever the axis", "[contour]") {
  for (const Mesh& mesh : {sphere(128, 65, true), sphere(200, 120), icosphere(5)}) {
    for (const glm::dvec3& axis : test_support::random_axes(4, 11)) {
      const Cutter cutter = cutter_of(mesh, axis);
      const std::vector<double> values{0.1, 0.3, 0.5, 0.7, 0.95};
      const std::vector<Cut> cuts = cutter.cut(values);
      REQUIRE(cuts.size() == values.size());
      for (std::size_t i = 0; i < cuts.size(); ++i) {
        check_sound(cutter, cuts[i]);
        CHECK(cuts[i].time == values[i]);
        REQUIRE(cuts[i].loops.size() == 1);
        const Ring& ring = *cuts[i].loops.front();
        const double along = glm::dot(ring.points[0], axis);
        CHECK(along == Approx(2.0 * values[i] - 1.0).margin(2e-3));
        CHECK(ring.length == Approx(2.0 * pi * std::sqrt(1.0 - along * along)).epsilon(2e-3));
        for (const glm::dvec3& p : ring.points) {
          CHECK(glm::dot(p, axis) == Approx(along).margin(1e-12));
          CHECK(glm::length(p) == Approx(1.0).margin(2e-3));
        }
      }
    }
  }
}

TEST_CASE("contour: a loop begins at the half-plane from its centre on the side where rounds begin",
          "[contour]") {
  for (const glm::dvec3& axis : test_support::random_axes(10, 4)) {
    Cutter cutter = cutter_of(icosphere(4), axis);
    for (const glm::dvec3& side : {glm::dvec3(0, 0, -1), glm::dvec3(3, 0.2, 0), glm::dvec3(-1, 2, 1)}) {
      cutter.frame = row_frame(axis, side);
      const Cut cut = cutter.cut(0.4);
      REQUIRE(cut.loops.size() == 1);
      check_sound(cutter, cut);
      const glm::dvec3& first = cut.loops[0]->points[0];
      CHECK(glm::dot(first, cutter.frame.ahead) == Approx(0.0).margin(1e-3));
      CHECK(glm::dot(first, cutter.frame.right) > 0.9);
      CHECK(glm::dot(cut.loops[0]->points[1], cutter.frame.ahead) > 0.0);
    }
  }
}

TEST_CASE("contour: a level at the vertices of a ring is that ring", "[contour]") {
  const Cutter cutter = cutter_of(sphere(16, 8));
  for (const unsigned ring : {1u, 3u, 4u, 7u}) {
    const VertexId first = 1 + (ring - 1) * 16;
    const Cut cut = cutter.cut(cutter.field[first]);
    check_sound(cutter, cut);
    REQUIRE(cut.loops.size() == 1);
    const Ring& loop = *cut.loops.front();
    const std::vector<glm::dvec3> places = places_of(loop);
    REQUIRE(places.size() == 16);
    CHECK(loop.length == Approx(32.0 * std::sin(pi / 16.0) * std::sin(pi * ring / 8.0)));
    for (VertexId i = 0; i < 16; ++i)
      CHECK(glm::distance(places[i], cutter.input->mesh.positions[first + i]) < 1e-12);
  }
}

TEST_CASE("contour: exactly, between two rings of a cylinder", "[contour]") {
  const Cutter cutter = cutter_of(test_support::cylinder(5, 2.0, 1.0, 2));
  const Cut cut = cutter.cut(0.125);
  check_sound(cutter, cut);
  CHECK(cut.edges == 10);  // each side's edge and diagonal
  REQUIRE(cut.loops.size() == 1);
  const Ring& loop = *cut.loops.front();
  REQUIRE(places_of(loop).size() == 10);
  CHECK(loop.length == Approx(20.0 * std::sin(pi / 5.0)));
  CHECK(glm::distance(loop.points[0], {0.0, 0.125, -2.0}) < 1e-12);
  CHECK(places_of(loop)[1].x > 0.1);
}

TEST_CASE("contour: the order of triangles and vertices, and flipped ones, do not matter", "[contour]") {
  const Mesh mesh = icosphere(3);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, 1.0, 0.2));
  const std::vector<double> values{0.2, 0.55, 0.8};
  const std::vector<Cut> cuts = cutter_of(mesh, axis).cut(values);
  Mesh flipped = mesh;
  for (std::size_t i = 0; i < flipped.triangles.size(); i += 3)
    std::swap(flipped.triangles[i][0], flipped.triangles[i][1]);
  for (const Mesh& other : {flipped, test_support::shuffled(mesh, 5).mesh}) {
    const std::vector<Cut> again = cutter_of(other, axis).cut(values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      CHECK(again[i].edges == cuts[i].edges);
      REQUIRE(again[i].loops.size() == 1);
      CHECK(farthest_apart(*again[i].loops[0], *cuts[i].loops[0]) < 1e-12);
    }
  }
}

TEST_CASE("contour: copies along a seam close it", "[contour]") {
  const Cutter cutter = cutter_of(sphere(32, 17));
  Cutter seamed = cutter_of(sphere(32, 17, true));
  for (std::size_t v = 0; v < seamed.field.size(); ++v)
    if (seamed.input->twin[v] != v) seamed.field[v] = 7.0;  // only the first vertex of a place is asked
  for (const double value : {0.01, 0.2, 0.5, 0.83}) {
    REQUIRE(seamed.cut(value).loops.size() == 1);
    CHECK(farthest_apart(*seamed.cut(value).loops[0], *cutter.cut(value).loops[0]) == 0.0);
  }
}

TEST_CASE("contour: a standing torus is cut into two loops, a longer one first where they differ",
          "[contour]") {
  const Cutter torus_cutter = cutter_of(torus(96, 48, 1.0, 0.4), {1.0, 0.0, 0.0});
  CHECK(torus_cutter.cut(0.2).loops.size() == 1);
  const Cut cut = torus_cutter.cut(0.5);
  check_sound(torus_cutter, cut);
  REQUIRE(cut.loops.size() == 2);
  for (const auto& loop : cut.loops) {
    CHECK(loop->length == Approx(96.0 * std::sin(pi / 48.0) * 0.4));
    for (const glm::dvec3& p : loop->points)
      CHECK(std::hypot(p.y, std::abs(p.z) - 1.0) == Approx(0.4).epsilon(1e-2));
  }
  CHECK(cut.loops[0]->points[0].z * cut.loops[1]->points[0].z < 0.0);

  const Cutter lying = cutter_of(torus(96, 48, 1.0, 0.4));
  const Cut both = lying.cut(0.5);
  check_sound(lying, both);
  REQUIRE(both.loops.size() == 2);
  CHECK(both.loops[0]->length == Approx(2.0 * pi * 1.4).epsilon(1e-3));
  CHECK(both.loops[1]->length == Approx(2.0 * pi * 0.6).epsilon(1e-3));

  const Cutter feet = cutter_of(test_support::arch(), glm::normalize(glm::dvec3(0.2, 1.0, 0.0)));
  const Cut legs = feet.cut(0.45);
  check_sound(feet, legs);
  REQUIRE(legs.loops.size() == 2);
  CHECK(legs.loops[0]->length > legs.loops[1]->length + 0.01);
}

TEST_CASE("contour: a loop that crosses the half-plane several times begins where the one below did",
          "[contour]") {
  // A round, and the same with an arm that reaches on past where it began, farther out.
  const std::vector<glm::dvec3> round = circle();
  std::vector<glm::dvec3> hook(round.begin(), round.begin() + 40);
  for (const double turn : {0.84, 0.95, 1.08}) hook.push_back(polar(2.0, turn));
  for (const double turn : {1.08, 0.95, 0.88}) hook.push_back(polar(1.5, turn));
  for (const double turn : {0.92, 0.96}) hook.push_back(polar(1.0, turn));
  const Cutter cutter = cutter_of(loft({round, round, hook, hook}));
  const std::vector<double> values{0.3, 0.7};  // y is 0.5 and 2.5
  const std::vector<Cut> cuts = cutter.cut(values);
  const Cut alone = cutter.cut(0.7);
  for (const Cut& cut : {cuts[0], cuts[1], alone}) {
    REQUIRE(cut.loops.size() == 1);
    check_sound(cutter, cut);
  }
  CHECK(glm::distance(cuts[0].loops[0]->points[0], {0.0, 0.5, -1.0}) < 1e-9);
  // Three crossings at about 1, 1.5 and 2 from the round's middle.
  CHECK(glm::distance(cuts[1].loops[0]->points[0], {0.0, 2.5, -1.0}) < 0.3);
  CHECK(glm::length(alone.loops[0]->points[0] - glm::dvec3(0.0, 2.5, 0.0)) > 1.6);
  CHECK(cuts[1].loops[0]->length == Approx(alone.loops[0]->length));
}

TEST_CASE("contour: a loop begins on its own right side, even where that is far from the start below",
          "[contour]") {
  const std::vector<glm::dvec3> round = circle();
  std::vector<glm::dvec3> moved = round;
  for (glm::dvec3& p : moved) p.z -= 2.0;
  const Cutter cutter = cutter_of(loft({round, round, moved, moved}));
  const std::vector<Cut> cuts = cutter.cut(std::vector{0.3, 0.7});
  CHECK(glm::distance(cuts[0].loops[0]->points[0], {0.0, 0.5, -1.0}) < 1e-9);
  CHECK(glm::distance(cuts[1].loops[0]->points[0], {0.0, 2.5, -3.0}) < 1e-9);
}

TEST_CASE("contour: a vertex at the value counts as above it", "[contour]") {
  const Cutter cutter = cutter_of(sphere(16, 8));
  CHECK(cutter.cut(0.0).edges == 0);
  CHECK(cutter.cut(1.0).edges == 16);  // all of them at the top, where no loop is left
  CHECK(cutter.cut(0.0).loops.empty());
  CHECK(cutter.cut(1.0).loops.empty());
}

TEST_CASE("contour: beyond the surface there is no loop, and cuts do not depend on each other", "[contour]") {
  const Cutter cutter = cutter_of(egg(48, 0.1));
  const std::vector<double> values{-0.5, 0.25, 0.5, 0.75, 1.5};
  const std::vector<Cut> cuts = cutter.cut(values);
  CHECK(cuts.front().loops.empty());
  CHECK(cuts.front().edges == 0);
  CHECK(cuts.back().loops.empty());
  for (const std::size_t i : {1U, 2U, 3U}) CHECK(cuts[i] == cutter.cut(values[i]));
}
