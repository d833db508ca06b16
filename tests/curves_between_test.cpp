// What lies between cycles: every check with its sentence, what is left out and said, what is chosen for the person.
#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "knit/curves/between.h"
#include "knit/curves/embed.h"
#include "knit/import/check.h"
#include "knit/mesh/shapes.h"
#include "tests/support/bodies.h"
#include "tests/support/cycles.h"

using namespace knit;
using namespace test_support;

namespace {

constexpr CycleEnd at_start = CycleEnd::start;
constexpr CycleEnd at_end = CycleEnd::end;

// The triangles whose middles `drop` does not hold for; vertices stay.
template <class Drop>
Mesh ball_without(unsigned subdivisions, const Drop& drop) {
  Mesh ball = icosphere(subdivisions);
  std::erase_if(ball.triangles, [&](const Triangle& t) {
    return drop((ball.positions[t[0]] + ball.positions[t[1]] + ball.positions[t[2]]) / 3.0);
  });
  return ball;
}

Mesh holed_ball() {
  return ball_without(4, [](const glm::dvec3& at) { return glm::length(at - on_ball(1.5, 1.0)) <= 0.12; });
}

Mesh two_balls() {
  Mesh both = icosphere(3);
  const auto shift = static_cast<VertexId>(both.positions.size());
  const std::vector<Triangle> triangles = both.triangles;
  const std::vector<glm::dvec3> positions = both.positions;
  for (const glm::dvec3& p : positions) both.positions.push_back(p + glm::dvec3(3, 0, 0));
  for (const Triangle& t : triangles) both.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return both;
}

Cycle across_arm(double x, CycleEnd as) {
  Cycle cycle = through(CycleKind::plane, {{x, 0.0, 0.0}}, as);
  cycle.normal = {0.0, 0.0, 1.0};
  return cycle;
}

bool says(const Between& piece, const std::string& words) {
  return std::any_of(piece.notes.begin(), piece.notes.end(),
                     [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

double share_left_out(const Between& piece) {
  double share = 0.0;
  for (const CutCap& cap : piece.caps) share += cap.share;
  return share;
}

// A piece with two rims that a run may take.
void check_tube(const Between& piece) {
  REQUIRE(piece.rims.size() == 2);
  CHECK(piece.before.size() == piece.mesh.positions.size());
  const auto count = [](std::size_t size) { return static_cast<std::ptrdiff_t>(size); };
  CHECK(count(piece.mesh.positions.size()) - count(piece.mesh.edges.size()) +
            count(piece.mesh.triangles.size()) ==
        0);
  // Its rims are wanted, however short they are.
  for (const Finding& finding : check(piece.mesh).findings)
    CHECK((finding.severity == Severity::warning || finding.kind == FindingKind::open_edges));
  const auto rims = boundary_rings(piece.mesh.triangles);
  REQUIRE(rims.size() == 2);
  for (const CutRim& rim : piece.rims) CHECK(std::find(rims.begin(), rims.end(), rim.vertices) != rims.end());
}

}  // namespace

TEST_CASE("curves between: two circles, and what lies beyond them", "[curves]") {
  const Between piece = between(
      icosphere(4), {circle_at(on_ball(2.4, 0.5), 0.6, at_start), circle_at(on_ball(0.9, 2.0), 0.2, at_end)});
  check_tube(piece);
  CHECK(piece.rims[0].as == at_start);
  CHECK(piece.rims[0].time == 0.0);
  CHECK(piece.rims[1].as == at_end);
  CHECK(piece.rims[1].time == 1.0);
  REQUIRE(piece.caps.size() == 2);
  const auto cap = [](double radius) { return 0.5 * (1.0 - std::cos(radius)); };
  std::vector<double> shares{piece.caps[0].share, piece.caps[1].share};
  std::sort(shares.begin(), shares.end());
  CHECK(shares[0] == Approx(cap(0.2)).margin(0.001));
  CHECK(shares[1] == Approx(cap(0.6)).margin(0.002));
  CHECK(says(piece, "left out: 8.7 % of the surface beyond the start"));
  CHECK(says(piece, "% of the surface beyond the end"));
}

TEST_CASE("curves between: a cylinder's rims by four clicks each", "[curves]") {
  std::vector<Cycle> cycles;
  for (const CycleEnd as : {at_start, at_end}) {
    std::vector<glm::dvec3> clicks;
    for (unsigned i = 0; i < 4; ++i) {
      const TurnPoint at = turn_point(i, 4);
      clicks.emplace_back(at.sine, as == at_start ? 0.0 : 2.0, -at.cosine);
    }
    cycles.push_back(through(CycleKind::path, clicks, as));
  }
  const Between piece = between(cylinder(32, 1.0, 2.0, 8), cycles);
  check_tube(piece);
  REQUIRE(piece.caps.size() == 2);
  for (const CutCap& cap : piece.caps) CHECK(cap.share == Approx(0.166).margin(0.002));
  for (const CutRim& rim : piece.rims) CHECK(rim.vertices.size() == 32);
  CHECK(std::count(piece.before.begin(), piece.before.end(), no_vertex) == 0);
}

TEST_CASE("curves between: a click away from the surface", "[curves]") {
  CHECK(refusal(icosphere(4), {circle_at(on_ball(1.4, 0.5, 1.3), 0.3, at_start)}) ==
        "start: point 1 is 0.301 away from the surface, more than 1 % of its size (0.0346). Was the mesh "
        "moved or "
        "scaled?");
}

TEST_CASE("curves between: a radius that is none", "[curves]") {
  const Mesh ball = icosphere(4);
  CHECK(refusal(ball, {circle_at(on_ball(2.4, 0.5), 0.0, at_start)}) == "start: the radius must be above 0.");
  CHECK(refusal(ball, {circle_at(on_ball(2.4, 0.5), -1.0, at_end)}) == "end: the radius must be above 0.");
  const std::string far = refusal(ball, {circle_at(on_ball(2.4, 0.5), 4.0, at_start)});
  CHECK(far.starts_with("start: the radius 4 reaches beyond the farthest point of the surface (3.1"));
  Cycle band = through(CycleKind::band, {on_ball(1.0, 0.0), on_ball(1.2, 0.0)}, at_start);
  band.radius = 0.0;
  CHECK(refusal(ball, {band}) == "start: the radius must be above 0.");
}

TEST_CASE("curves between: too few points, or all on one line", "[curves]") {
  const Mesh ball = icosphere(3);
  CHECK(refusal(ball, {through(CycleKind::path, {on_ball(2.2, 0.3), on_ball(2.2, 3.6)}, at_start)}) ==
        "start: a closed path needs at least 3 points.");
  const Mesh box = cylinder(32, 1.0, 2.0, 8);
  CHECK(refusal(box, {through(CycleKind::plane, {{0.0, 0.5, 1.0}, {0.0, 1.0, 1.0}, {0.0, 1.5, 1.0}},
                              at_start)}) == "start: three points on one line give no plane.");
  Cycle flat = through(CycleKind::plane, {{0.0, 1.0, 1.0}}, at_start);
  flat.normal = glm::dvec3(0.0);
  CHECK(refusal(box, {flat}) == "start: a normal without length gives no plane.");
}

TEST_CASE("curves between: a closed mesh has no edge to begin at", "[curves]") {
  Cycle cycle{.as = at_start};
  cycle.kind = CycleKind::boundary;
  CHECK(refusal(icosphere(3), {cycle}) == "start: the mesh has no edge; it is closed.");
}

TEST_CASE("curves between: paths that meet or cross themselves", "[curves]") {
  const Mesh ball = icosphere(4);
  // In the wrong order round the shape.
  const std::string wrong = refusal(
      ball,
      {through(CycleKind::path, {on_ball(2.2, 0.3), on_ball(2.2, 3.6), on_ball(2.2, 2.0), on_ball(2.2, 5.0)},
               at_start)});
  CHECK((wrong == "start: the path crosses itself. Set the points in their order round the shape." ||
         (wrong.starts_with("start: the path meets itself near (") &&
          wrong.ends_with("). Set the points in their order round the shape."))));
  // There and back again, over a vertex that stands on both ways.
  const glm::dvec3 a = ball.positions[ball.triangles[0][0]];
  const glm::dvec3 b = ball.positions[ball.triangles[0][1]];
  const glm::dvec3 c = ball.positions[ball.triangles[0][2]];
  CHECK(refusal(ball, {through(CycleKind::path, {a, b, c, b}, at_start)})
            .starts_with("start: the path meets itself near ("));
  CHECK(refusal(ball, {through(CycleKind::path, {a, a, a}, at_start)}) ==
        "start: the points of the path lie too near together.");
}

TEST_CASE("curves between: two ways that cross in the middle of a triangle", "[curves]") {
  // Two large triangles make a kite; the ways from corner to corner cross in one of them and share no place.
  Mesh kite;
  kite.positions = {{-2, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, -3, 0}, {0, 0, -1}};
  kite.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}};
  const std::string said = refusal(
      kite,
      {through(CycleKind::path, {{-0.9, 0.2, 0}, {0.9, 1.0, 0}, {0.9, 0.3, 0}, {-0.6, 1.2, 0}}, at_start)});
  CHECK(said == "start: the path crosses itself. Set the points in their order round the shape.");
}

TEST_CASE("curves between: cycles that cross, and that touch", "[curves]") {
  CHECK(refusal(icosphere(4),
                {circle_at(on_ball(1.4, 0.5), 0.6, at_start), circle_at(on_ball(0.9, 0.5), 0.5, at_end)}) ==
        "start and end cross each other. Move one of them away.");
  const Mesh box = cylinder(32, 1.0, 2.0, 8);
  const auto level = [&](double height, CycleEnd as) {
    Cycle plane = through(CycleKind::plane, {{1.0, height, 0.0}}, as);
    plane.normal = {0.0, 1.0, 0.0};
    return plane;
  };
  CHECK(refusal(box, {level(1.0, at_start), level(1.0, at_end)}) ==
        "start and end touch. They must not share a point.");
  Cycle cuff = level(1.0, at_start);
  cuff.name = "cuff";
  Cycle rib = level(1.5, at_start);
  rib.name = "rib";
  Cycle slant = through(CycleKind::plane, {{1.0, 1.45, 0.0}}, at_end);
  slant.normal = {0.0, 1.0, 0.2};
  CHECK(refusal(box, {cuff, rib, slant}) == "rib and end cross each other. Move one of them away.");
}

TEST_CASE("curves between: a ring shape needs two cuts across one arm", "[curves]") {
  const Mesh ring = torus(48, 24, 1.0, 0.3);
  CHECK(refusal(ring, {across_arm(1.3, at_start)}) ==
        "start does not part the surface: both its sides are the same piece. On a ring shape a start and an "
        "end "
        "are both needed, and each must go round the same arm.");
  const Between piece = between(ring, {across_arm(1.3, at_start), across_arm(-1.3, at_end)});
  check_tube(piece);
  CHECK(says(piece, "2 pieces lie between start and end; the largest is knitted"));
  CHECK(says(piece, "of the surface beyond the start and the end"));
}

TEST_CASE("curves between: a handle is handed on", "[curves]") {
  const std::string said = refusal(torus(48, 24, 1.0, 0.3), {circle_at({1.3, 0.0, 0.0}, 0.2, at_start),
                                                             circle_at({-1.3, 0.0, 0.0}, 0.2, at_end)});
  CHECK(said == "The piece between start and end has 1 handle: its rows part there.");
}

TEST_CASE("curves between: cycles on two pieces of the mesh", "[curves]") {
  CHECK(refusal(two_balls(), {circle_at(on_ball(2.4, 0.5), 0.4, at_start),
                              circle_at(on_ball(0.9, 2.0) + glm::dvec3(3, 0, 0), 0.3, at_end)}) ==
        "No piece of the surface lies between start and end: they are on different pieces.");
  CHECK(refusal(two_balls(),
                {through(CycleKind::path,
                         {on_ball(1.0, 0.0), on_ball(1.2, 1.0), on_ball(1.0, 2.0) + glm::dvec3(3, 0, 0)},
                         at_start)}) == "Points on different pieces of the mesh cannot be joined.");
}

TEST_CASE("curves between: a hole in the piece", "[curves]") {
  const std::string said = refusal(
      holed_ball(), {circle_at(on_ball(2.6, 0.5), 0.3, at_start), circle_at(on_ball(0.5, 2.0), 0.3, at_end)});
  CHECK(said.starts_with("The piece between start and end has 1 more edge ("));
  CHECK(said.find(" long, near (0.5") != std::string::npos);
  CHECK(said.ends_with("): close the hole, or make it an end."));
}

TEST_CASE("curves between: no cycle may touch an edge of the mesh", "[curves]") {
  const Mesh holed = holed_ball();
  const std::string sentence = "start: a cycle may not touch an edge of the mesh.";
  const Cycle away = circle_at(on_ball(2.6, 4.0), 0.3, at_end);
  CHECK(refusal(holed, {circle_at(on_ball(1.5, 1.3), 0.3, at_start), away}) == sentence);
  Cycle plane = through(CycleKind::plane, {on_ball(1.5, 1.3)}, at_start);
  plane.normal = {0.0, 1.0, 0.0};
  CHECK(refusal(holed, {plane, away}) == sentence);
  const glm::dvec3 beside = on_ball(1.5, 0.5);
  glm::dvec3 on_rim(9.0);
  const auto rims = boundary_rings(holed.triangles);
  for (const VertexId v : rims.front())
    if (glm::length(holed.positions[v] - beside) < glm::length(on_rim - beside)) on_rim = holed.positions[v];
  CHECK(refusal(holed, {through(CycleKind::path, {on_rim, on_ball(1.2, 0.5), on_ball(1.8, 0.5)}, at_start),
                        away}) == sentence);
}

TEST_CASE("curves between: nested circles are warned of", "[curves]") {
  const Between piece = between(
      icosphere(4), {circle_at(on_ball(1.4, 0.5), 0.8, at_start), circle_at(on_ball(1.4, 0.5), 0.3, at_end)});
  check_tube(piece);
  CHECK(share_left_out(piece) > 0.8);
  CHECK(says(piece, "more than half of the surface is left out"));
  const Between plain = between(
      icosphere(4), {circle_at(on_ball(2.4, 0.5), 0.6, at_start), circle_at(on_ball(0.9, 2.0), 0.2, at_end)});
  CHECK_FALSE(says(plain, "more than half"));
}

TEST_CASE("curves between: what is not given is chosen, and said", "[curves]") {
  // Closed: the farthest point.
  const Between closed = between(icosphere(4), {circle_at(on_ball(2.4, 0.5), 0.6, at_start)});
  check_tube(closed);
  CHECK(says(closed, "end: the point farthest from the other, ("));
  const auto& end_rim = closed.rims[1].vertices;
  double around = 0.0;
  for (std::size_t i = 0; i < end_rim.size(); ++i)
    around += glm::length(closed.mesh.positions[end_rim[i]] -
                          closed.mesh.positions[end_rim[(i + 1) % end_rim.size()]]);
  CHECK(around == Approx(6 * 0.1).epsilon(0.05));
  // Only an end: the start is far from it.
  const Between only_end = between(icosphere(4), {circle_at(on_ball(2.4, 0.5), 0.6, at_end)});
  check_tube(only_end);
  CHECK(says(only_end, "start: the point farthest from the other, ("));
  // One edge: it is the start.
  const Mesh hat = ball_without(4, [](const glm::dvec3& at) { return at.y < 0.0; });
  const Between from_edge = between(hat, {circle_at({0.0, 1.0, 0.0}, 0.1, at_end)});
  check_tube(from_edge);
  CHECK(says(from_edge, "start: the edge of the mesh that lies lowest ("));
  // Two edges.
  const Mesh tube = ball_without(4, [](const glm::dvec3& at) { return std::abs(at.y) > 0.7; });
  Cycle lowest{.as = at_start};
  lowest.kind = CycleKind::boundary;
  const Between both = between(tube, {lowest});
  check_tube(both);
  CHECK(both.caps.empty());
  CHECK(says(both, "end: the other edge of the mesh"));
  CHECK(both.mesh.positions[both.rims[0].vertices.front()].y < 0.0);
  // More than two: it is asked.
  const Mesh three = ball_without(4, [](const glm::dvec3& at) { return std::abs(at.y) > 0.7 || at.x > 0.9; });
  CHECK(refusal(three, {lowest}) == "The mesh has 2 more edges. Say which is the end, or repair the others.");
}

TEST_CASE("curves between: the edge that is meant by a point", "[curves]") {
  const Mesh tube = ball_without(4, [](const glm::dvec3& at) { return std::abs(at.y) > 0.7; });
  const auto rims = boundary_rings(tube.triangles);
  const auto top = std::find_if(rims.begin(), rims.end(),
                                [&](const auto& rim) { return tube.positions[rim.front()].y > 0.0; });
  const Between piece =
      between(tube, {through(CycleKind::boundary, {tube.positions[top->front()]}, at_start)});
  check_tube(piece);
  CHECK(piece.mesh.positions[piece.rims[0].vertices.front()].y > 0.0);
}

TEST_CASE("curves between: a vertex stands for a circle about it", "[curves]") {
  Cycle cycle{.as = at_start};
  cycle.kind = CycleKind::vertex;
  cycle.vertex = 5;
  const Mesh ball = icosphere(4);
  const Between piece = between(ball, {cycle, circle_at(-ball.positions[5], 0.3, at_end)});
  check_tube(piece);
  for (const VertexId v : piece.rims[0].vertices)
    CHECK(glm::length(piece.mesh.positions[v] - ball.positions[5]) ==
          Approx(0.6 / (2.0 * std::numbers::pi)).epsilon(0.05));
  cycle.vertex = 100000;
  CHECK(refusal(ball, {cycle}) == "start: the mesh has no vertex 100000.");
}
