// The ranking of problems: the same ones as is_unusual finds, worst first.
#include "knit/insight/problems.h"

#include <algorithm>

#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

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
