// Where the surface is cut into rows, and how many stitches each cut carries.
#include "knit/rows/contour_rows.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "knit/insight/narrate.h"
#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"
#include "knit/timing/heights.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

namespace {

constexpr double pi = std::numbers::pi;

Parameters sized(double width, double height, TimingKind timing = TimingKind::arc_length) {
  Parameters parameters;
  parameters.rows.source = RowSource::contours;
  parameters.timing.kind = timing;
  give_width(parameters, width);
  give_height(parameters, height);
  return parameters;
}

using Planned = std::variant<CutPlan, Stopped>;

Planned planned(const Mesh& mesh, const Parameters& parameters, double from = 0.0) {
  const auto input = make_input(mesh);
  return plan_cuts(*input, *test_support::timing_of(*input, parameters), parameters.rows, parameters.stitch,
                   from);
}

CutPlan plan_of(const Mesh& mesh, const Parameters& parameters, double from = 0.0) {
  const Planned plan = planned(mesh, parameters, from);
  REQUIRE(std::holds_alternative<CutPlan>(plan));
  return std::get<CutPlan>(plan);
}

// Cuts of these lengths, in stitch widths of 0.5.
constexpr double width = 0.5;
CutPlan plan_with(const std::vector<double>& lengths) {
  CutPlan plan;
  for (const double length : lengths) {
    Ring ring;
    ring.length = width * length;
    Cut cut;
    cut.loops.emplace_back(ring);
    plan.cuts.push_back(cut);
  }
  return plan;
}

ChosenCount chosen(const std::vector<double>& lengths, std::int32_t below = 0, std::int32_t cut = 0) {
  const Parameters parameters = sized(width, 0.0);
  return choose_count(plan_with(lengths), cut, below, parameters.rows, parameters.stitch);
}

bool within_limits(std::int32_t below, std::int32_t count) {
  return count >= 3 && (below == 0 || (count <= 2 * below && 2 * count >= below));
}

// Rows of whole runs over lengths that jump about.
struct Chosen {
  std::int32_t below = 0, rounded = 0;
  ChosenCount count;
};
std::vector<Chosen> random_rows() {
  test_support::Dice dice(17);
  std::vector<Chosen> rows;
  for (int run = 0; run < 200; ++run) {
    std::vector<double> lengths(12);
    for (double& length : lengths) length = std::exp(dice.between(std::log(1.5), std::log(60.0)));
    std::int32_t below = 0;
    for (std::int32_t cut = 0; cut < 12; ++cut) {
      const double rounded = std::max(3.0, std::round(lengths[static_cast<std::size_t>(cut)]));
      rows.push_back({below, static_cast<std::int32_t>(rounded), chosen(lengths, below, cut)});
      below = rows.back().count.count;
    }
  }
  return rows;
}

}  // namespace

TEST_CASE("contour rows: as many cuts as rows fit, at equal steps of time", "[contour-rows]") {
  for (const TimingKind timing : {TimingKind::linear, TimingKind::arc_length}) {
    const CutPlan plan = plan_of(sphere(128, 65, true), sized(0.1, 0.1, timing));
    CHECK(plan.from_time == 0.0);
    CHECK(plan.stitch_height == 0.1);
    CHECK(plan.height == Approx(pi).margin(1e-3));
    CHECK(plan.row_height == Approx(plan.height / 31.0));  // 31.4 fit
    CHECK_FALSE(plan.split);
    REQUIRE(plan.passed_over == 0);
    REQUIRE(plan.cuts.size() == 30);
    for (std::size_t i = 0; i < 30; ++i)
      CHECK(plan.cuts[i].time == Approx(static_cast<double>(i + 1) / 31.0).epsilon(1e-12));
  }
  CHECK(plan_of(sphere(128, 65, true), sized(0.1, 0.0)).stitch_height == Approx(0.072));
  CHECK(plan_of(sphere(128, 65, true), sized(0.1, 0.0)).cuts.size() == 43);
}

