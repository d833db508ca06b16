// Algorithm 1, the choice of ends, levels and where one tube ends.
#include "knit/timing/timing.h"

#include "knit/insight/narrate.h"
#include "knit/model/stitch_size.h"
#include "knit/rows/cast_on.h"
#include "knit/timing/critical.h"
#include "knit/timing/levels.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

namespace {

Ends ends_of(const Mesh& mesh, const Parameters& parameters) {
  const auto found = find_ends(*make_input(mesh), parameters.timing);
  REQUIRE(std::holds_alternative<Ends>(found));
  return std::get<Ends>(found);
}

std::vector<double> times_of(const Input& input, const Parameters& parameters = {}) {
  const Ends ends = std::get<Ends>(find_ends(input, parameters.timing));
  std::vector<double> times;
  for (const auto& position : input.mesh.positions) times.push_back(time_of(ends, position));
  return times;
}

Levels levels_of(const Input& input, const std::vector<double>& times, double tolerance) {
  return group_levels(input, times, find_criticals(input, times), tolerance);
}

Timeline run(std::shared_ptr<const Input> input, const Parameters& parameters) {
  Timeline timeline(std::move(input), parameters);
  timeline.extend_to_end();
  return timeline;
}

}  // namespace

TEST_CASE("the time is the normalised projection from start to end") {
  const Mesh mesh = sphere(16, 8);
  const Ends ends = ends_of(mesh, {});
  CHECK(mesh.positions[ends.start].y == -1.0);
  CHECK(mesh.positions[ends.end].y == 1.0);
  CHECK(time_of(ends, mesh.positions[ends.start]) == 0.0);
  CHECK(time_of(ends, mesh.positions[ends.end]) == 1.0);
  CHECK(time_of(ends, {5.0, 0.0, -3.0}) == 0.5);
  CHECK(time_of(ends, {0.0, -2.0, 0.0}) == -0.5);
}

TEST_CASE("the axis may be any direction, its length does not matter") {
  Parameters parameters;
  parameters.timing.axis = {AxisKind::custom, {0.0, -7.0, 0.0}};
  const Mesh mesh = sphere(16, 8);
  const Ends ends = ends_of(mesh, parameters);
  CHECK(mesh.positions[ends.start].y == 1.0);
  CHECK(mesh.positions[ends.end].y == -1.0);
}

TEST_CASE("a tie among extreme vertices goes to the one nearest to the centroid's line") {
  // A box whose lid has a vertex in its middle, listed last.
  Mesh mesh;
  mesh.positions = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1},  {-1, 0, 1}, {-1, 2, -1},
                    {1, 2, -1},  {1, 2, 1},  {-1, 2, 1}, {0, 2, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (VertexId a = 0; a < 4; ++a) {
    const VertexId b = (a + 1) % 4;
    mesh.triangles.insert(mesh.triangles.end(), {{b, a, a + 4}, {b, a + 4, b + 4}, {b + 4, a + 4, 8}});
  }
  CHECK(ends_of(mesh, {}).end == 8);
}

TEST_CASE("picked vertices: the time runs along their line, and what lies beyond is clamped and reported") {
  Parameters parameters = test_support::small_parameters();
  parameters.timing.start = 41;  // on the second ring
  const auto input = test_support::small_sphere();
  const Ends ends = std::get<Ends>(find_ends(*input, parameters.timing));
  CHECK(ends.start == 41);
  CHECK(time_of(ends, input->mesh.positions[41]) == 0.0);
  Timeline timeline(input, parameters);
  timeline.extend(input->mesh.positions.size() + 3);
  const Timing& timing = *timeline.furthest().timing;
  CHECK(timing.outside > 0);
  for (const double time : timing.times) CHECK((time >= 0.0 && time <= 1.0));
  const auto* grouped = knit::get_if<LevelsGrouped>(timeline.step(timeline.known() - 1));
  REQUIRE(grouped != nullptr);
  CHECK(grouped->outside == timing.outside);
}

TEST_CASE("a mesh without extent along the axis stops with a word") {
  Mesh flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}};
  flat.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 2, 3}, {0, 3, 1}};
  const Timeline timeline = run(make_input(flat), {});
  REQUIRE(timeline.stop() != nullptr);
  CHECK(timeline.known() == 0);
  CHECK(knit::get_if<Stopped>(*timeline.stop())->reason == StopReason::no_extent);
  CHECK(narrate(*timeline.stop(), {}).find("choose another axis") != std::string::npos);
}

