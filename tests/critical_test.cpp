// Critical points of the time, and why level sets split.
#include "knit/timing/critical.h"

#include "knit/timing/levels.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"

using namespace knit;
using test_support::field_along;

namespace {

const glm::dvec3 up(0.0, 1.0, 0.0);

struct Timed {
  std::shared_ptr<const Input> input;
  std::vector<double> times;
  Criticals criticals;
  [[nodiscard]] const glm::dvec3& position(VertexId v) const { return input->mesh.positions[v]; }
  [[nodiscard]] Split split_at(double time) const { return explain_split(*input, times, criticals, time); }
  [[nodiscard]] std::int32_t loops_at(double time) const { return count_loops(*input, times, time); }
};

Timed timed_by(const Mesh& mesh, std::vector<double> times) {
  auto input = make_input(mesh);
  Criticals criticals = find_criticals(*input, times);
  return {std::move(input), std::move(times), std::move(criticals)};
}

Timed timed(const Mesh& mesh, const glm::dvec3& axis = up) {
  return timed_by(mesh, field_along(*make_input(mesh), axis));
}

std::vector<CriticalKind> kinds(const Criticals& criticals) {
  std::vector<CriticalKind> found;
  for (const CriticalPoint& point : criticals.points) found.push_back(point.kind);
  return found;
}

void check_counts(const Criticals& found, std::int32_t minima, std::int32_t saddles, std::int32_t maxima,
                  std::int32_t euler) {
  CHECK(found.minima == minima);
  CHECK(found.saddles == saddles);
  CHECK(found.maxima == maxima);
  CHECK(found.euler == euler);
  CHECK(found.minima - found.saddles + found.maxima == found.euler);
}

// A dumbbell about y: across it, level sets begin, end and part at both bulges.
Mesh dumbbell() {
  std::vector<ProfilePoint> profile;
  for (unsigned j = 0; j <= 40; ++j) {
    const TurnPoint at = turn_point(j, 80);
    profile.push_back({at.sine * (0.35 + 0.65 * at.cosine * at.cosine), -2.0 * at.cosine});
  }
  return revolve("dumbbell", profile, 32, false);
}

constexpr CriticalKind minimum = CriticalKind::minimum;
constexpr CriticalKind saddle = CriticalKind::saddle;
constexpr CriticalKind maximum = CriticalKind::maximum;

}  // namespace

TEST_CASE("critical: a sphere has one minimum and one maximum along any axis", "[critical]") {
  for (const Mesh& mesh : {sphere(32, 17), sphere(32, 16, true), icosphere(3)}) {
    for (const glm::dvec3& axis : test_support::random_axes(20, 3)) {
      const Timed t = timed(mesh, axis);
      check_counts(t.criticals, 1, 0, 1, 2);
      REQUIRE(t.criticals.points.size() == 2);
      CHECK(t.criticals.points[0].time == 0.0);
      CHECK(t.criticals.points[1].time == 1.0);
      CHECK(t.times[t.criticals.points[0].vertex] == 0.0);
      CHECK(t.loops_at(0.5) == 1);
    }
    check_counts(timed(mesh).criticals, 1, 0, 1, 2);  // whole rings of equal time
  }
}

TEST_CASE("critical: whatever the mesh, minima - saddles + maxima is its Euler characteristic",
          "[critical]") {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const Criticals rough = timed(test_support::rough_sphere(3, seed), {0.2, 1.0, 0.3}).criticals;
    check_counts(rough, rough.minima, rough.saddles, rough.maxima, 2);
    // Any numbers at all.
    test_support::Dice dice(seed);
    const Mesh ring = torus(12, 9, 1.0, 0.4);
    std::vector<double> noise;
    for (std::size_t i = 0; i < ring.positions.size(); ++i) noise.push_back(dice.between(0.0, 1.0));
    const Criticals wild = timed_by(ring, noise).criticals;
    CHECK(wild.minima > 1);
    check_counts(wild, wild.minima, wild.saddles, wild.maxima, 0);
    for (std::size_t i = 1; i < wild.points.size(); ++i)
      CHECK(wild.points[i - 1].time <= wild.points[i].time);
  }
}