TEST_CASE("contour rows: with linear time equal along the axis, with arc-length time along the surface",
          "[contour-rows]") {
  const CutPlan linear = plan_of(sphere(128, 65, true), sized(0.1, 0.1, TimingKind::linear));
  const CutPlan arc = plan_of(sphere(128, 65, true), sized(0.1, 0.1));
  for (std::size_t i = 0; i < 30; ++i) {
    const double share = static_cast<double>(i + 1) / 31.0;
    CHECK(linear.cuts[i].loops[0]->points[0].y == Approx(2.0 * share - 1.0).margin(1e-9));
    for (const glm::dvec3& p : arc.cuts[i].loops[0]->points)
      CHECK(p.y == Approx(-std::cos(pi * share)).margin(2e-3));
  }
  // On any shape: heights of the cuts by the scale of the plain field.
  const Parameters parameters = sized(0.1, 0.06);
  const auto input = make_input(vase(96, 0.05));
  const auto timing = test_support::timing_of(*input, parameters);
  REQUIRE(timing->retimed);
  const CutPlan plan = std::get<CutPlan>(plan_cuts(*input, *timing, parameters.rows, parameters.stitch, 0.0));
  const double base = input->mesh.positions[timing->ends.start].y;
  for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
    const double value = (plan.cuts[i].loops[0]->points[0].y - base) / timing->ends.direction.y;
    const auto row = static_cast<double>(i) + 1.0 + plan.passed_over;
    CHECK(height_at(timing->scale, value) == Approx(row * plan.row_height).margin(1e-9));
  }
}

TEST_CASE("contour rows: planned anew from half way on", "[contour-rows]") {
  for (const TimingKind timing : {TimingKind::linear, TimingKind::arc_length}) {
    const CutPlan plan = plan_of(sphere(128, 65, true), sized(0.1, 0.2, timing), 0.5);
    CHECK(plan.from_time == 0.5);
    CHECK(plan.height == Approx(pi / 2.0).margin(1e-3));
    CHECK(plan.row_height == Approx(plan.height / 8.0));  // 7.85
    REQUIRE(plan.cuts.size() == 7);
    for (std::size_t i = 0; i < 7; ++i)
      CHECK(plan.cuts[i].time == Approx(0.5 + 0.5 * static_cast<double>(i + 1) / 8.0));
  }
  // From where no further row fits there is simply none.
  const CutPlan end = plan_of(sphere(128, 65, true), sized(0.1, 0.2), 0.97);
  CHECK(end.cuts.empty());
  CHECK(end.height == Approx(0.03 * pi).margin(1e-3));
  // But the whole surface has at least one.
  CHECK(plan_of(sphere(128, 65, true), sized(0.1, 50.0)).cuts.size() == 1);
}

TEST_CASE("contour rows: cuts shorter than three half stitches make no row, at both ends", "[contour-rows]") {
  // 63 steps; a cut at angle a is 2 pi sin a long: 0.31, 0.63, 0.94 ... from both ends.
  for (const double w : {0.45, 0.6}) {
    const CutPlan plan = plan_of(sphere(128, 65, true), sized(w, 0.05));
    CHECK(plan.passed_over == 2);
    REQUIRE(plan.cuts.size() == 58);
    CHECK(plan.cuts.front().time == Approx(3.0 / 63.0));
    CHECK(plan.cuts.back().time == Approx(60.0 / 63.0));
    CHECK(plan.cuts.front().loops[0]->length == Approx(0.936).margin(2e-3));
  }
}

TEST_CASE("contour rows: no cut is long enough", "[contour-rows]") {
  const Planned plan = planned(sphere(32, 17), sized(10.0, 0.1));
  REQUIRE(std::holds_alternative<Stopped>(plan));
  const auto& stopped = std::get<Stopped>(plan);
  CHECK(stopped.reason == StopReason::no_row_levels);
  CHECK(stopped.level == 30);
  CHECK(stopped.count == 30);
  CHECK(stopped.vertex == 0);
  CHECK(stopped.value == 10.0);
}

