// Which pairs of short rows a tube gets: full rounds, arcs, and the stitches that they are placed on.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <numeric>

#include "knit/import/obj.h"
#include "knit/model/ties.h"
#include "knit/rows/contour.h"
#include "knit/short_rows/arcs.h"
#include "knit/short_rows/chart_mirror.h"
#include "knit/short_rows/placing.h"
#include "tests/support/bent_tubes.h"
#include "tests/support/catch.h"
#include "tests/support/hand_chart.h"
#include "tests/support/repeated.h"
#include "tests/support/rough_sphere.h"

using namespace knit;
using namespace test_support;

namespace {

struct Planned {
  TubeChart chart;
  FullRounds rounds;
  ArcSearch search;
  PairPlans plans;
};

// All stitches plain, spread evenly from the middle of the arcs on.
PairPlans place_evenly(const Planned& planned, double width, double beginning) {
  PairPlans plans;
  for (std::int32_t gap = 0; gap < planned.rounds.gaps(); ++gap) {
    std::vector<PairArc> arcs;
    for (const PairArc& arc : planned.search.arcs)
      if (arc.gap == gap) arcs.push_back(arc);
    const Ring ring = ring_at(planned.chart, planned.rounds.levels[static_cast<std::size_t>(gap)], beginning);
    const auto count = static_cast<std::size_t>(std::max(3.0, rounded(ring.length / width)));
    RoundBelow round{
        {}, std::vector<std::uint8_t>(count, 1), planned.chart.columns, planned.chart.mirror.has_value()};
    for (std::size_t i = 0; i < count; ++i) {
      const double arc = ring.length * static_cast<double>(i) / static_cast<double>(count);
      round.columns.push_back(column_of(planned.chart, ring, beginning, arc));
    }
    place_pairs(arcs, round, plans);
  }
  return plans;
}

Planned plan_part(const TubePart& part, double width, double height) {
  const auto chart = make_tube_chart(part, height);
  REQUIRE(std::holds_alternative<TubeChart>(chart));
  Planned planned{std::get<TubeChart>(chart), {}, {}, {}};
  planned.rounds = full_rounds(planned.chart, height);
  planned.search = choose_arcs(planned.chart, planned.rounds, width, {});
  planned.plans = place_evenly(planned, width, middle_of_arcs(planned.search, planned.chart.mirror));
  return planned;
}

Planned plan(const BentTube& tube, double height_of_width = 1.0) {
  const auto input = make_input(tube.mesh);
  const double width = 0.03 * input->bounds.diagonal();
  const auto part = whole_tube(*input, tube.bottom, tube.beginning, width);
  REQUIRE(std::holds_alternative<TubePart>(part));
  return plan_part(std::get<TubePart>(part), width, height_of_width * width);
}

// As worked out apart from this program, at w = 3 % of the diagonal.
void check_counts(const Planned& planned, std::int32_t rounds, std::int32_t pairs) {
  CHECK(planned.rounds.gaps() == rounds);
  CHECK(std::abs(static_cast<std::int32_t>(planned.plans.pairs.size()) - pairs) <= 1);
  CHECK(planned.plans.dropped.empty());
  CHECK(planned.search.arcs.size() == planned.plans.pairs.size());
  CHECK(planned.search.greatest_lag > 1.0);
  CHECK(planned.search.greatest_lag < 2.8);
  CHECK_FALSE(planned.rounds.crowded);
}

bool without_pairs(const BentTube& tube) {
  const Planned planned = plan(tube);
  return planned.search.arcs.empty() && planned.search.greatest_lag < 1.0;
}

RoundBelow round_of(std::int32_t stitches, double begin = 0.0) {
  RoundBelow round{{}, std::vector<std::uint8_t>(static_cast<std::size_t>(stitches), 1), 100};
  for (std::int32_t i = 0; i < stitches; ++i) round.columns.push_back(begin + 100.0 * i / stitches);
  return round;
}

std::vector<std::array<std::int32_t, 2>> spans(const PairPlans& plans) {
  std::vector<std::array<std::int32_t, 2>> result;
  for (const PairPlan& pair : plans.pairs) result.push_back({pair.first, pair.last});
  return result;
}
using Spans = std::vector<std::array<std::int32_t, 2>>;

PairArc arc_of(std::int32_t from, std::int32_t to) { return {0, from, to, 9.0, 5.0, 2.0}; }

}  // namespace

