#include "knit/quality/quality.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"
#include "tests/support/tube.h"

using namespace knit;
using test_support::HandTube;

namespace {

constexpr double row_of_thesis = std::numbers::pi / 65.0;

double side_of(int stitches) { return 2.0 * std::sin(std::numbers::pi / stitches); }

Quality measured(const State& state, double width, double height) {
  return measure_quality(*make_input(test_support::mesh_of(state)), state, width, height);
}

Quality measured(HandTube tube) {
  const double side = side_of(tube.sizes.front());
  tube.row_height = side;
  return measured(test_support::tube_state(tube), side, side);
}

std::size_t total(const Histogram& histogram) {
  return std::accumulate(histogram.bins.begin(), histogram.bins.end(), std::size_t{0});
}

// The sphere's middle is the origin and rows begin at -z, so left is right with x negated.
MirrorError mirror_by_trying_all(const State& state, double width) {
  const std::vector<glm::dvec3> path = knitting_path(state.fabric);
  const auto flip = [](const glm::dvec3& p) { return glm::dvec3(-p.x, p.y, p.z); };
  MirrorError error;
  double count = 0.0;
  for (const auto& strip : state.fabric.strips()) {
    for (const auto& [lower, upper] : strip->column_edges) {
      double best = 1e300;
      for (const auto& [p, q] : strip->column_edges) {
        best = std::min(best, std::max(glm::distance(flip(path[lower]), path[p]),
                                       glm::distance(flip(path[upper]), path[q])));
      }
      error.mean += best / width;
      error.max = std::max(error.max, best / width);
      count += 1.0;
    }
  }
  error.mean /= count;
  return error;
}

}  // namespace

TEST_CASE("quality: a spread's rank, histogram and figures", "[quality]") {
  std::vector<double> values(40);
  std::iota(values.rbegin(), values.rend(), 1.0);
  const Spread spread = spread_of(values, 0.0, 40.0, 4);
  CHECK(spread.count == 40);
  CHECK(spread.mean == Approx(20.5));
  CHECK(spread.low == 1.0);
  CHECK(spread.high == 40.0);
  CHECK(spread.p95 == 38.0);
  CHECK(spread.histogram.bins == std::vector<std::size_t>{9, 10, 10, 11});
  CHECK(spread_of(std::vector<double>{3.0}, 0.0, 1.0, 2).p95 == 3.0);
  CHECK(spread_of(std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, 0.0, 1.0, 2).p95 == 10.0);
}

TEST_CASE("quality: a histogram's ends take what lies beyond", "[quality]") {
  const std::vector<double> values{-1e300, -1.0, 0.0, 0.99, 1.0, 2.0, 2.5, 1e300, std::nan("")};
  const Histogram histogram = spread_of(values, 0.0, 2.0, 2).histogram;
  CHECK(histogram.low == 0.0);
  CHECK(histogram.high == 2.0);
  CHECK(histogram.bins == std::vector<std::size_t>{5, 4});
  CHECK(spread_of(values, 0.0, 2.0, 0).histogram.bins.empty());
  const Spread none = spread_of({}, 0.0, 2.0, 3);
  CHECK(none.count == 0);
  CHECK(none.p95 == 0.0);
  CHECK(none.histogram.bins == std::vector<std::size_t>{0, 0, 0});
}

TEST_CASE("quality: a straight tube of squares is perfect", "[quality]") {
  const Quality quality = measured(HandTube{});
  for (const Spread* spread : {&quality.course, &quality.long_course, &quality.wale}) {
    CHECK(spread->mean == Approx(1.0));
    CHECK(spread->cv == Approx(0.0).margin(1e-12));
    CHECK(spread->p95 == Approx(1.0));
    CHECK(spread->histogram.high == 2.0);
    CHECK(spread->histogram.bins.size() == 40);
  }
  CHECK(quality.course.count == 48);
  CHECK(quality.wale.count == 32);
  CHECK(quality.corner.count == 128);
  CHECK(quality.corner.low == Approx(90.0));
  CHECK(quality.corner.high == Approx(90.0));
  CHECK(quality.corner.histogram.bins.size() == 36);
  CHECK(total(quality.corner.histogram) == 128);
  CHECK(quality.worst_course_cv_in_row == Approx(0.0).margin(1e-12));
  CHECK(quality.quad_share == 1.0);
  CHECK(quality.faces.quads == 32);
  CHECK(quality.regular_share == 1.0);
  CHECK(quality.steady_shaping == 7);
  CHECK(quality.offset == Approx(0.0).margin(1e-12));
  REQUIRE(quality.mirror);
  CHECK(quality.mirror->max == Approx(0.0).margin(1e-12));
  REQUIRE(quality.rows.size() == 3);
  CHECK(quality.rows[2].row == 3);
  CHECK(quality.rows[2].stitches == 16);
  CHECK(quality.rows[2].length == Approx(16.0 * side_of(16)));
  CHECK(quality.rows[2].ideal == Approx(16.0));
  CHECK(quality.rows[2].course_cv == Approx(0.0).margin(1e-12));
}