TEST_CASE("contour rows: stitches too fine to be held stop the run before the memory is full",
          "[contour-rows]") {
  const auto stop_of = [](double w, double h) {
    Timeline timeline(test_support::small_sphere(), sized(w, h, TimingKind::linear));
    timeline.extend_to_end();
    REQUIRE(timeline.stop() != nullptr);
    CHECK(narrate(*timeline.stop(), timeline.parameters_of_stop()).ends_with("make them wider or higher."));
    return *knit::get_if<Stopped>(*timeline.stop());
  };
  const Stopped rows = stop_of(0.1, 1e-7);
  CHECK(rows.reason == StopReason::too_fine);
  CHECK(rows.count > most_contour_rows);
  const Stopped stitches = stop_of(1e-7, 0.1);
  CHECK(stitches.reason == StopReason::too_fine);
  CHECK(stitches.value > most_contour_stitches);
  CHECK(stop_of(1e-300, 0.0).reason == StopReason::too_fine);
}

TEST_CASE("contour rows: a tube that parts is planned up to where it does", "[contour-rows]") {
  for (const TimingKind timing : {TimingKind::linear, TimingKind::arc_length}) {
    Parameters parameters = sized(0.1, 0.1, timing);
    parameters.timing.axis.kind = AxisKind::x;
    const Mesh mesh = torus(96, 48, 1.0, 0.4);
    const CutPlan plan = plan_of(mesh, parameters);
    REQUIRE(plan.split);
    CHECK(plan.split->cause == CriticalKind::saddle);
    CHECK(plan.split->loops == 2);
    REQUIRE(plan.split->level == static_cast<std::int32_t>(plan.cuts.size()) - 1);
    CHECK(plan.split->level > 3);
    CHECK(glm::distance(mesh.positions[plan.split->vertex], {-0.6, 0.0, 0.0}) < 1e-9);
    CHECK(plan.split->time < plan.cuts.back().time);
    for (std::size_t i = 0; i + 1 < plan.cuts.size(); ++i) CHECK(plan.cuts[i].loops.size() == 1);
    CHECK(plan.cuts.back().loops.size() == 2);
    CHECK(plan.split->time > plan.cuts[plan.cuts.size() - 2].time);
  }
}

TEST_CASE("contour rows: another end that begins is told apart", "[contour-rows]") {
  Parameters parameters = sized(0.1, 0.05);
  const CutPlan both = plan_of(test_support::arch(), parameters);
  REQUIRE(both.split);
  CHECK(both.split->level == 0);
  CHECK(both.split->cause == CriticalKind::minimum);
  parameters.timing.axis = {AxisKind::custom, {0.3, 1.0, 0.0}};  // one foot is lower
  const CutPlan one = plan_of(test_support::arch(), parameters);
  REQUIRE(one.split);
  CHECK(one.split->level > 1);
  CHECK(one.split->cause == CriticalKind::minimum);
  CHECK(one.split->time > one.cuts.back().time);
  CHECK(test_support::arch().positions[one.split->vertex].y == Approx(0.65).margin(0.08));
}

TEST_CASE("contour rows: a count is the length in stitches, rounded", "[contour-rows]") {
  CHECK(chosen({7.4}).count == 7);
  CHECK(chosen({7.6}).count == 8);
  CHECK(chosen({7.6}).ideal == Approx(7.6));
  CHECK(chosen({7.6}).reason == CountReason::ideal);
  CHECK(chosen({20.2, 22.8, 25.1}, 18).count == 20);
  CHECK(chosen({20.2, 22.8, 25.1}, 20, 1).count == 23);
  CHECK(chosen({20.2, 22.8, 25.1}, 18).reason == CountReason::ideal);
  CHECK(chosen({2.6}).reason == CountReason::ideal);
  CHECK(chosen({2.4}).count == 3);
  CHECK(chosen({2.4}).reason == CountReason::at_least_three);
  CHECK(chosen({1.5}, 5).reason == CountReason::at_least_three);
}

