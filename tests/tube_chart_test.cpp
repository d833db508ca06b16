// The chart of a tube: the part of the mesh between two loops, its harmonic time and angle, and what is read from them.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "knit/mesh/branching_shapes.h"
#include "knit/mesh/shapes.h"
#include "knit/rows/contour.h"
#include "knit/short_rows/annulus.h"
#include "knit/short_rows/sides.h"
#include "knit/short_rows/tube_chart.h"
#include "tests/support/bent_tubes.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"

using namespace knit;
using namespace test_support;

namespace {

constexpr TubeNet coarse{48, 40};

TubePart part_of_tube(const BentTube& tube, double width = 10.0) {
  const auto input = make_input(tube.mesh);
  const auto part = whole_tube(*input, tube.bottom, tube.beginning, width);
  REQUIRE(std::holds_alternative<TubePart>(part));
  return std::get<TubePart>(part);
}

TubeChart chart_of(const TubePart& part, double height) {
  const auto chart = make_tube_chart(part, height);
  if (const auto* refusal = std::get_if<ChartRefusal>(&chart)) INFO(sentence_of(*refusal));
  REQUIRE(std::holds_alternative<TubeChart>(chart));
  return std::get<TubeChart>(chart);
}

const RowFrame upwards = row_frame({0, 1, 0}, std::nullopt);

std::vector<Shared<Ring>> loops_of(const Input& input, const std::vector<double>& field, double value) {
  const std::vector<double> values{value};
  return cut_surface(input, field, values, values, upwards)[0].loops;
}

// What cutting leaves: two rims on the level sets, one piece, no handle, no long edge.
void check_part(const TubePart& part, double longest) {
  const std::vector<HalfEdge> across = across_sides(part.triangles);
  const auto on_rim = static_cast<std::size_t>(std::count(across.begin(), across.end(), no_half_edge));
  CHECK(on_rim == part.low.size() + part.high.size());
  CHECK(part.points.size() + part.triangles.size() == (3 * part.triangles.size() + on_rim) / 2);
  double greatest = 0.0;
  for (const Triangle& f : part.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      greatest = std::max(greatest, glm::distance(part.points[f[k]], part.points[f[(k + 1) % 3]]));
  CHECK(greatest <= longest);
}

}  // namespace

TEST_CASE("tube chart: on a cylinder columns stand upright and levels lie flat") {
  const TubePart part = part_of_tube(slanted_cylinder(0.0, coarse));
  const TubeChart chart = chart_of(part, 0.4);
  CHECK(chart.residual < 1e-20);
  CHECK(chart.mean_height == Approx(4.0));
  CHECK(chart.levels() == 81);
  CHECK(chart.columns == 256);
  double off = 0.0;
  for (std::int32_t l = 0; l < chart.levels(); ++l) {
    for (std::int32_t j = 0; j < chart.columns; ++j) {
      const auto at = static_cast<std::size_t>(l * chart.columns + j);
      off = std::max(off, std::abs(chart.heights[at] - 4.0 * l / 80.0));
      off = std::max(off, std::abs(chart.points[at].z - 4.0 * l / 80.0));
      // Seen along the knitting, upwards, work goes round counter-clockwise: seen from above the other way.
      const double turn = -2.0 * std::numbers::pi * j / 256.0;
      off =
          std::max(off, std::abs(chart.points[at].x * std::sin(turn) - chart.points[at].y * std::cos(turn)));
      if (chart.points[at].x * std::cos(turn) + chart.points[at].y * std::sin(turn) < 0.9) off = 1.0;
    }
  }
  CHECK(off < 1e-4);
}

TEST_CASE("tube chart: the angle is the quarter turn of the time where the mesh is even") {
  CHECK(solve_annulus(part_of_tube(half_ring()))->residual < 1e-3);
  CHECK(solve_annulus(part_of_tube(oblique_cone()))->residual < 1e-3);
  // On a cone both are known: the time goes with the logarithm of the radius.
  const TubePart part = part_of_tube(turned_tube("cone", [](double up) { return glm::dvec2(2.0 - up, up); }));
  const auto fields = solve_annulus(part);
  double off = 0.0;
  for (std::size_t v = 0; v < part.points.size(); ++v) {
    const double radius = std::hypot(part.points[v].x, part.points[v].y);
    off = std::max(off, std::abs(fields->time[v] - std::log(2.0 / radius) / std::log(2.0)));
  }
  CHECK(off < 1e-3);
}

TEST_CASE("tube chart: levels are even in mean height however steep the time is") {
  const TubeChart chart = chart_of(part_of_tube(banana({64, 120})), 0.25);
  const std::int32_t columns = chart.columns;
  std::vector<double> steps;
  for (std::int32_t l = 0; l + 1 < chart.levels(); ++l) {
    double step = 0.0, width = 0.0;
    for (std::int32_t j = 0; j < columns; ++j) {
      const glm::dvec3 here = point_at(chart, l, j), up = point_at(chart, l + 1, j);
      const double wide =
          glm::distance(here, point_at(chart, l, j + 1)) + glm::distance(up, point_at(chart, l + 1, j + 1));
      step += wide * glm::distance(here, up);
      width += wide;
    }
    steps.push_back(step / width);
  }
  const auto [least, greatest] = std::minmax_element(steps.begin(), steps.end());
  CHECK(*greatest / *least < 1.03);
  CHECK(*greatest == Approx(chart.mean_height / chart.last_level()).epsilon(0.02));
}

TEST_CASE("tube chart: a round's curve begins at its column and finds its columns again") {
  const TubeChart chart = chart_of(part_of_tube(half_ring(coarse)), 0.3);
  const double first = 37.25;
  const Ring ring = ring_at(chart, 20.5, first);
  REQUIRE(ring.points.size() == 256);
  CHECK(glm::distance(ring.points[0], point_at(chart, 20.5, first)) == 0.0);
  CHECK(glm::distance(point_at(chart, 20.5, first + 256.0), ring.points[0]) < 1e-12);
  CHECK(glm::distance(point_at(chart, 20.5, first - 256.0), ring.points[0]) < 1e-12);
  for (const double share : {0.0, 0.123, 0.5, 0.77, 0.9999}) {
    const double column = column_of(chart, ring, first, share * ring.length);
    CHECK(glm::distance(point_at(chart, 20.5, column), point_at(ring, share * ring.length)) < 0.02);
    CHECK(column >= first);
    CHECK(column <= first + 256.0);
  }
  const std::vector<double> heights = heights_at(chart, 20.5);
  CHECK(heights[9] == Approx(0.5 * (chart.heights[20 * 256 + 9] + chart.heights[21 * 256 + 9])));
}

TEST_CASE("tube chart: a mesh too coarse for it is refused with a word") {
  // A tube of five sides in two rings that are turned against each other, one of them drawn far out.
  const BentTube tube = ringed_tube("crude", {5, 2}, [](double up, double turn) {
    const double t = 2.0 * std::numbers::pi * (turn + 0.35 * up), out = up == 0.5 && turn < 0.1 ? 4.0 : 1.0;
    return glm::dvec3(out * std::cos(t), out * std::sin(t), 0.6 * up);
  });
  const auto chart = make_tube_chart(part_of_tube(tube), 0.1);
  REQUIRE(std::holds_alternative<ChartRefusal>(chart));
  const ChartRefusal& refusal = std::get<ChartRefusal>(chart);
  CHECK(refusal.reason == ChartRefusal::Reason::residual);
  CHECK(refusal.residual > greatest_residual);
  CHECK(sentence_of(refusal).find("a finer mesh near its short loops helps") != std::string::npos);
}

TEST_CASE("tube chart: beginnings move the columns and nothing else") {
  BentTube tube = half_ring(coarse);
  const TubeChart one = chart_of(part_of_tube(tube), 0.3);
  tube.beginning = point_at(one, 0.0, 64.0);
  const TubeChart other = chart_of(part_of_tube(tube), 0.3);
  double off = 0.0;
  for (std::int32_t j = 0; j < 256; ++j)
    off = std::max(off, glm::distance(point_at(one, 30.0, j + 64.0), point_at(other, 30.0, j)));
  CHECK(off < 1e-3);
}

TEST_CASE("tube part: between two loops of a level each with its triangles cut along them") {
  const auto input = make_input(sphere(48, 24));
  const std::vector<double> field = field_along(*input, {0, 1, 0});
  const auto low = loops_of(*input, field, 0.2222), high = loops_of(*input, field, 0.85);
  const auto part = cut_tube(*input, field, {0.2222, &*low[0]}, {0.85, &*high[0]}, 10.0);
  REQUIRE(std::holds_alternative<TubePart>(part));
  const TubePart& tube = std::get<TubePart>(part);
  check_part(tube, 12.0);
  double off = 0.0;
  for (const VertexId v : tube.low) off = std::max(off, std::abs(tube.points[v].y - (2 * 0.2222 - 1)));
  for (const VertexId v : tube.high) off = std::max(off, std::abs(tube.points[v].y - (2 * 0.85 - 1)));
  CHECK(off < 0.01);
  // In working order: as the curve of the round runs.
  const TubeChart chart = chart_of(tube, 0.1);
  CHECK(glm::distance(point_at(chart, 0.0, 0.0), low[0]->points[0]) < 0.01);
  CHECK(glm::distance(point_at(chart, 0.0, 64.0), point_at(*low[0], 0.25 * low[0]->length)) < 0.02);
  CHECK(chart.residual < 0.003);
}

TEST_CASE("tube part: a mesh whose triangles face in makes the same chart") {
  Mesh mesh = sphere(32, 16);
  const auto out = make_input(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (t % 3 != 1) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  const auto in = make_input(mesh);
  const std::vector<double> field = field_along(*out, {0, 1, 0});
  const auto low = loops_of(*out, field, 0.2), high = loops_of(*out, field, 0.8);
  const auto one = cut_tube(*out, field, {0.2, &*low[0]}, {0.8, &*high[0]}, 1.0),
             other = cut_tube(*in, field, {0.2, &*low[0]}, {0.8, &*high[0]}, 1.0);
  REQUIRE(std::holds_alternative<TubePart>(one));
  REQUIRE(std::holds_alternative<TubePart>(other));
  const TubeChart a = chart_of(std::get<TubePart>(one), 0.2), b = chart_of(std::get<TubePart>(other), 0.2);
  double off = 0.0;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    off = std::max(off, glm::distance(a.points[i], b.points[i]));
  CHECK(off < 1e-6);
}

TEST_CASE("tube part: limbs stay in it, rings have two sides, and openings are refused") {
  // Below the fork of a y; the loops of its arms are told apart by their curves.
  const auto y = make_input(letter_y(0.08));
  const std::vector<double> field = field_along(*y, {0, 1, 0});
  const auto arms = loops_of(*y, field, 0.8), trunk = loops_of(*y, field, 0.3),
             tips = loops_of(*y, field, 0.92);
  REQUIRE(arms.size() == 2);
  REQUIRE(trunk.size() == 1);
  REQUIRE(tips.size() == 2);
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const auto part = cut_tube(*y, field, {0.8, &*arms[arm]}, {0.92, &*tips[arm]}, 0.2);
    REQUIRE(std::holds_alternative<TubePart>(part));
    check_part(std::get<TubePart>(part), 0.24 + 1e-9);
    for (const glm::dvec3& p : std::get<TubePart>(part).points) CHECK(p.x * arms[arm]->points[0].x > 0.0);
    // From the trunk to one arm's tip: the other arm is a limb that stays.
    const auto whole = cut_tube(*y, field, {0.3, &*trunk[0]}, {0.92, &*tips[arm]}, 0.2);
    REQUIRE(std::holds_alternative<TubePart>(whole));
    check_part(std::get<TubePart>(whole), 0.24 + 1e-9);
  }
  CHECK(std::get<NoPart>(cut_tube(*y, field, {0.8, &*arms[0]}, {0.92, &*tips[1]}, 0.2)) == NoPart::apart);
  CHECK(std::get<NoPart>(cut_tube(*y, field, {-1.0, &*arms[0]}, {0.92, &*tips[1]}, 0.2)) == NoPart::no_loop);

  // One arm of a standing ring: the way over the bottom joins the same two loops.
  const auto ring = make_input(torus(64, 32, 1.0, 0.4));
  const std::vector<double> across = field_along(*ring, {1, 0, 0});
  const RowFrame sideways = row_frame({1, 0, 0}, std::nullopt);
  const std::vector<double> values{0.4, 0.6};
  const std::vector<Cut> cuts = cut_surface(*ring, across, values, values, sideways);
  REQUIRE(cuts[0].loops.size() == 2);
  std::size_t same = 0;
  while (cuts[1].loops[same]->points[0].z * cuts[0].loops[0]->points[0].z < 0.0) ++same;
  const auto arm = cut_tube(*ring, across, {0.4, &*cuts[0].loops[0]}, {0.6, &*cuts[1].loops[same]}, 1.0);
  REQUIRE(std::holds_alternative<TubePart>(arm));
  for (const glm::dvec3& p : std::get<TubePart>(arm).points) CHECK(std::abs(p.x) < 0.4);

  Mesh holed = sphere(32, 16);
  holed.triangles.erase(holed.triangles.begin() + static_cast<std::ptrdiff_t>(holed.triangles.size() / 2));
  const auto open = make_input(holed);
  const std::vector<double> up = field_along(*open, {0, 1, 0});
  const auto low = loops_of(*open, up, 0.2), high = loops_of(*open, up, 0.8);
  const auto refused = cut_tube(*open, up, {0.2, &*low[0]}, {0.8, &*high[0]}, 1.0);
  REQUIRE(std::holds_alternative<NoPart>(refused));
  CHECK(std::get<NoPart>(refused) == NoPart::no_annulus);
  CHECK(sentence_of(NoPart::no_annulus) ==
        "no short rows: this tube has an opening or a handle between its ends");
}