TEST_CASE("short rows: as many rounds and pairs as worked out apart where h is w") {
  check_counts(plan(half_ring()), 15, 14);
  check_counts(plan(heel()), 29, 5);
  check_counts(plan(banana()), 24, 8);
  check_counts(plan(oblique_cone()), 19, 4);
  check_counts(plan(slanted_cylinder()), 19, 4);
}

TEST_CASE("short rows: as many rounds and pairs as worked out apart where h is 0.72 w") {
  check_counts(plan(half_ring(), 0.72), 21, 20);
  check_counts(plan(oblique_cone(), 0.72), 27, 6);
  check_counts(plan(banana(), 0.72), 33, 11);
}

#ifdef KNIT_SHARED_MESHES
TEST_CASE("short rows: the elbow gets as many as worked out apart") {
  const std::filesystem::path path = std::filesystem::path(KNIT_SHARED_MESHES) / "simple-elbow.obj";
  if (!std::filesystem::exists(path)) return;  // not part of the sources
  const auto input = make_input(std::get<Mesh>(read_obj_file(path)));
  const auto& positions = input->mesh.positions;
  const auto farthest = [&](auto coordinate) {
    return *std::max_element(
        positions.begin(), positions.end(),
        [&](const glm::dvec3& a, const glm::dvec3& b) { return coordinate(a) < coordinate(b); });
  };
  const glm::dvec3 start = farthest([](const glm::dvec3&p) { return p.y; }),
                   end = farthest([](const glm::dvec3&p) { return p.z; });
  // Circles of 0.3 about its poles.
  std::vector<double> field;
  for (const glm::dvec3& p : positions) {
    const double from = glm::distance(p, start), to = glm::distance(p, end);
    field.push_back(from < 1.0 ? from : to < 1.0 ? 10.0 - to : 5.0);
  }
  const RowFrame frame = row_frame({0, -1, 0}, std::nullopt);
  const std::vector<double> values{0.3, 9.7};
  const std::vector<Cut> cuts = cut_surface(*input, field, values, values, frame);
  const double width = 0.178;
  const auto part = cut_tube(*input, field, {0.3, &*cuts[0].loops[0]}, {9.7, &*cuts[1].loops[0]}, width);
  REQUIRE(std::holds_alternative<TubePart>(part));
  check_counts(plan_part(std::get<TubePart>(part), width, width), 26, 9);
  check_counts(plan_part(std::get<TubePart>(part), width, 0.72 * width), 35, 13);
}
#endif

TEST_CASE("short rows: shapes that are level all round get none") {
  CHECK(without_pairs(slanted_cylinder(0.0)));
  CHECK(without_pairs(
      turned_tube("hat", [](double up) { return glm::dvec2(up < 0.5 ? 1.0 : 1.8 - 1.6 * up, 3.0 * up); })));
  CHECK(without_pairs(turned_tube("cut sphere", [](double up) {
    const double t = std::numbers::pi * (0.2 + 0.77 * up);
    return glm::dvec2(std::sin(t), -std::cos(t));
  })));
}