TEST_CASE("quality: lengths are counted in the stitch asked for", "[quality]") {
  HandTube tube;
  tube.row_height = 0.6;
  const Quality quality = measured(test_support::tube_state(tube), 0.5, 0.4);
  CHECK(quality.stitch_width == 0.5);
  CHECK(quality.stitch_height == 0.4);
  CHECK(quality.course.mean == Approx(side_of(16) / 0.5));
  CHECK(quality.wale.mean == Approx(1.5));
  CHECK(quality.rows[0].ideal == Approx(16.0 * side_of(16) / 0.5));
  CHECK(quality.steady_shaping == 6);  // 2 pi 0.8 = 5.03
}

TEST_CASE("quality: a twisted tube's offset and mirror error are chords", "[quality]") {
  HandTube tube;
  tube.twist = 0.02;
  const double side = side_of(16);
  const Quality quality = measured(tube);
  CHECK(quality.offset == Approx(2.0 * std::sin(0.01) / side));
  CHECK(quality.long_offset == Approx(quality.offset));
  CHECK(quality.wale.mean == Approx(std::hypot(side, 2.0 * std::sin(0.01)) / side));
  // Ends of the lower strip meet at turns 0 and 0.04 apart, those of the upper at 0.04 and 0.08.
  REQUIRE(quality.mirror);
  CHECK(quality.mirror->max == Approx(2.0 * std::sin(0.04) / side));
  CHECK(quality.mirror->mean == Approx((std::sin(0.02) + std::sin(0.04)) / side));
  CHECK(quality.corner.low < 89.0);
  CHECK(quality.corner.high > 91.0);
}

TEST_CASE("quality: rows below 12 stitches are no long rows", "[quality]") {
  HandTube tube{{11, 11}, 1.0, 1.0, 0.02};
  Quality quality = measured(tube);
  CHECK(quality.course.count == 22);
  CHECK(quality.long_course.count == 0);
  CHECK(quality.offset > 0.01);
  CHECK(quality.long_offset == 0.0);
  tube.sizes = {11, 12, 12};
  quality = measured(tube);
  CHECK(quality.long_course.count == 24);
  CHECK(quality.long_offset == Approx(2.0 * std::sin(0.01) / side_of(11)));
  CHECK(quality.long_offset < quality.offset);
}

TEST_CASE("quality: an increase costs a triangle and a stitch its regularity", "[quality]") {
  Quality quality = measured(HandTube{{4, 4, 5}});
  CHECK(quality.faces.quads == 8);
  CHECK(quality.faces.triangles == 1);
  CHECK(quality.quad_share == Approx(8.0 / 9.0));
  CHECK(quality.regular_share == 0.75);
  CHECK(quality.corner.count == 35);
  CHECK(quality.shaping.increases == 1);
  quality = measured(HandTube{{5, 4, 4, 4}});
  CHECK(quality.regular_share == Approx(7.0 / 8.0));
  CHECK(quality.shaping.decreases == 1);
  // Shaping into or out of a row counts on the side of the smaller one.
  CHECK(measured(HandTube{{4, 5, 5}}).regular_share == 1.0);
}

TEST_CASE("quality: an uneven row shows in its own cv, and in the worst", "[quality]") {
  State state = test_support::tube_state(HandTube{});
  const auto squeeze = [](Row& row) {
    if (row.id == 2) row.stitches[3].position = row.stitches[2].position;
  };
  state.fabric = test_support::remade(state.fabric, squeeze, [](Strip&) { return true; });
  const Quality quality = measured(state, 1.0, 1.0);
  CHECK(quality.rows[0].course_cv == Approx(0.0).margin(1e-12));
  CHECK(quality.rows[1].course_cv > 0.3);
  CHECK(quality.worst_course_cv_in_row == quality.rows[1].course_cv);
  CHECK(quality.course.low == 0.0);
}