TEST_CASE("contour rows: the cast on may be given, and holds for the first row only", "[contour-rows]") {
  Parameters parameters = sized(width, 0.0);
  parameters.rows.cast_on = 9;
  const ChosenCount first = choose_count(plan_with({20.0, 21.0}), 0, 0, parameters.rows, parameters.stitch);
  CHECK(first.count == 9);
  CHECK(first.reason == CountReason::as_cast_on);
  CHECK(first.ideal == Approx(20.0));
  CHECK(choose_count(plan_with({20.0, 21.0}), 1, 9, parameters.rows, parameters.stitch).count == 18);
  CHECK(choose_count(plan_with({20.0, 21.0}), 1, 11, parameters.rows, parameters.stitch).count == 21);
}

TEST_CASE("contour rows: at most twice and at least half the row below", "[contour-rows]") {
  CHECK(chosen({30.0, 30.0}, 6).count == 12);
  CHECK(chosen({30.0, 30.0}, 6).reason == CountReason::at_most_double);
  CHECK(chosen({6.0, 5.0}, 30).count == 15);
  CHECK(chosen({6.0, 5.0}, 30).reason == CountReason::at_least_half);
  CHECK(chosen({3.0}, 9).count == 5);  // half of an odd row is rounded up
  CHECK(chosen({3.0}, 9).reason == CountReason::at_least_half);
}

TEST_CASE("contour rows: a row makes room for the rows above", "[contour-rows]") {
  // Three stitches would be right here, but then the next row held six instead of nine.
  const ChosenCount room = chosen({3.4, 9.0});
  CHECK(room.count == 4);
  CHECK(room.reason == CountReason::room_ahead);
  // Towards the end, too: eleven would leave six above it, where five are a better fit.
  const ChosenCount falls = chosen({10.6, 4.6}, 12);
  CHECK(falls.count == 10);
  CHECK(falls.reason == CountReason::room_ahead);
}

TEST_CASE("contour rows: over whole runs no row more than doubles or halves", "[contour-rows]") {
  for (const Chosen& c : random_rows()) {
    INFO("row of " << c.count.ideal << " above " << c.below << " holds " << c.count.count);
    CHECK(within_limits(c.below, c.count.count));
    const bool plain = c.count.reason == CountReason::ideal || c.count.reason == CountReason::at_least_three;
    CHECK(plain == (c.count.count == c.rounded));
  }
}

TEST_CASE("contour rows: each reason for a count is so", "[contour-rows]") {
  std::int32_t wrong = 0;
  for (const Chosen& c : random_rows()) {
    const std::int32_t count = c.count.count;
    bool right = true;
    if (c.count.reason == CountReason::at_least_three) right = c.count.ideal < 2.5 && count == 3;
    if (c.count.reason == CountReason::at_most_double) right = count == 2 * c.below && count < c.rounded;
    if (c.count.reason == CountReason::at_least_half) right = 2 * count >= c.below && count > c.rounded;
    if (right) continue;
    if (++wrong > 5) continue;
    UNSCOPED_INFO("row of " << c.count.ideal << " above " << c.below << " holds " << count << ", reason "
                            << static_cast<int>(c.count.reason));
  }
  CHECK(wrong == 0);
}

TEST_CASE("contour rows: so it is on real shapes, whatever the size of a stitch", "[contour-rows]") {
  for (const Mesh& mesh : {sphere(40, 21), vase(40, 0.1), cone(40, 0.1), icosphere(3)}) {
    const auto input = make_input(mesh);
    for (const double w : {0.07, 0.2, 0.45}) {
      for (const double height : {0.3, 1.0, 3.0}) {
        Timeline timeline(input, sized(w, height * w, TimingKind::linear));
        timeline.extend_to_end();
        INFO(mesh.name << " of " << w << " by " << height);
        CHECK(timeline.stop() == nullptr);
        std::int32_t below = 0;
        for (const int count : test_support::row_sizes(timeline.furthest())) {
          CHECK(within_limits(below, count));
          below = count;
        }
      }
    }
  }
}
