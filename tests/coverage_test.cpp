// What rows leave uncovered, and which are stretched: of tubes built by hand, and of runs.
#include "knit/quality/coverage.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "knit/mesh/outside.h"
#include "knit/mesh/triangle_tree.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/closeness.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"
#include "tests/support/tube.h"

using namespace knit;
using test_support::HandTube;

namespace {

// The cylinder's lids are at y = 0 and y = 3.
HandTube upright() { return {{24, 24, 24, 24, 24, 24, 24}, 1.0, 0.5, 0.0}; }

Uncovered uncovered(Mesh mesh, const State& state, double height) {
  return measure_uncovered(*make_input(std::move(mesh)), state, height, height);
}

State finished(const std::shared_ptr<const Input>& input, TimingKind timing, double width) {
  Parameters parameters;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters.timing.kind = timing;
  give_width(parameters, width);
  Timeline timeline(input, parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.furthest().finished());
  return timeline.furthest();
}

double lid_share(const Mesh& mesh) {
  double lids = 0.0, all = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 normal =
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    all += glm::length(normal);
    if (std::abs(normal.y) > 0.5 * glm::length(normal)) lids += glm::length(normal);
  }
  return lids / all;
}

}  // namespace

TEST_CASE("coverage: a knit mesh covers itself", "[coverage]") {
  const State state = test_support::tube_state(upright());
  const Uncovered none = uncovered(test_support::mesh_of(state), state, 0.5);
  CHECK(none.share == 0.0);
  CHECK(none.places.empty());
}

TEST_CASE("coverage: lids that no row is on are told, each with its middle", "[coverage]") {
  const Mesh mesh = test_support::cylinder(24, 1.0, 3.0, 3);
  const State state = test_support::tube_state(upright());
  const Uncovered lids = uncovered(mesh, state, 0.5);
  CHECK(lids.share == Approx(lid_share(mesh)));  // the walls face another way, so no rim of a lid is covered
  REQUIRE(lids.places.size() == 2);
  for (const UncoveredPlace& place : lids.places) {
    CHECK(place.share == Approx(lids.share / 2.0));
    CHECK(glm::length(glm::dvec2(place.at.x, place.at.z)) < 0.5);
    const glm::dvec3& vertex = mesh.positions[place.vertex];
    CHECK(glm::length(glm::dvec2(vertex.x, vertex.z)) < 1e-9);
    CHECK(vertex.y == place.at.y);
  }
  CHECK(lids.places[0].at.y + lids.places[1].at.y == Approx(3.0));
}

TEST_CASE("coverage: rows cover one stitch height to either side, and a rim is cut finely", "[coverage]") {
  // Walls from -1.5 to 4.5, rows from 0 to 3.
  Mesh mesh = test_support::cylinder(24, 1.0, 6.0, 1);
  for (glm::dvec3& p : mesh.positions) p.y -= 1.5;
  const double lids = lid_share(mesh);
  const State state = test_support::tube_state(upright());
  const double height = 0.25;
  const double beyond = (1.0 - lids) * (6.0 - 3.0 - 2.0 * height) / 6.0;
  CHECK(uncovered(mesh, state, height).share == Approx(lids + beyond).margin(0.01));
  CHECK(uncovered(mesh, state, height).places.size() == 2);  // the lid with what is beside it
}

TEST_CASE("coverage: the other wall of a thin sheet does not cover", "[coverage]") {
  const Mesh outer = test_support::mesh_of(test_support::tube_state(upright()));
  HandTube narrower = upright();
  narrower.radius = 0.95;
  Mesh sheet = test_support::mesh_of(test_support::tube_state(narrower));
  const auto count = static_cast<VertexId>(sheet.positions.size());
  for (Triangle& triangle : sheet.triangles) std::swap(triangle[1], triangle[2]);  // it faces the axis
  sheet.positions.insert(sheet.positions.end(), outer.positions.begin(), outer.positions.end());
  for (const auto& [a, b, c] : outer.triangles) sheet.triangles.push_back({a + count, b + count, c + count});
  const Uncovered inside = uncovered(sheet, test_support::tube_state(upright()), 0.5);
  CHECK(inside.share == Approx(0.95 / 1.95));
  REQUIRE(inside.places.size() == 1);
  CHECK(inside.places[0].vertex < count);
}

