// The thesis's one result, as far as it can be reproduced: golden counts of the fixture.
#include "knit/quality/measures.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

namespace {

std::vector<int> golden_rows() {
  std::vector<int> rows{6, 12, 17, 22, 26, 33, 33, 43, 43, 43, 43};
  rows.insert(rows.end(), 42, 65);
  const std::vector<int> end{43, 43, 43, 43, 33, 33, 26, 22, 17, 12, 6};
  rows.insert(rows.end(), end.begin(), end.end());
  return rows;
}

}  // namespace

TEST_CASE("thesis sphere: the golden counts, and nothing unusual") {
  Timeline timeline(test_support::thesis_sphere(), test_support::thesis_parameters());
  timeline.extend_to_end();
  const State& state = timeline.furthest();
  REQUIRE(timeline.stop() == nullptr);
  REQUIRE(state.finished());
  CHECK(test_support::row_sizes(state) == golden_rows());
  CHECK(state.fabric.stitch_count() == 3372);
  CHECK(count_faces(state).quads == 3307);
  CHECK(count_faces(state).triangles == 118);
  CHECK(euler_characteristic(state) == 0);
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    CHECK_FALSE(is_unusual(timeline.step(i), timeline.parameters_of_step(i)));
  }
}

TEST_CASE("thesis sphere: courses as the study measured them, for each way to share the gap") {
  const auto figures = [](Closing close) {
    Parameters parameters = test_support::thesis_parameters();
    parameters.rows.close = close;
    Timeline timeline(test_support::thesis_sphere(), parameters);
    timeline.extend_to_end();
    return course_figures(timeline.furthest());
  };
  const LengthFigures thesis = figures(Closing::thesis);
  CHECK(thesis.mean == Approx(0.0770).margin(0.00005));
  CHECK(thesis.cv == Approx(0.202).margin(0.0005));
  CHECK(thesis.low == Approx(0.0415).margin(0.00005));
  CHECK(thesis.high == Approx(0.0987).margin(0.00005));
  const LengthFigures arc = figures(Closing::arc);
  CHECK(arc.cv == Approx(0.195).margin(0.0005));
  CHECK(arc.low == Approx(0.0483).margin(0.00005));
  CHECK(arc.high == Approx(0.0966).margin(0.00005));
  const LengthFigures none = figures(Closing::none);
  CHECK(none.cv == Approx(0.232).margin(0.0005));
  CHECK(none.low == 0.0);
}

TEST_CASE("thesis sphere: a gap left open outside the band is a problem to see") {
  Parameters parameters = test_support::thesis_parameters();
  parameters.rows.close = Closing::none;
  Timeline timeline(test_support::thesis_sphere(), parameters);
  timeline.extend_to_end();
  int problems = 0;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    problems += is_unusual(timeline.step(i), parameters) ? 1 : 0;
  }
  CHECK(problems == 63);
}
