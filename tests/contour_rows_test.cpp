// Where the surface is cut into rows, and how many stitches each cut carries.
#include "knit/rows/contour_rows.h"

#include <cmath>
#include <span>

#include "knit/insight/narrate.h"
#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

namespace {

// Lengths in stitch widths of 0.5.
constexpr double width = 0.5;

ChosenCount chosen(std::vector<double> lengths, std::int32_t below = 0, std::size_t row = 0,
                   std::int32_t cast_on = 0) {
  for (double& length : lengths) length *= width;
  return choose_count(lengths, row, below, width, cast_on);
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
      rows.push_back(
          {below, static_cast<std::int32_t>(rounded), chosen(lengths, below, static_cast<std::size_t>(cut))});
      below = rows.back().count.count;
    }
  }
  return rows;
}

}  // namespace

TEST_CASE("contour rows: stitches too fine to be held stop the run before the memory is full",
          "[contour-rows]") {
  const auto stop_of = [](double w, double h) {
    Parameters parameters;
    parameters.rows.source = RowSource::contours;
    give_width(parameters, w);
    give_height(parameters, h);
    Timeline timeline(test_support::small_sphere(), parameters);
    timeline.extend_to_end();
    REQUIRE(timeline.stop() != nullptr);
    CHECK(narrate(*timeline.stop(), timeline.parameters_of_stop()).ends_with("make them wider or higher."));
    return *knit::get_if<Stopped>(*timeline.stop());
  };
  const Stopped rows = stop_of(0.1, 1e-7);
  CHECK(rows.reason == StopReason::too_fine);
  CHECK(rows.count > rows.other);
  const Stopped stitches = stop_of(1e-7, 0.1);
  CHECK(stitches.reason == StopReason::too_fine);
  CHECK(stitches.value > stitches.other);
  CHECK(stop_of(1e-300, 0.0).reason == StopReason::too_fine);
}

TEST_CASE("contour rows: a shape of one round is no tube", "[contour-rows]") {
  Parameters parameters;
  parameters.rows.source = RowSource::contours;
  give_width(parameters, 10.0);
  Timeline timeline(test_support::small_sphere(), parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.stop() != nullptr);
  CHECK(knit::get_if<Stopped>(*timeline.stop())->reason == StopReason::no_row_levels);
  CHECK(narrate(*timeline.stop(), timeline.parameters_of_stop()).ends_with("make them narrower than 10."));
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
  const ChosenCount first = chosen({20.0, 21.0}, 0, 0, 9);
  CHECK(first.count == 9);
  CHECK(first.reason == CountReason::as_cast_on);
  CHECK(first.ideal == Approx(20.0));
  CHECK(chosen({20.0, 21.0}, 9, 1).count == 18);
  CHECK(chosen({20.0, 21.0}, 11, 1).count == 21);
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
    const bool plain = c.count.reason == CountReason::ideal ||
                       c.count.reason == CountReason::at_least_three || c.count.reason == CountReason::undone;
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
    if (c.count.reason == CountReason::undone) right = count != c.below && c.below > 0;
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
      for (const double height : {0.3, 1.0, 1.8}) {
        Parameters parameters;
        parameters.rows.source = RowSource::contours;
        give_width(parameters, w);
        give_height(parameters, height * w);
        Timeline timeline(input, parameters);
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