TEST_CASE("levels: rings are levels, whatever the order of the vertices, a wide tolerance joins them") {
  Mesh mesh = sphere(16, 8);
  const auto input = make_input(mesh);
  const Levels levels = levels_of(*input, times_of(*input), 1e-5);
  CHECK(levels.count() == 9);
  CHECK(levels.level(0).size() == 1);
  for (std::int32_t level = 1; level < 8; ++level) CHECK(levels.level(level).size() == 16);
  CHECK_FALSE(levels.split);
  CHECK(levels_of(*input, times_of(*input), 0.1).count() < 9);

  std::reverse(mesh.positions.begin(), mesh.positions.end());
  const auto last = static_cast<VertexId>(mesh.positions.size() - 1);
  for (auto& triangle : mesh.triangles) {
    for (VertexId& v : triangle) v = last - v;
  }
  const auto reversed = make_input(mesh);
  const Levels same = levels_of(*reversed, times_of(*reversed), 1e-5);
  CHECK(same.count() == 9);
  for (std::int32_t level = 1; level < 8; ++level) {
    CHECK(std::is_sorted(same.level(level).begin(), same.level(level).end()));
  }
}

TEST_CASE("unreferenced vertices belong to no level") {
  Mesh mesh = sphere(16, 8);
  mesh.positions.emplace_back(0.0, 0.123, 0.0);
  const auto input = make_input(mesh);
  CHECK(levels_of(*input, times_of(*input), 1e-5).count() == 9);
}

TEST_CASE("loops of a level set are counted, a torus splits, a sphere along any axis does not") {
  const auto ball = make_input(icosphere(3));
  const std::vector<double> times = times_of(*ball);
  CHECK(count_loops(*ball, times, 0.41234) == 1);
  for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), glm::dvec3(1, 2, 3), glm::dvec3(-1, 0.3, 0)}) {
    Parameters parameters;
    parameters.timing.axis = {AxisKind::custom, axis};
    const std::vector<double> along = times_of(*ball, parameters);
    CHECK_FALSE(levels_of(*ball, along, 1e-5).split);
  }

  const auto ring = make_input(torus(48, 24, 1.0, 0.4));
  const Levels lying = levels_of(*ring, times_of(*ring), 1e-5);
  REQUIRE(lying.split);
  CHECK(lying.split->level == 0);
  CHECK(lying.split->loops == 2);

  // Standing, the first saddle is the inner circle's lowest place: at 0.8 of the height 2.8 from below.
  Parameters standing;
  standing.timing.axis = {AxisKind::x, {0, 1, 0}};
  const std::vector<double> times_x = times_of(*ring, standing);
  const Levels upright = levels_of(*ring, times_x, 1e-5);
  REQUIRE(upright.split);
  CHECK(upright.split->time == Approx(0.8 / 2.8).margin(0.01));
  CHECK(upright.split->loops == 2);
}

TEST_CASE("the torus stops in words about splitting") {
  const auto ring = make_input(torus(48, 24, 1.0, 0.4));
  const Timeline timeline = run(ring, {});
  REQUIRE(timeline.stop() != nullptr);
  CHECK(knit::get_if<Stopped>(*timeline.stop())->reason == StopReason::splits);
  CHECK(narrate(*timeline.stop(), {}).find("splits into 2 loops") != std::string::npos);
  CHECK(timeline.furthest().stage() == Stage::cast_on);
}

TEST_CASE("a mesh without rings stops at the cast on and says what to do") {
  const Timeline timeline = run(make_input(icosphere(3)), test_support::small_parameters());
  REQUIRE(timeline.stop() != nullptr);
  CHECK(knit::get_if<Stopped>(*timeline.stop())->reason == StopReason::not_a_ring);
  CHECK(narrate(*timeline.stop(), {}).find("take rows from contours") != std::string::npos);
}

TEST_CASE("cast on: polar levels too short for stitches are passed over at both ends") {
  const auto input = make_input(sphere(256, 128));
  Parameters parameters;  // w = 0.1: rings shorter than 0.15 are no rows
  Timeline timeline(input, parameters);
  timeline.extend(input->mesh.positions.size() + 4);
  const auto* found = knit::get_if<CycleFound>(timeline.step(timeline.known() - 1));
  REQUIRE(found != nullptr);
  CHECK(found->level == 1);  // 2 pi sin(pi / 128) = 0.154
  CHECK(found->last_level == 127);

  give_width(parameters, 0.3);
  const std::vector<double> times = times_of(*input);
  Timing timing;
  timing.ends = std::get<Ends>(find_ends(*input, parameters.timing));
  timing.times = times;
  timing.levels = levels_of(*input, times, 1e-5);
  const auto cycle = find_first_cycle(*input, timing, parameters.rows, parameters.stitch);
  REQUIRE(std::holds_alternative<FirstCycle>(cycle));
  CHECK(std::get<FirstCycle>(cycle).level == 3);
  CHECK(std::get<FirstCycle>(cycle).passed_over == 2);
  CHECK(std::get<FirstCycle>(cycle).last_level == 125);
}

TEST_CASE("cast on places k stitches at equal arcs") {
  Parameters parameters = test_support::small_parameters();
  parameters.rows.cast_on = 7;
  const Timeline timeline = run(test_support::small_sphere(), parameters);
  const Row& row = *timeline.furthest().fabric.rows().front();
  CHECK(row.id == 1);
  CHECK(row.stitches.size() == 7);
  CHECK(row.stitches.front().position.x == 0.0);
}
