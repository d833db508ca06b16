// The ranking of problems: the same ones as is_unusual finds, worst first.
#include "knit/insight/problems.h"

#include <algorithm>
#include <array>

#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

namespace {

Parameters contours() {
  Parameters parameters;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  return parameters;
}

Coverage half_covered() {
  Coverage coverage;
  coverage.uncovered = {
      0.22, {{12, {}, 0.18, UncoveredKind::flat, 0.0}, {30, {}, 0.04, UncoveredKind::limb, 0.05}}};
  coverage.stretched = {
      {0, 4, 4, 1.6, 0.02, {4, 1}}, {1, 12, 15, 2.34, 0.1, {13, 7}}, {1, 20, 20, 9.0, 0.1, {20, 0}}};
  coverage.tubes = 2;
  return coverage;
}

}  // namespace

TEST_CASE("problems are exactly the unusual steps", "[problems]") {
  for (const double epsilon : {0.001, 0.01, 0.15}) {
    Parameters parameters = test_support::small_parameters();
    give_epsilon(parameters, epsilon);
    Timeline timeline(test_support::small_sphere(), parameters);
    timeline.extend_to_end();
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < timeline.known(); ++i) {
      const Parameters& in_force = timeline.parameters_of_step(i);
      const auto problem = problem_of(timeline.step(i), i, in_force);
      wrong += problem.has_value() == is_unusual(timeline.step(i), in_force) ? 0U : 1U;
      if (problem) wrong += problem->step == i ? 0U : 1U;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("problems are counted by kinds, as the list ranks them, and said with their number", "[problems]") {
  Parameters parameters = test_support::small_parameters();
  give_epsilon(parameters, 0.001);
  Timeline timeline(test_support::small_sphere(), parameters);
  timeline.extend_to_end();
  ProblemCounts counts;
  std::array<std::size_t, problem_kinds> ranked{};
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    counts.take(timeline.step(i), timeline.parameters_of_step(i));
    const auto problem = problem_of(timeline.step(i), i, timeline.parameters_of_step(i));
    if (problem) ++ranked.at(static_cast<std::size_t>(problem->kind));
  }
  REQUIRE(counts.of(ProblemKind::band_missed) > 1);
  std::size_t total = 0;
  for (std::size_t i = 0; i < problem_kinds; ++i) {
    CHECK(counts.of(static_cast<ProblemKind>(i)) == ranked.at(i));
    total += ranked.at(i);
  }
  CHECK(counts.total() == total);
  const Place place{Stage::rows, 5, 7};
  ProblemCounts few;
  CHECK(words_of(few).empty());
  few.take({place, RowResampled{24, 12, 6, ResampleReason::more_than_double, 1.0}}, parameters);
  few.take({place, BandMissed{1, 2, 3, 4, 0.9, -1.0}}, parameters);
  few.take({place, Stopped{StopReason::stall, {}, 1, 2, 0, 3, 0.5, 0.5}}, parameters);
  CHECK(words_of(few) == "1 row resampled, 2 stalls");
  few.take({place, Stopped{StopReason::splits, {}, 1, 2, 0, 3, 0.5, 0.5}}, parameters);
  CHECK(words_of(few) == "1 stop, 1 row resampled, 2 stalls");
}

TEST_CASE("each kind of problem is told and measured", "[problems]") {
  Parameters parameters = test_support::small_parameters();  // width 0.3, epsilon 0.15
  const Place place{Stage::rows, 5, 7};
  const auto of = [&](const Event& what) { return problem_of({place, what}, 3, parameters).value(); };
  CHECK(of(RowResampled{24, 12, 6, ResampleReason::more_than_double, 1.0}) ==
        Problem{3, ProblemKind::row_resampled, 2.0});
  CHECK(of(BandMissed{1, 2, 3, 4, 0.9, -1.0}).kind == ProblemKind::band_missed);
  CHECK(of(BandMissed{1, 2, 3, 4, 0.9, -1.0}).size == Approx(2.0));
  CHECK(of(GapShared{8, Closing::none, false, false, 0.0, 0.6, 0.6}).kind == ProblemKind::gap_left_open);
  CHECK(of(VertexTimed{1, true, 1.0}).kind == ProblemKind::time_clamped);
  CHECK(of(Stopped{StopReason::stall, {}, 1, 2, 0, 3, 0.5, 0.5}).kind == ProblemKind::stopped);
  CHECK_FALSE(problem_of({place, VertexTimed{1, false, 0.5}}, 3, parameters));
}

TEST_CASE("worse kinds come first at any time, the worst of a kind once the run is whole", "[problems]") {
  ProblemRanking ranking;
  ranking.take({1, ProblemKind::band_missed, 0.2});
  ranking.take({2, ProblemKind::time_clamped, 0.0});
  ranking.take({3, ProblemKind::band_missed, 0.9});
  ranking.take({4, ProblemKind::row_resampled, 1.5});
  ranking.take({5, ProblemKind::band_missed, 0.9});
  const auto steps = [&] {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < ranking.size(); ++i) all.push_back(ranking[i].step);
    return all;
  };
  CHECK(steps() == std::vector<std::size_t>{4, 1, 3, 5, 2});
  ranking.finish();
  CHECK(steps() == std::vector<std::size_t>{4, 3, 5, 1, 2});
  ranking.finish();
  CHECK(steps() == std::vector<std::size_t>{4, 3, 5, 1, 2});
}