TEST_CASE("short rows: a mirrored shape has the mirrored arcs and stitches") {
  const auto two_bends = [] {
    return ringed_tube("two bends", {64, 120}, [](double up, double turn) {
      const double t = 2.0 * std::numbers::pi * turn,
                   first = std::numbers::pi / 2.0 * std::min(1.0, 2.0 * up),
                   second = std::numbers::pi / 2.0 * std::max(0.0, 2.0 * up - 1.0);
      const glm::dvec3 ahead = std::cos(second) * glm::dvec3(std::sin(first), std::cos(first), 0.0) +
                               std::sin(second) * glm::dvec3(0, 0, 1);
      const glm::dvec3 out(-std::cos(first), std::sin(first), 0.0), side = glm::cross(ahead, out);
      const glm::dvec3 middle(2.0 - 2.0 * std::cos(first) + 2.0 * std::sin(second), 2.0 * std::sin(first),
                              2.0 - 2.0 * std::cos(second));
      return middle + 0.9 * (std::cos(t) * out + std::sin(t) * side);
    });
  };
  for (const BentTube& tube : {half_ring({64, 110}), two_bends()}) {
    const Planned one = plan(tube), other = plan(mirrored(tube));
    REQUIRE(one.search.arcs.size() > 5);
    REQUIRE(one.search.arcs.size() == other.search.arcs.size());
    for (std::size_t i = 0; i < one.search.arcs.size(); ++i) {
      const PairArc &a = one.search.arcs[i], &b = other.search.arcs[i];
      CHECK(a.gap == b.gap);
      CHECK(a.to - a.from == b.to - b.from);
      CHECK((a.from + b.to) % 256 == 0);
      CHECK(a.gain == Approx(b.gain));
    }
    CHECK(middle_of_arcs(one.search) == Approx(-middle_of_arcs(other.search)).margin(1e-6));
    // Stitch 0 is where the mirror is.
    const auto sorted = [](const PairPlans& plans, bool back) {
      std::vector<std::array<std::int32_t, 3>> result;
      for (const PairPlan& pair : plans.pairs) {
        if (pair.over_beginning())
          result.push_back({pair.gap, back ? -pair.last : pair.first, back ? -pair.first : pair.last});
      }
      std::sort(result.begin(), result.end());
      return result;
    };
    CHECK(sorted(one.plans, false) == sorted(other.plans, true));
    CHECK(sorted(one.plans, false).size() > 5);
    CHECK(one.plans.pairs.size() == other.plans.pairs.size());
  }
}

TEST_CASE("short rows: whether a tube is its own mirror image is told by its chart") {
  for (const BentTube& tube : {half_ring(), heel(), oblique_cone(), slanted_cylinder()}) {
    const Planned planned = plan(tube);
    CAPTURE(tube.name);
    REQUIRE(planned.chart.mirror);
    const std::int32_t mirror = *planned.chart.mirror;
    CHECK(std::min(mirror, 256 - mirror) <= 3);  // turn 0 is on it
    for (const PairArc& arc : planned.search.arcs) CHECK((arc.from + arc.to - mirror) % 256 == 0);
    for (const PairPlan& pair : planned.plans.pairs)
      if (pair.over_beginning()) CHECK(pair.first + pair.last == 0);
  }
  CHECK_FALSE(plan(lopsided_cylinder()).chart.mirror);
}

TEST_CASE("short rows: the mirror goes through where a tube is highest") {
  std::vector<double> ends, uneven;
  for (int j = 0; j < 40; ++j) {
    ends.push_back(14.0 - 4.0 * std::cos(2.0 * std::numbers::pi * (j - 3.5) / 40.0));
    uneven.push_back(ends.back() + (j > 4 && j < 12 ? 2.0 : 0.0));
  }
  CHECK(mirror_of(hand_chart(ends, 113), 1.0) == 7);
  CHECK_FALSE(mirror_of(hand_chart(uneven, 113), 1.0));
}