TEST_CASE("critical: a standing torus begins, parts, joins and ends", "[critical]") {
  const Timed t = timed(torus(48, 24, 1.0, 0.4), {1.0, 0.0, 0.0});
  check_counts(t.criticals, 1, 2, 1, 0);
  REQUIRE(kinds(t.criticals) == std::vector{minimum, saddle, saddle, maximum});
  const std::vector<double> at{-1.4, -0.6, 0.6, 1.4};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(glm::distance(t.position(t.criticals.points[i].vertex), {at[i], 0.0, 0.0}) < 1e-12);
    CHECK(t.criticals.points[i].time == Approx((at[i] + 1.4) / 2.8).margin(1e-12));
    CHECK(t.criticals.points[i].multiplicity == 1);
  }
  CHECK(t.loops_at(0.2) == 1);
  CHECK(t.loops_at(0.5) == 2);
  CHECK(t.loops_at(0.8) == 1);

  const Split split = t.split_at(0.5);
  CHECK(split.cause == saddle);
  CHECK(split.vertex == t.criticals.points[1].vertex);
  CHECK(split.time == t.criticals.points[1].time);
}

TEST_CASE("critical: a lying torus has flat rings, each one end and one saddle", "[critical]") {
  const Timed t = timed(torus(48, 24, 1.0, 0.4));
  check_counts(t.criticals, 1, 2, 1, 0);
  REQUIRE(t.criticals.points.size() == 4);
  CHECK(kinds(t.criticals)[0] == minimum);
  CHECK(kinds(t.criticals)[1] == saddle);
  for (const std::size_t i : {0U, 1U}) {
    CHECK(t.criticals.points[i].vertex == 0);  // the lowest of the ring
    CHECK(t.criticals.points[i].time == 0.0);
  }
  for (const std::size_t i : {2U, 3U}) CHECK(t.criticals.points[i].time == 1.0);
  CHECK(kinds(t.criticals)[2] != kinds(t.criticals)[3]);
  CHECK(t.loops_at(0.5) == 2);
  const Split split = t.split_at(0.5);
  CHECK(split.cause == saddle);
  CHECK(split.vertex == 0);
  CHECK(split.time == 0.0);
}

TEST_CASE("critical: flat ends and shoulders of a cylinder are one point or none", "[critical]") {
  check_counts(timed(test_support::cylinder(24, 1.0, 2.0, 5)).criticals, 1, 0, 1, 2);
  CHECK(timed(test_support::cylinder(24, 1.0, 2.0, 5)).criticals.points[0].vertex == 0);
  const std::vector<ProfilePoint> profile{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.7, 1.0},
                                          {0.4, 1.0}, {0.4, 2.0}, {0.0, 2.0}};
  check_counts(timed(revolve("step", profile, 32, false)).criticals, 1, 0, 1, 2);
}

TEST_CASE("critical: a hair of rounding does not break a flat part up", "[critical]") {
  const Mesh mesh = torus(48, 24, 1.0, 0.4);
  std::vector<double> times = field_along(*make_input(mesh), up);
  test_support::Dice dice(5);
  for (double& time : times) time += dice.between(-2e-13, 2e-13);
  check_counts(timed_by(mesh, times).criticals, 1, 2, 1, 0);
}

TEST_CASE("critical: two feet are two minima, and the saddle above tells why", "[critical]") {
  const Timed t = timed(test_support::arch());
  check_counts(t.criticals, 2, 1, 1, 2);
  REQUIRE(kinds(t.criticals) == std::vector{minimum, minimum, saddle, maximum});
  const CriticalPoint& joined = t.criticals.points[2];
  CHECK(glm::distance(t.position(joined.vertex), {0.0, 0.65, 0.0}) < 0.05);
  CHECK(t.loops_at(0.5 * joined.time) == 2);
  for (const double share : {0.2, 0.9}) {
    const Split split = t.split_at(share * joined.time);
    CHECK(split.cause == minimum);
    CHECK(split.vertex == joined.vertex);
    CHECK(split.time == joined.time);
  }
}