TEST_CASE("quality: the mirror does not care where rows and columns are counted from", "[quality]") {
  State state = test_support::tube_state(HandTube{{100, 100}});
  const auto turn = [](Strip& strip) {
    std::rotate(strip.column_edges.begin(), strip.column_edges.begin() + 37, strip.column_edges.end());
    return true;
  };
  state.fabric = test_support::remade(
      state.fabric, [](Row&) {}, turn);
  CHECK(measured(state, 1.0, 1.0).mirror->max == Approx(0.0).margin(1e-12));
  const State turned = test_support::moved(state, [](const glm::dvec3& p) {
    return glm::dvec3(0.6 * p.x + 0.8 * p.z, p.y, 0.6 * p.z - 0.8 * p.x) + glm::dvec3(5, 6, 7);
  });
  CHECK(measured(turned, 1.0, 1.0).mirror->max == Approx(0.0).margin(1e-12));
}

TEST_CASE("quality: the mirror goes through the middle of the mesh, not of the rows", "[quality]") {
  const State state = test_support::tube_state(HandTube{});
  Mesh aside = test_support::mesh_of(state);
  for (glm::dvec3& p : aside.positions) p += glm::dvec3(0.05, 3.0, 2.0);
  const Quality quality = measure_quality(*make_input(aside), state, 0.5, 0.5);
  REQUIRE(quality.mirror);
  CHECK(quality.mirror->mean == Approx(2.0 * 0.05 / 0.5));
  CHECK(quality.mirror->max == Approx(2.0 * 0.05 / 0.5));
}

TEST_CASE("quality: no mirror where rounds begin along the axis, or without an axis", "[quality]") {
  State state = test_support::tube_state(HandTube{});
  Timing timing = *state.timing;
  timing.ends.direction = {0, 0, 2};
  state.timing = Shared<Timing>(timing);
  CHECK_FALSE(measured(state, 1.0, 1.0).mirror);
  state.timing = {};
  CHECK_FALSE(measured(state, 1.0, 1.0).mirror);
}

TEST_CASE("quality: all sizes grow together and no figure changes", "[quality]") {
  const State state = test_support::tube_state(HandTube{{12, 16, 13}, 1.0, 0.7, 0.1});
  const Quality small = measured(state, 0.4, 0.7);
  const State grown = test_support::moved(state, [](const glm::dvec3& p) { return 1000.0 * p; });
  const Quality large = measured(grown, 400.0, 700.0);
  CHECK(large.course.mean == Approx(small.course.mean));
  CHECK(large.course.cv == Approx(small.course.cv));
  CHECK(large.wale.p95 == Approx(small.wale.p95));
  CHECK(large.corner.high == Approx(small.corner.high));
  CHECK(large.offset == Approx(small.offset));
  CHECK(large.mirror->mean == Approx(small.mirror->mean));
  CHECK(large.steady_shaping == small.steady_shaping);
}

TEST_CASE("quality: the thesis sphere as the study measured it", "[quality]") {
  Timeline timeline(test_support::thesis_sphere(), test_support::thesis_parameters());
  timeline.extend_to_end();
  const State& state = timeline.furthest();
  const Quality quality = measure_quality(timeline.input(), state, 0.1, row_of_thesis);
  CHECK(quality.course.count == 3372);
  CHECK(quality.course.mean == Approx(0.770).margin(0.0005));
  CHECK(quality.course.cv == Approx(0.2018).margin(0.0001));
  CHECK(quality.course.low == Approx(0.415).margin(0.0005));
  CHECK(quality.course.high == Approx(0.987).margin(0.0005));
  CHECK(quality.worst_course_cv_in_row == Approx(0.278).margin(0.0005));
  CHECK(quality.wale.mean * row_of_thesis == Approx(0.0527).margin(0.00005));
  CHECK(quality.wale.cv == Approx(0.368).margin(0.0005));
  CHECK(quality.wale.high * row_of_thesis == Approx(0.2287).margin(0.00015));
  CHECK(quality.offset == Approx(2.236).margin(0.0005));  // the study measured round the circle: 2.26
  CHECK(quality.long_offset <= quality.offset);
  CHECK(quality.quad_share == Approx(3307.0 / 3425.0));
  CHECK(quality.shaping.increases == 59);
  CHECK(quality.shaping.max_in_a_row == 22);
  CHECK(quality.steady_shaping == 4);
  CHECK(quality.rows.size() == 64);
  CHECK(quality.rows[31].ideal == Approx(20.0 * std::numbers::pi).epsilon(0.001));
  // 59 stitches with two links up, 59 with two down, less those in the first and last row: 6 each.
  CHECK(quality.regular_share == Approx(1.0 - 106.0 / 3360.0));
}