TEST_CASE("short rows: an arc beside the mirror comes with its image") {
  // Two far sides, to the left and right of column 0; one a hair farther.
  std::vector<double> ends;
  for (int j = 0; j < 96; ++j) {
    const auto bump = [&](double at) { return std::exp(-(j - at) * (j - at) / 60.0); };
    ends.push_back(10.0 + 4.0 * bump(20.0) + 4.001 * bump(76.0));
  }
  TubeChart chart = hand_chart(ends, 81);
  const FullRounds rounds = full_rounds(chart, 1.0);
  chart.mirror = mirror_of(chart, 1.0);
  REQUIRE(chart.mirror == 0);
  const std::vector<PairArc> arcs = choose_arcs(chart, rounds, 1.0, {}).arcs;
  REQUIRE(arcs.size() >= 4);
  REQUIRE(arcs.size() % 2 == 0);
  for (std::size_t i = 0; i < arcs.size(); i += 2) {
    CHECK(arcs[i].gap == arcs[i + 1].gap);
    CHECK((arcs[i].from + arcs[i + 1].to) % 96 == 0);
    CHECK((arcs[i].to + arcs[i + 1].from) % 96 == 0);
    CHECK(arcs[i].gain == arcs[i + 1].gain);
    CHECK(arcs[i].gain > arcs[i].price);
  }
  // Dear turns: no half of it either.
  for (const double cost : {6.0, 8.0, 10.0, 12.0})
    CHECK(choose_arcs(chart, rounds, 1.0, {cost, 4.0, 4}).arcs.size() % 2 == 0);
}

TEST_CASE("short rows: rounds that begin on the mirror get as many stitches on both sides of it") {
  RoundBelow round = round_of(20);
  for (std::size_t i = 1; i < 20; ++i) round.columns[i] += 0.01;
  round.mirrored = true;
  PairPlans plans;
  place_pairs(std::vector{arc_of(75, 125), arc_of(30, 70)}, round, plans);
  CHECK(spans(plans) == Spans{{-5, 5}, {6, 14}});
  round.mirrored = false;
  plans = {};
  place_pairs(std::vector{arc_of(75, 125)}, round, plans);
  CHECK(spans(plans) == Spans{{-5, 4}});
  // What is in the way of one turn moves both.
  round.mirrored = true;
  round.plain[6] = 0;
  plans = {};
  place_pairs(std::vector{arc_of(75, 125)}, round, plans);
  REQUIRE(plans.pairs.size() == 1);
  CHECK(plans.pairs[0].first + plans.pairs[0].last == 0);
}

TEST_CASE("short rows: of arcs as good the one about the beginning is taken") {
  // Two far sides as far: one about column 0, one opposite.
  std::vector<double> ends;
  for (int j = 0; j < 48; ++j)
    ends.push_back(10.0 + 2.0 * (1.0 + std::cos(4.0 * std::numbers::pi * j / 48.0)));
  const TubeChart chart = hand_chart(ends, 81);
  const FullRounds rounds = full_rounds(chart, 1.0);
  const ArcSearch search = choose_arcs(chart, rounds, 1.0, {});
  REQUIRE(search.arcs.size() >= 2);
  CHECK((search.arcs[0].from + search.arcs[0].to) % 96 == 0);
  CHECK((search.arcs[1].from + search.arcs[1].to) % 96 == 48);
  CHECK(search.arcs[0].to - search.arcs[0].from == search.arcs[1].to - search.arcs[1].from);
}

TEST_CASE("short rows: the first arc is the best of all by trying all") {
  Dice dice(4);
  for (int round = 0; round < repeated(20); ++round) {
    std::vector<double> ends(24, 0.0);
    for (double& end : ends) end = dice.between(8.0, 13.0);
    const TubeChart chart = hand_chart(ends, 65);
    const FullRounds rounds = full_rounds(chart, 1.0);
    const PairSettings settings{0.5, 4.0, 4};
    const ArcSearch search = choose_arcs(chart, rounds, 1.0, settings);
    REQUIRE_FALSE(search.arcs.empty());
    const PairArc& taken = search.arcs[0];
    const std::vector<double> heights =
        heights_at(chart, rounds.levels[static_cast<std::size_t>(taken.gap) + 1]);
    const auto lag = [&](std::size_t j) {
      return 0.5 * (heights[j % 24] + heights[(j + 1) % 24]) - (taken.gap + 1) * rounds.spacing;
    };
    double best = -1e9;
    for (std::size_t from = 0; from < 24; ++from) {
      for (std::size_t stitches = 4; stitches <= 21; ++stitches) {
        double gain = 0.0;
        for (std::size_t j = from; j < from + stitches; ++j)
          gain += (lag(j) * lag(j) - (lag(j) - 2.0) * (lag(j) - 2.0)) / 4.0;
        best = std::max(best, gain);
      }
    }
    CHECK(taken.gain == Approx(best));
    CHECK(taken.price == 0.5);
    CHECK(taken.gain > taken.price);
  }
}