TEST_CASE("coverage: a hole that is drawn together is closed, a wide one is open", "[coverage]") {
  const auto lid_of = [](int stitches) {
    const State state = test_support::tube_state({std::vector<int>(7, stitches), 1.0, 0.5, 0.0});
    return uncovered(test_support::cylinder(static_cast<unsigned>(stitches), 1.0, 3.0, 3), state, 0.5).share;
  };
  CHECK(lid_of(12) == 0.0);
  CHECK(lid_of(13) > 0.2);
}

TEST_CASE("coverage: a sphere is covered all over, by rings and by contours", "[coverage]") {
  const auto input = test_support::small_sphere();
  Timeline rings(input, test_support::small_parameters());
  rings.extend_to_end();
  const auto by_rings = measure_coverage(*input, rings.furthest(), 0.3, 0.216);
  REQUIRE(by_rings);
  CHECK(by_rings->uncovered.share == 0.0);
  for (const double width : {0.1, 0.3, 0.6}) {
    CAPTURE(width);
    const State state = finished(input, TimingKind::linear, width);
    CHECK(measure_uncovered(*input, state, width, height_of_width * width).share == 0.0);
  }
}

TEST_CASE("coverage: linear time leaves flat ends out, geodesic time does not", "[coverage]") {
  const auto input = make_input(test_support::cylinder(24, 1.0, 2.0, 8));
  const double width = 0.2;
  const State linear = finished(input, TimingKind::linear, width);
  const auto coverage = measure_coverage(*input, linear, width, height_of_width * width);
  REQUIRE(coverage);
  CHECK(coverage->uncovered.share == Approx(lid_share(input->mesh)).margin(0.01));
  REQUIRE(coverage->uncovered.places.size() == 2);
  for (const UncoveredPlace& place : coverage->uncovered.places) CHECK(place.kind == UncoveredKind::flat);
  const State geodesic = finished(input, TimingKind::geodesic, width);
  CHECK(measure_uncovered(*input, geodesic, width, height_of_width * width).share < 0.001);
}

TEST_CASE("coverage: a run and what it covers do not depend on the way the triangles face", "[coverage]") {
  const auto input = make_input(test_support::cylinder(24, 1.0, 2.0, 8));
  const double width = 0.2, height = height_of_width * width;
  const State state = finished(input, TimingKind::linear, width);
  const Uncovered agreeing = measure_uncovered(*input, state, width, height);
  CHECK(agreeing.places.size() == 2);
  for (const std::size_t every : {std::size_t{1}, std::size_t{3}}) {  // inside out; some of them turned
    CAPTURE(every);
    Mesh mesh = input->mesh;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += every)
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    const auto turned = make_input(std::move(mesh));
    const State run = finished(turned, TimingKind::linear, width);
    const Uncovered found = measure_uncovered(*turned, run, width, height);
    CHECK(found.share == Approx(agreeing.share));
    CHECK(found.places.size() == agreeing.places.size());
    CHECK(measure_turned(*turned, run).faces == measure_turned(*input, state).faces);
    CHECK(stretched_rows(run, height).size() == stretched_rows(state, height).size());
  }
}

TEST_CASE("outside: none is turned in a thin sheet or a flat one, and all of a mesh inside out",
          "[coverage]") {
  Mesh flat;
  flat.positions = {{0, 0, 0.1}, {1, 0, 0.1}, {1, 1, 0.1}, {0, 1, 0.1}};
  flat.triangles = {{0, 1, 2}, {0, 2, 3}};
  CHECK(inward_triangles(*make_input(flat)).empty());
  for (Triangle& triangle : flat.triangles) std::swap(triangle[1], triangle[2]);
  CHECK(inward_triangles(*make_input(flat)).empty());
  std::swap(flat.triangles[1][1], flat.triangles[1][2]);
  CHECK(inward_triangles(*make_input(flat)).size() == 2);
  Mesh ball = sphere(12, 7);
  CHECK(inward_triangles(*make_input(ball)).empty());
  for (Triangle& triangle : ball.triangles) std::swap(triangle[1], triangle[2]);
  CHECK(inward_triangles(*make_input(ball)) == std::vector<std::uint8_t>(ball.triangles.size(), 1));
  std::swap(ball.triangles[5][1], ball.triangles[5][2]);
  std::vector<std::uint8_t> but_one(ball.triangles.size(), 1);
  but_one[5] = 0;
  CHECK(inward_triangles(*make_input(ball)) == but_one);
}