TEST_CASE("quality: the mirror error is that of trying all pairs", "[quality]") {
  // With rows at equal arcs the plane is x = 0 exactly, for only the columns lean.
  Timeline timeline(test_support::thesis_sphere(), Parameters{});
  timeline.extend_to_end();
  const State& state = timeline.furthest();
  const Quality quality = measure_quality(timeline.input(), state, 0.1, row_of_thesis);
  const MirrorError expected = mirror_by_trying_all(state, 0.1);
  REQUIRE(quality.mirror);
  CHECK(quality.mirror->mean == Approx(expected.mean));
  CHECK(quality.mirror->max == Approx(expected.max));
  CHECK(quality.mirror->mean > 0.05);
  CHECK(quality.offset == Approx(2.374).margin(0.0005));
}

TEST_CASE("quality: what is not there yet counts 0, at every step of a run", "[quality]") {
  Timeline timeline(test_support::small_sphere(), test_support::small_parameters());
  std::size_t partial = 0;
  do {
    const State& state = timeline.state();
    const Quality quality = measure_quality(timeline.input(), state, 0.3, 0.2);
    REQUIRE(quality.course.count == state.fabric.stitch_count());
    REQUIRE(quality.rows.size() == state.fabric.rows().size());
    REQUIRE((quality.wale.count == 0) == state.fabric.strips().empty());
    REQUIRE(quality.wale.histogram.bins.size() == 40);
    REQUIRE((quality.corner.count == 0) == state.fabric.strips().empty());
    REQUIRE(quality.mirror.has_value() == !state.fabric.strips().empty());
    REQUIRE(std::isfinite(quality.quad_share + quality.regular_share + quality.offset));
    if (state.fabric.strips().size() == 2) {
      ++partial;
      REQUIRE(quality.regular_share > 0.0);
    }
  } while (timeline.forward());
  CHECK(partial > 0);
  CHECK(timeline.state().finished());
}

TEST_CASE("quality: an empty state, and one row", "[quality]") {
  const auto input = make_input({});
  const Quality nothing = measure_quality(*input, State{}, 0.1, 0.1);
  CHECK(nothing.course.count == 0);
  CHECK(nothing.rows.empty());
  CHECK_FALSE(nothing.mirror);
  const Quality one = measure_quality(*input, test_support::tube_state(HandTube{{5}}), 0.1, 0.1);
  CHECK(one.course.count == 5);
  CHECK(one.wale.count == 0);
  CHECK(one.quad_share == 0.0);
  CHECK_FALSE(one.mirror);
}

TEST_CASE("quality: one tube has the figures of the whole, several have their own", "[quality]") {
  State state = test_support::tube_state(HandTube{{12, 12, 14, 14}, 1.0, 0.4, 0.1});
  const Quality whole = measured(state, 0.5, 0.4);
  REQUIRE(whole.tubes.size() == 1);
  CHECK(whole.tubes[0].rounds == 4);
  CHECK(whole.tubes[0].stitches == 52);
  CHECK(whole.tubes[0].longest_wale == whole.wale.high);
  CHECK(whole.tubes[0].wale_cv == Approx(whole.wale.cv));
  CHECK(whole.tubes[0].worst_course_cv_in_row == whole.worst_course_cv_in_row);

  Parameters parameters;
  parameters.rows.source = RowSource::contours;
  give_width(parameters, 0.15);
  Timeline timeline(make_input(test_support::arch()), parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.furthest().finished());
  const Quality arch = measure_quality(timeline.input(), timeline.furthest(), 0.15, 0.108);
  REQUIRE(arch.tubes.size() == 3);
  std::int32_t rounds = 0;
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(arch.tubes[i].tube == static_cast<TubeId>(i));
    CHECK(arch.tubes[i].first_row == rounds + 1);
    CHECK(arch.tubes[i].wales > 0);
    rounds += arch.tubes[i].rounds;
    longest = std::max(longest, arch.tubes[i].longest_wale);
  }
  CHECK(rounds == timeline.furthest().fabric.row_count());
  CHECK(longest == arch.wale.high);
}