TEST_CASE("short rows: turns cost more near turns of this gap and the four before") {
  std::vector<double> ends;
  for (int j = 0; j < 40; ++j)
    ends.push_back(14.0 - 4.0 * std::cos(2.0 * std::numbers::pi * (j + 0.3) / 40.0));
  const TubeChart chart = hand_chart(ends, 113);
  const std::vector<PairArc> arcs = choose_arcs(chart, full_rounds(chart, 1.0), 1.0, {3.0, 2.5, 4}).arcs;
  REQUIRE(arcs.size() >= 3);
  double greatest = 0.0;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    double price = 3.0;
    for (std::size_t before = 0; before < i; ++before) {
      const double share = 1.0 - (arcs[i].gap - arcs[before].gap) / 5.0;
      for (const std::int32_t turn : {arcs[i].from, arcs[i].to}) {
        for (const std::int32_t other : {arcs[before].from, arcs[before].to}) {
          const double way = std::abs(turn - other) % 40, apart = std::min(way, 40.0 - way) / 2.5;
          if (share > 0.0) price += 2.0 * share * std::exp(-apart * apart);
        }
      }
    }
    CHECK(arcs[i].price == Approx(price));
    greatest = std::max(greatest, price);
  }
  CHECK(greatest > 3.1);
}

TEST_CASE("short rows: turns of gaps beside each other stand apart") {
  const std::vector<PairArc> arcs = plan(half_ring()).search.arcs;
  for (std::size_t i = 1; i < arcs.size(); ++i) {
    for (const std::int32_t turn : {arcs[i].from, arcs[i].to}) {
      for (const std::int32_t before : {arcs[i - 1].from, arcs[i - 1].to}) {
        const std::int32_t way = std::abs(turn - before) % 256;
        CHECK(std::min(way, 256 - way) >= 8);
      }
    }
  }
}

TEST_CASE("short rows: a pair that costs more is worked less often, and one that is dear never") {
  const auto input = make_input(slanted_cylinder(0.8, {48, 80}).mesh);
  const BentTube tube = slanted_cylinder(0.8, {48, 80});
  const double width = 0.03 * input->bounds.diagonal();
  const auto part = std::get<TubePart>(whole_tube(*input, tube.bottom, tube.beginning, width));
  const auto chart = std::get<TubeChart>(make_tube_chart(part, width));
  const FullRounds rounds = full_rounds(chart, width);
  std::size_t before = 1000;
  for (const double cost : {0.0, 5.0, 20.0, 1000.0}) {
    const std::size_t pairs = choose_arcs(chart, rounds, width, {cost, 4.0, 4}).arcs.size();
    CHECK(pairs <= before);
    before = pairs;
  }
  CHECK(before == 0);
  CHECK(choose_arcs(chart, rounds, width, {0.0, 4.0, 4}).arcs.size() >
        choose_arcs(chart, rounds, width, {5.0, 4.0, 4}).arcs.size());
  // No short row is shorter than a person allows.
  for (const PairArc& arc : choose_arcs(chart, rounds, width, {0.0, 4.0, 12}).arcs) {
    double stitches = 0.0;
    const auto gap = static_cast<std::size_t>(arc.gap);
    const double level = 0.5 * (rounds.levels[gap] + rounds.levels[gap + 1]);
    for (std::int32_t c = arc.from; c < arc.to; ++c)
      stitches += glm::distance(point_at(chart, level, c), point_at(chart, level, c + 1)) / width;
    CHECK(stitches >= 12.0 - 1e-6);
  }
}