TEST_CASE("coverage: shares stay when everything grows", "[coverage]") {
  Mesh mesh = test_support::cylinder(24, 1.0, 3.0, 3);
  const State state = test_support::tube_state(upright());
  const Uncovered small = uncovered(mesh, state, 0.25);
  for (glm::dvec3& p : mesh.positions) p *= 1024.0;
  const State grown = test_support::moved(state, [](const glm::dvec3& p) { return 1024.0 * p; });
  const Uncovered large = uncovered(mesh, grown, 256.0);
  CHECK(large.share == Approx(small.share));
  REQUIRE(large.places.size() == small.places.size());
  CHECK(large.places[0].vertex == small.places[0].vertex);
}

TEST_CASE("coverage: a stitch far too low does not make the work endless", "[coverage]") {
  const State state = test_support::tube_state(upright());
  CHECK(uncovered(test_support::cylinder(24, 1.0, 3.0, 3), state, 1e-9).share > 0.2);
}

TEST_CASE("coverage: rows that are too far apart are stretched, one stretch for all that follow each other",
          "[coverage]") {
  const State state = test_support::tube_state({{12, 12, 12, 12, 12, 12}, 1.0, 1.0, 0.0});
  CHECK(stretched_rows(state, 1.0).empty());
  CHECK(stretched_rows(state, 1.0 / 1.49).empty());
  const auto all = stretched_rows(state, 0.5);
  REQUIRE(all.size() == 1);
  CHECK(all[0].tube == 0);
  CHECK(all[0].from == 2);
  CHECK(all[0].to == 6);
  CHECK(all[0].longest == Approx(2.0));
  CHECK(all[0].share == 1.0);

  // The third and the fifth row lifted: the rows into them are longer, those above shorter.
  const State lifted = test_support::moved(state, [](const glm::dvec3& p) {
    const double step = p.y + 0.5;
    const bool third = step > 2.0 && step<3.0, fifth = step> 4.0 && step < 5.0;
    return p + glm::dvec3(0.0, third && p.x > 0.1 ? 0.8 : fifth ? 0.6 : 0.0, 0.0);
  });
  const auto two = stretched_rows(lifted, 1.0);
  REQUIRE(two.size() == 2);
  CHECK(two[0].from == 3);
  CHECK(two[0].to == 3);
  CHECK(two[0].longest == Approx(1.8));
  CHECK(two[0].share == Approx(5.0 / 12.0));
  CHECK(two[0].at.row == 3);
  CHECK(lifted.fabric.position(two[0].at).x > 0.1);
  CHECK(two[1].from == 5);
  CHECK(two[1].share == 1.0);
}

TEST_CASE("coverage: nothing before all faces are made", "[coverage]") {
  const auto input = test_support::small_sphere();
  CHECK_FALSE(measure_coverage(*input, State{}, 0.3, 0.2));
  Timeline timeline(input, test_support::small_parameters());
  timeline.extend_to_end();
  timeline.seek(timeline.position_of({Stage::faces, 5, 0}));
  CHECK_FALSE(measure_coverage(*input, timeline.state(), 0.3, 0.2));
  CHECK_FALSE(measure_closeness(*input, timeline.furthest())->coverage);
  CHECK(measure_closeness(*input, timeline.furthest(), 0.3, 0.2)->coverage);
}

TEST_CASE("triangle tree: of triangles that face another way the nearest does not count", "[coverage]") {
  const Mesh mesh = sphere(24, 13);
  const TriangleTree tree(mesh.positions, mesh.triangles);
  const glm::dvec3 facing(0.0, 1.0, 0.0);
  std::size_t farther = 0;
  for (const glm::dvec3& seen : mesh.positions) {
    const glm::dvec3 point = 0.7 * seen;
    double best = 5.0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Corners t{mesh.positions[a], mesh.positions[b], mesh.positions[c]};
      if (glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0])).y > 0.1)
        best = std::min(best, distance_to_triangle(point, t));
    }
    CHECK(tree.distance(point, facing, 5.0) == best);
    farther += tree.distance(point) < best ? 1 : 0;
  }
  CHECK(farther > mesh.positions.size() / 3);
  CHECK(tree.distance({0.0, 3.0, 0.0}, facing, 1.0) == 1.0);  // none is nearer than that
  CHECK(TriangleTree({}, {}).distance({0.0, 3.0, 0.0}, facing, 1.0) == 1.0);
}
