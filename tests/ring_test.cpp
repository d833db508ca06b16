// Rings: order, start, orientation, and levels that are none.
#include "knit/rows/ring.h"

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "knit/timing/critical.h"
#include "knit/timing/levels.h"
#include "knit/timing/timing.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

namespace {

struct Timed {
  std::shared_ptr<const Input> input;
  Ends ends;
  std::vector<double> times;
  Levels levels;
};

Timed timed(const Mesh& mesh, const Axis& axis = {}) {
  Timed t;
  t.input = make_input(mesh);
  Parameters parameters;
  parameters.timing.axis = axis;
  const auto found = find_ends(*t.input, parameters.timing);
  REQUIRE(std::holds_alternative<Ends>(found));
  t.ends = std::get<Ends>(found);
  for (const auto& position : t.input->mesh.positions) t.times.push_back(time_of(t.ends, position));
  t.levels = group_levels(*t.input, t.times, find_criticals(*t.input, t.times), 1e-5);
  return t;
}

Ring ring_of(const Timed& t, std::int32_t level) {
  const auto ordered = order_ring(*t.input, t.ends, t.levels.level(level));
  REQUIRE(std::holds_alternative<Ring>(ordered));
  return std::get<Ring>(ordered);
}

// Signed area seen along the direction of knitting: positive is counter-clockwise.
double turning(const Timed& t, const Ring& ring) {
  const glm::dvec3 back = -glm::normalize(t.ends.direction);
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.vertices.size(); ++i) {
    const auto& a = t.input->mesh.positions[ring.vertices[i]];
    const auto& b = t.input->mesh.positions[ring.vertices[(i + 1) % ring.vertices.size()]];
    sum += glm::dot(glm::cross(a, b), back);
  }
  return sum;
}

}  // namespace

TEST_CASE("a ring begins at -z and runs counter-clockwise seen along the axis") {
  const Timed t = timed(sphere(16, 8));
  for (std::int32_t level = 1; level < 8; ++level) {
    const Ring ring = ring_of(t, level);
    const auto& first = t.input->mesh.positions[ring.vertices.front()];
    CHECK(first.x == 0.0);
    CHECK(first.z < 0.0);
    CHECK(turning(t, ring) > 0.0);
    CHECK(ring.ordered_by == OrderedBy::angle);
    CHECK(ring.vertices.size() == 16);
  }
}

TEST_CASE("the closing copy of the first vertex comes last, with no length after it") {
  const Timed t = timed(sphere(128, 65, true));
  const Ring ring = ring_of(t, 20);
  REQUIRE(ring.vertices.size() == 129);
  CHECK(t.input->twin[ring.vertices.back()] == ring.vertices.front());
  CHECK(ring.arc.back() == Approx(ring.length));
  CHECK(std::is_sorted(ring.arc.begin(), ring.arc.end()));
}

TEST_CASE("along z the ring begins at -x, along any axis it keeps its sense") {
  Mesh turned = sphere(16, 8);
  for (auto& p : turned.positions) p = {p.x, p.z, p.y};  // y and z change places: a mirror image along z
  for (auto& triangle : turned.triangles) std::swap(triangle[1], triangle[2]);
  const Timed t = timed(turned, Axis{AxisKind::z, {0, 1, 0}});
  const Ring ring = ring_of(t, 4);
  const auto& first = t.input->mesh.positions[ring.vertices.front()];
  CHECK(first.x == Approx(-1.0));
  CHECK(turning(t, ring) > 0.0);
}

TEST_CASE("a loop that is not star-shaped is ordered along its edges") {
  // A bent prism: a C-shaped outline extruded upwards, with a floor and a roof of three bars each.
  const std::vector<glm::dvec2> outline{{0, -3}, {3, -3}, {3, 3}, {0, 3}, {0, 2}, {2, 2}, {2, -2}, {0, -2}};
  Mesh mesh;
  const auto n = static_cast<VertexId>(outline.size());
  for (int layer = 0; layer < 4; ++layer) {
    for (const auto& p : outline) mesh.positions.emplace_back(p.x, layer, p.y);
  }
  for (VertexId layer = 0; layer < 3; ++layer) {
    for (VertexId i = 0; i < n; ++i) {
      const VertexId a = layer * n + i;
      const VertexId b = layer * n + (i + 1) % n;
      mesh.triangles.push_back({a, b + n, b});
      mesh.triangles.push_back({a, a + n, b + n});
    }
  }
  for (const auto& [a, b, c, d] :
       std::vector<std::array<VertexId, 4>>{{0, 1, 6, 7}, {1, 2, 5, 6}, {2, 3, 4, 5}}) {
    const VertexId roof = 3 * n;
    mesh.triangles.insert(
        mesh.triangles.end(),
        {{a, b, c}, {a, c, d}, {roof + a, roof + c, roof + b}, {roof + a, roof + d, roof + c}});
  }
  REQUIRE(make_input(mesh)->rims.empty());
  const Timed t = timed(mesh);
  const Ring ring = ring_of(t, 1);
  CHECK(ring.ordered_by == OrderedBy::edges);
  CHECK(ring.length == Approx(22.0));
  CHECK(turning(t, ring) > 0.0);
}

TEST_CASE("levels that are no ring: too few vertices, two loops, no edges") {
  const Timed t = timed(sphere(16, 8));
  CHECK(std::holds_alternative<NotARing>(order_ring(*t.input, t.ends, t.levels.level(0))));

  const Timed ring_of_rings = timed(torus(24, 12, 1.0, 0.4));
  REQUIRE(ring_of_rings.levels.split);
  CHECK(ring_of_rings.levels.split->loops == 2);
  const auto two = order_ring(*ring_of_rings.input, ring_of_rings.ends, ring_of_rings.levels.level(2));
  REQUIRE(std::holds_alternative<NotARing>(two));
  CHECK(std::get<NotARing>(two).loops == 2);
}

TEST_CASE("a place along the ring, for any arc") {
  const Timed t = timed(sphere(16, 8));
  const Ring ring = ring_of(t, 4);
  const Mesh& mesh = t.input->mesh;
  const auto at = [&](double arc) { return point_at(ring, arc); };
  CHECK(at(0.0) == mesh.positions[ring.vertices[0]]);
  CHECK(glm::distance(at(ring.arc[3]), mesh.positions[ring.vertices[3]]) < 1e-12);
  CHECK(glm::distance(at(ring.length + 0.1), at(0.1)) < 1e-12);
  CHECK(glm::distance(at(-0.1), at(ring.length - 0.1)) < 1e-12);
  const glm::dvec3 middle = at(0.5 * ring.arc[1]);
  CHECK(glm::distance(middle, 0.5 * (mesh.positions[ring.vertices[0]] + mesh.positions[ring.vertices[1]])) <
        1e-12);
  CHECK(spread_evenly(ring, 8).size() == 8);
}