TEST_CASE("short rows: small steps come to the same and tell what they did") {
  const BentTube tube = slanted_cylinder(0.8, {48, 80});
  const Planned planned = plan(tube);
  const double width = 0.03 * make_input(tube.mesh)->bounds.diagonal();
  ArcSearch search;
  std::int32_t measured = 0, taken = 0, refused = 0;
  while (!search.done) {
    const ArcStep step = advance_arcs(planned.chart, planned.rounds, width, {}, search);
    if (const auto* lag = std::get_if<LagMeasured>(&step)) {
      CHECK(lag->gap == measured);
      CHECK(lag->greatest >= lag->least);
      ++measured;
    } else {
      const auto& considered = std::get<ArcConsidered>(step);
      CHECK(considered.taken == (considered.gain > considered.price));
      ++(considered.taken ? taken : refused);
    }
  }
  CHECK(search == planned.search);
  CHECK(measured == planned.rounds.gaps());
  CHECK(refused == measured);
  CHECK(taken == static_cast<std::int32_t>(search.arcs.size()));
}

TEST_CASE("short rows: full rounds are a stitch apart where the tube is nearest and end on the rim") {
  const Planned planned = plan(half_ring());
  const FullRounds& rounds = planned.rounds;
  CHECK(rounds.levels.front() == 0.0);
  CHECK(rounds.levels.back() == planned.chart.last_level());
  CHECK(rounds.spacing / rounds.wanted > 0.95);
  CHECK(rounds.spacing / rounds.wanted < 1.05);
  for (std::size_t k = 0; k + 1 < rounds.levels.size(); ++k) {
    std::vector<double> low = heights_at(planned.chart, rounds.levels[k]),
                        high = heights_at(planned.chart, rounds.levels[k + 1]);
    std::size_t nearer = 0;
    for (std::size_t j = 0; j < low.size(); ++j)
      if (high[j] - low[j] < rounds.spacing * (1.0 - 1e-6)) ++nearer;
    CHECK(nearer <= 8);
    CHECK(nearer >= 7);
  }
}

TEST_CASE("short rows: a near side too low for a round is said") {
  std::vector<double> ends(24, 6.0);
  for (std::size_t j = 0; j < 6; ++j) ends[j] = 0.5;
  CHECK(full_rounds(hand_chart(ends, 65), 1.0).crowded);
  CHECK_FALSE(full_rounds(hand_chart(std::vector<double>(24, 6.0), 65), 1.0).crowded);
}

TEST_CASE("short rows: rounds begin in the middle of what the pairs cover") {
  ArcSearch search;
  search.covered.assign(100, 0);
  CHECK(middle_of_arcs(search) == 0.0);
  for (std::size_t c = 90; c < 110; ++c) search.covered[c % 100] = 1;
  CHECK(middle_of_arcs(search) == Approx(0.0).margin(1e-9));
  std::fill(search.covered.begin(), search.covered.end(), 0);
  for (std::size_t c = 10; c < 30; ++c) search.covered[c] = 2;
  CHECK(middle_of_arcs(search) == Approx(20.0));
  std::fill(search.covered.begin(), search.covered.end(), 0);
  for (std::size_t c = 70; c < 90; ++c) search.covered[c] = 2;
  CHECK(middle_of_arcs(search) == Approx(-20.0));
}

TEST_CASE("short rows: arcs go onto the stitches that stand in them") {
  PairPlans plans;
  place_pairs(std::vector{arc_of(19, 51)}, round_of(10), plans);
  CHECK(spans(plans) == Spans{{2, 5}});
  plans = {};
  place_pairs(std::vector{arc_of(20, 50)}, round_of(10), plans);
  CHECK(spans(plans) == Spans{{2, 5}});
  plans = {};
  place_pairs(std::vector{arc_of(75, 132)}, round_of(10), plans);
  CHECK(spans(plans) == Spans{{-2, 3}});
  // Where the round begins elsewhere.
  plans = {};
  place_pairs(std::vector{arc_of(25, 82)}, round_of(10, 50.0), plans);
  CHECK(spans(plans) == Spans{{-2, 3}});
  CHECK(plans.pairs[0].over_beginning());
  CHECK(plans.pairs[0].stitches() == 6);
  CHECK(plans.pairs[0].moved == 0);
  plans = {};
  place_pairs(std::vector{arc_of(25, 82)}, round_of(10, -50.0), plans);
  CHECK(spans(plans) == Spans{{-2, 3}});
  // Inside the round it stays off stitch 0 by as much on both sides.
  plans = {};
  place_pairs(std::vector{arc_of(10, 40), arc_of(60, 90)}, round_of(10), plans);
  CHECK(spans(plans) == Spans{{2, 4}, {6, 8}});
  // Beside the beginning of the round it goes over it.
  plans = {};
  place_pairs(std::vector{arc_of(0, 40)}, round_of(10), plans);
  CHECK(spans(plans) == Spans{{-1, 4}});
  plans = {};
  place_pairs(std::vector{arc_of(60, 100)}, round_of(10), plans);
  CHECK(spans(plans) == Spans{{-4, 1}});
}