TEST_CASE("critical: two horns part at the saddle below", "[critical]") {
  const Timed t = timed(test_support::arch(), -up);
  check_counts(t.criticals, 1, 1, 2, 2);
  REQUIRE(kinds(t.criticals) == std::vector{minimum, saddle, maximum, maximum});
  const CriticalPoint& parting = t.criticals.points[1];
  CHECK(glm::distance(t.position(parting.vertex), {0.0, 0.65, 0.0}) < 0.05);
  const Split split = t.split_at(0.5 * (parting.time + 1.0));
  CHECK(split.cause == saddle);
  CHECK(split.vertex == parting.vertex);
  CHECK(split.time == parting.time);
}

TEST_CASE("critical: of two saddles each split names its own", "[critical]") {
  const Timed t = timed(dumbbell(), {1.0, 0.05, 0.0});
  check_counts(t.criticals, 2, 2, 2, 2);
  REQUIRE(kinds(t.criticals) == std::vector{minimum, minimum, saddle, saddle, maximum, maximum});
  const auto& points = t.criticals.points;
  CHECK(t.loops_at(0.5 * (points[1].time + points[2].time)) == 2);
  CHECK(t.loops_at(0.5) == 1);
  const Split below = t.split_at(0.5 * (points[1].time + points[2].time));
  CHECK(below.cause == minimum);
  CHECK(below.vertex == points[2].vertex);
  const Split above = t.split_at(0.5 * (points[3].time + points[4].time));
  CHECK(above.cause == saddle);
  CHECK(above.vertex == points[3].vertex);
}

TEST_CASE("critical: a saddle where three loops meet counts twice", "[critical]") {
  // Two tips over six corners, three of them pits.
  Mesh mesh;
  for (unsigned i = 0; i < 6; ++i) {
    const TurnPoint at = turn_point(i, 6);
    mesh.positions.emplace_back(at.sine, 0.0, at.cosine);
  }
  mesh.positions.emplace_back(0.0, 1.0, 0.0);
  mesh.positions.emplace_back(0.0, -1.0, 0.0);
  for (VertexId i = 0; i < 6; ++i) {
    mesh.triangles.push_back({i, (i + 1) % 6, 6});
    mesh.triangles.push_back({(i + 1) % 6, i, 7});
  }
  const Timed t = timed_by(mesh, {0.30, 0.70, 0.31, 0.71, 0.32, 0.72, 0.5, 1.0});
  check_counts(t.criticals, 3, 2, 1, 2);
  REQUIRE(kinds(t.criticals) == std::vector{minimum, minimum, minimum, saddle, maximum});
  CHECK(t.criticals.points[3].vertex == 6);
  CHECK(t.criticals.points[3].multiplicity == 2);
  CHECK(t.loops_at(0.4) == 3);
  CHECK(t.loops_at(0.6) == 1);
  CHECK(t.split_at(0.4).cause == minimum);
  CHECK(t.split_at(0.4).vertex == 6);
}

TEST_CASE("critical: find_split names the last sound level", "[critical]") {
  const Timed ball = timed(sphere(24, 13));
  CHECK_FALSE(find_split(*ball.input, ball.times, ball.criticals,
                         group_levels(*ball.input, ball.times, ball.criticals, 1e-5)));
  for (const Mesh& mesh : {torus(48, 24, 1.0, 0.4), test_support::arch(), dumbbell()}) {
    for (const glm::dvec3& axis : {glm::dvec3(1.0, 0.05, 0.0), glm::dvec3(0.1, -1.0, 0.0)}) {
      const Timed t = timed(mesh, axis);
      const Levels levels = group_levels(*t.input, t.times, t.criticals, 1e-5);
      INFO(mesh.name << " along " << axis.x << ", " << axis.y);
      const auto split = find_split(*t.input, t.times, t.criticals, levels);
      CHECK(split == levels.split);
      std::int32_t first = -1;  // level whose set has several loops
      for (std::int32_t i = 1; i < levels.count() && first < 0; ++i)
        if (t.loops_at(levels.times[static_cast<std::size_t>(i)]) > 1) first = i;
      if (first < 0) {
        CHECK_FALSE(split);
        continue;
      }
      REQUIRE(split);
      CHECK(split->level == first - 1);
      CHECK(split->loops == t.loops_at(levels.times[static_cast<std::size_t>(first)]));
      Split why = t.split_at(levels.times[static_cast<std::size_t>(first)]);
      why.level = split->level;
      why.loops = split->loops;
      CHECK(*split == why);
    }
  }
}