TEST_CASE("remarks say what is uncovered or stretched, where, and a way on", "[problems]") {
  const auto remarks = remarks_on(half_covered(), contours());
  REQUIRE(remarks.size() == 4);
  CHECK(remarks[0].words ==
        "18 % of the surface is covered by no row: the flat part at vertex 12. Geodesic timing knits flat "
        "parts.");
  CHECK(remarks[0].vertex == 12);
  CHECK(remarks[1].words ==
        "4 % of the surface is covered by no row: the limb at vertex 30, which is left out. Stitches "
        "narrower than "
        "about 0.05 knit it.");
  CHECK(remarks[2].words == "Tube B, row 20: wales up to 9 h long. Settling evens them out.");
  CHECK(remarks[3].words == "Tube B, rows 12 to 15: wales up to 2.3 h long. Settling evens them out.");
  CHECK(remarks[3].at == StitchRef{13, 7});
  CHECK_FALSE(remarks[3].uncovered());
  CHECK(remarks_on(Coverage{}, contours()).empty());
}

TEST_CASE("a way on is none that is gone already", "[problems]") {
  Parameters parameters = contours();
  const auto first = [&] { return remarks_on(half_covered(), parameters).front().words; };
  const auto last = [&] { return remarks_on(half_covered(), parameters).back().words; };
  const auto ends = [](const std::string& words, const std::string& end) { return words.ends_with(end); };
  parameters.timing.kind = TimingKind::geodesic;
  CHECK(ends(first(), " Smaller stitches may reach it."));
  parameters.rows.source = RowSource::rings;
  CHECK(ends(first(), " Rows from contours follow it."));
  CHECK(ends(last(), " Rows from contours lie one stitch height apart."));
  parameters.stitches.placement = PlacementPolicy::thesis;
  CHECK(ends(last(), " Placement nearest hangs each stitch on the nearest ones below."));
  Coverage alone = half_covered();
  alone.tubes = 1;
  CHECK(remarks_on(alone, parameters).back().words.rfind("Rows 12 to 15: ", 0) == 0);
}

TEST_CASE("many stretched rows are told by the worst, all in one sentence", "[problems]") {
  Coverage coverage;
  for (int i = 0; i < 10; ++i) coverage.stretched.push_back({0, 2 * i + 2, 2 * i + 2, 3.0 + i, 0.5, {}});
  const auto remarks = remarks_on(coverage, contours());
  CHECK(remarks.size() == most_stretched + 1);
  CHECK(remarks.front().words.rfind("Row 20: wales up to 12 h", 0) == 0);
  CHECK(remarks.back().words == "Stretched too: 4 more stretches of rows, with wales up to 6 h long.");
  const Coverage seven{{}, {coverage.stretched.begin(), coverage.stretched.begin() + 7}, 1, {}};
  CHECK(remarks_on(seven, contours()).back().words ==
        "Stretched too: 1 more stretch of rows, with wales up to 3 h long.");
  CHECK(summary_of(coverage) == "Wales are up to 12 h long in row 20 and in 9 more stretches of rows.");
  CHECK(summary_of(half_covered()) ==
        "22 % of the surface is covered by no row: the flat part at vertex 12 and 1 more part; wales are up "
        "to 9 h "
        "long in tube B, row 20 and in 1 more stretch of rows.");
  CHECK(summary_of(Coverage{}).empty());
}