TEST_CASE("short rows: turns move off shaped stitches and a pair that cannot is dropped with a reason") {
  RoundBelow round = round_of(20);
  round.plain[4] = 0;  // the first stitch's left neighbour
  PairPlans plans;
  place_pairs(std::vector{arc_of(24, 56)}, round, plans);
  REQUIRE(spans(plans) == Spans{{6, 11}});
  CHECK(plans.pairs[0].moved == 1);
  // Wider comes before narrower.
  round = round_of(20);
  round.plain[5] = 0;
  plans = {};
  place_pairs(std::vector{arc_of(24, 56)}, round, plans);
  CHECK(spans(plans) == Spans{{4, 11}});
  // No plain stitch near the first turn.
  for (std::size_t i = 0; i < 9; ++i) round.plain[i] = 0;
  plans = {};
  place_pairs(std::vector{arc_of(24, 56)}, round, plans);
  CHECK(plans.pairs.empty());
  REQUIRE(plans.dropped.size() == 1);
  CHECK(plans.dropped[0].reason == DropReason::no_plain_stitch);
  CHECK(sentence_of(plans.dropped[0], 12) ==
        "Row 12: a short row over 7 stitches was left out: no plain stitch to turn at within 3 stitches.");
  plans = {};
  place_pairs(std::vector{arc_of(24, 31), arc_of(2, 99)}, round_of(20), plans);
  REQUIRE(plans.dropped.size() == 2);
  CHECK(plans.dropped[0].reason == DropReason::too_few);
  CHECK(plans.dropped[1].reason == DropReason::too_many);
}

TEST_CASE("short rows: a mirrored round gets the mirrored places") {
  Dice dice(7);
  for (int run = 0; run < repeated(300); ++run) {
    const auto count = static_cast<std::int32_t>(14 + dice.below(20));
    RoundBelow round = round_of(count), other = round;
    for (std::int32_t i = 0; i < count; ++i) {
      const std::uint8_t plain = dice.below(5) == 0 ? 0 : 1;
      round.plain[static_cast<std::size_t>(i)] = plain;
      other.plain[static_cast<std::size_t>((count - i) % count)] = plain;
    }
    const auto half = static_cast<std::int32_t>(12 + dice.below(24));
    const auto off = static_cast<std::int32_t>(dice.below(5));
    PairPlans one, two;
    place_pairs(std::vector{arc_of(100 - half - off, 100 + half)}, round, one);
    place_pairs(std::vector{arc_of(100 - half, 100 + half + off)}, other, two);
    REQUIRE(one.pairs.size() == two.pairs.size());
    for (std::size_t i = 0; i < one.pairs.size(); ++i) {
      CHECK((one.pairs[i].first + two.pairs[i].last) % count == 0);
      CHECK(one.pairs[i].stitches() == two.pairs[i].stitches());
    }
  }
}

TEST_CASE("short rows: pairs of a gap stand in the order in which they are worked") {
  PairPlans plans;
  place_pairs(std::vector{arc_of(40, 62), arc_of(70, 125), arc_of(20, 45), arc_of(85, 115)}, round_of(40),
              plans);
  CHECK(spans(plans) == Spans{{-6, 6}, {-12, 10}, {8, 18}, {16, 24}});
}
