// Front and back halves shaped apart in one rhythm: what it costs in shape, what it keeps to, and how exact the beam is.
#include "knit/rhythm/joint_plan.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "knit/rhythm/joint_search.h"
#include "knit/rhythm/rhythm_plan.h"
#include "knit/stitches/repeats.h"
#include "tests/support/belly.h"
#include "tests/support/catch.h"

using namespace knit;
using namespace test_support;

namespace {

double widest(const std::vector<double>& ideals) { return *std::max_element(ideals.begin(), ideals.end()); }

std::vector<double> whole_of(const HalfIdeals& ideals) {
  std::vector<double> whole = ideals.front;
  for (std::size_t row = 0; row < whole.size(); ++row) whole[row] += ideals.back[row];
  return whole;
}

JointTask task_of(const HalfIdeals& ideals, double dial, std::size_t beam, const std::vector<double>& whole) {
  JointTask task{ideals.front, ideals.back, rhythm_prices({4, false, true}, dial, whole)};
  task.beam = beam;
  return task;
}

}  // namespace

TEST_CASE(
    "front and back are not shaped apart where that is off, or the changes or another style are asked for") {
  const HalfIdeals ideals = belly_ideals();
  RhythmSettings settings{CountPlanning::rhythm};
  CHECK(wants_joint_plan(ideals, settings));
  settings.halves = RhythmHalves::off;
  CHECK_FALSE(wants_joint_plan(ideals, settings));
  settings = {CountPlanning::rhythm, RhythmStyle::lines};
  CHECK_FALSE(wants_joint_plan(ideals, settings));
}

TEST_CASE("a limb of less than 24 stitches is not shaped apart, however its halves differ") {
  const RhythmSettings settings{CountPlanning::rhythm};
  CHECK_FALSE(wants_joint_plan({{12.0, 16.0, 12.0}, {6.0, 7.0, 6.0}}, settings));
  CHECK(wants_joint_plan({{12.0, 17.0, 12.0}, {6.0, 8.0, 6.0}}, settings));
}

TEST_CASE("a body with a belly is shaped apart in front and back and both halves come out") {
  const HalfIdeals ideals = belly_ideals();
  CHECK(ideals.front.size() == 50);
  CHECK(std::abs(widest(ideals.front) - 39.2) < 0.1);
  CHECK(std::abs(widest(ideals.back) - 13.6) < 0.1);
  const RhythmSettings settings{CountPlanning::rhythm};
  REQUIRE(wants_joint_plan(ideals, settings));
  const auto plan = plan_joint(ideals, settings);
  REQUIRE(plan);
  CHECK(plan->front_off < 3.5);
  CHECK(plan->back_off < 7.5);  // one stitch of 13.6
  CHECK(plan->seen.worst() < 4.4);
  CHECK(std::count(plan->roles.begin(), plan->roles.end(), RowRole::change) <= 30);
  std::set<std::pair<std::int32_t, std::int32_t>> ways;
  for (const RhythmSegment& segment : plan->segments) {
    if (segment.change != 0) ways.insert({segment.change, segment.front});
    CHECK(segment.front * (segment.change - segment.front) >= 0);  // never one up, the other down
  }
  CHECK(ways.size() <= most_ways_to_shape);
  for (std::size_t row = 0; row < plan->counts.size(); ++row) {
    CHECK(plan->fronts[row] % 2 == 0);
    CHECK((plan->counts[row] - plan->fronts[row]) % 2 == 0);
    CHECK(plan->counts[row] > plan->fronts[row]);
  }
  // Equal sections would be far off: half of every row in front.
  CHECK(widest(ideals.back) < 0.65 * widest(whole_of(ideals)) / 2.0);
}

TEST_CASE("what is round or hardly otherwise or is shaped in another style has no halves of its own") {
  const RhythmSettings settings{CountPlanning::rhythm};
  CHECK_FALSE(wants_joint_plan(belly_ideals(12.0, 0.0), settings));
  HalfIdeals nearly{{30.0, 33.0}, {30.0, 27.0}};
  CHECK_FALSE(wants_joint_plan(nearly, settings));
  nearly.front.back() = 33.1;
  CHECK(wants_joint_plan(nearly, settings));
  RhythmSettings other = settings;
  other.style = RhythmStyle::lines;
  CHECK_FALSE(wants_joint_plan(nearly, other));
  other = settings;
  other.changes = 8;
  CHECK_FALSE(wants_joint_plan(nearly, other));
}

TEST_CASE("the beam finds what the whole search finds") {
  for (const double size : {3.0, 4.0, 6.0, 8.0}) {
    for (const double dial : {1.0, 0.2}) {
      const HalfIdeals ideals = belly_ideals(size);
      const std::vector<double> whole = whole_of(ideals);
      const auto exact = find_joint_segments(task_of(ideals, dial, 0, whole));
      const auto beam = find_joint_segments(task_of(ideals, dial, joint_beam, whole));
      REQUIRE(exact);
      REQUIRE(beam);
      CHECK(beam->cost <= exact->cost * (1.0 + 1e-9));
      CHECK(beam->segments == exact->segments);
      const auto narrow = find_joint_segments(task_of(ideals, dial, 4, whole));
      REQUIRE(narrow);
      CHECK(narrow->cost >= exact->cost * (1.0 - 1e-9));
    }
  }
}

TEST_CASE("a joint plan goes on from the halves that are there, and not from an odd count") {
  const HalfIdeals ideals = belly_ideals(6.0);
  const RhythmSettings settings{CountPlanning::rhythm};
  const auto plan = plan_joint(ideals, settings, {6, 20, SegmentEnd::changed, 0}, 14);
  REQUIRE(plan);
  CHECK(plan->counts.front() == 20);
  CHECK(plan->fronts.front() == 14);
  CHECK(plan->counts.size() == ideals.front.size() - 6);
  CHECK_FALSE(plan_joint(ideals, settings, {6, 21, SegmentEnd::changed, 0}, 0));
}

TEST_CASE("halves that are shaped apart change beside mains and mirror each other") {
  // Quarters of 5 and 4 stitches before the round: back, side, front, side.
  for (const auto& [front_above, above] : {std::pair{10, 20}, std::pair{12, 22}, std::pair{6, 16},
                                           std::pair{4, 12}, std::pair{8, 20}, std::pair{10, 20}}) {
    RepeatedRound round{18, above};
    round.front_below = 8;
    round.front_above = front_above;
    CAPTURE(front_above, above);
    const Join join = plan_repeats(round);
    CHECK(static_cast<std::int32_t>(join.labels.size()) == std::max(18, above));
    const auto is_shaping = [](Label label) { return label != Label::knit && label != Label::main; };
    CHECK(std::count_if(join.labels.begin(), join.labels.end(), is_shaping) == std::abs(above - 18));
    REQUIRE(join.mains.size() == 4);
    const std::int32_t back = (above - front_above) / 2;
    CHECK(join.mains == std::vector<std::int32_t>{0, back, above / 2, above - back});
    std::vector<int> hung(static_cast<std::size_t>(std::min(18, above)));
    for (const std::int32_t link : join.link) ++hung.at(static_cast<std::size_t>(link));
    for (const int on_it : hung) CHECK((on_it == 1 || on_it == 2));
  }
}
