// Runs side by side where they are worked in tubes: --diff, --sweep and the panels beside them.
#include <algorithm>
#include <string>

#include "app/compare/compare_runs.h"
#include "app/compare/sweep_work.h"
#include "app/panels/kit/sweep_cache.h"
#include "app/panels/kit/widgets.h"
#include "app/script/queries.h"
#include "app/session/document.h"
#include "knit/model/stitch_size.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace app;
using test_support::contains;
using test_support::lines_of;

namespace {

knit::Parameters of_contours(double width, const knit::Input& input) {
  knit::Parameters parameters;
  give_width(parameters, width);
  parameters.rows.source = knit::RowSource::contours;
  parameters.stitches.placement = knit::PlacementPolicy::nearest;
  return resolved(parameters, input);
}

// Two legs that join.
std::shared_ptr<const knit::Input> two_legs() { return knit::make_input(test_support::arch()); }

Session on_two_legs(double width) {
  const auto input = two_legs();
  const knit::Parameters parameters = of_contours(width, *input);
  Session session;
  session.document = Document(knit::Timeline(input, parameters));
  session.document->defaults = parameters;
  session.document->timeline.extend_to_end();
  return session;
}

RunDifference between(const knit::Input& input, const knit::Parameters& a, const knit::Parameters& b) {
  const Knobs knobs_a{a, {}}, knobs_b{b, {}};
  const RunTally run_a = whole_run(input, knobs_a), run_b = whole_run(input, knobs_b);
  const RunFigures figures_a = figures_of(run_a, knobs_a), figures_b = figures_of(run_b, knobs_b);
  return difference_of({input, knobs_a, run_a.state, figures_a}, {input, knobs_b, run_b.state, figures_b});
}

std::int32_t rounds_of(const knit::State& state, knit::TubeId tube) {
  return static_cast<std::int32_t>(std::count_if(state.fabric.rows().begin(), state.fabric.rows().end(),
                                                 [&](const auto& row) { return row->tube == tube; }));
}

const FigureLine* line_named(const RunDifference& difference, const std::string& key) {
  const auto found = std::find_if(difference.figures.begin(), difference.figures.end(),
                                  [&](const FigureLine& line) { return line.key == key; });
  return found != difference.figures.end() ? &*found : nullptr;
}

// A tube from one place to another, without rows.
void add_tube(knit::TubePlan& plan, double from, double to) {
  knit::Tube tube;
  tube.height = 1.0;
  tube.bottom = static_cast<std::int32_t>(plan.events.size());
  tube.top = tube.bottom + 1;
  for (const double x : {from, to}) {
    knit::TubeEvent event;
    event.position = {x, 0.0, 0.0};
    plan.events.push_back(event);
  }
  plan.tubes.push_back(tube);
}

}  // namespace

TEST_CASE("compare: each tube is set against itself, and told where it differs", "[compare]") {
  const auto input = two_legs();
  const knit::Parameters fine = of_contours(0.12, *input), coarse = of_contours(0.15, *input);
  const RunDifference difference = between(*input, fine, coarse);
  REQUIRE(difference.tubes.size() == 3);
  const knit::State before = whole_run(*input, {fine, {}}).state;
  const knit::State now = whole_run(*input, {coarse, {}}).state;
  for (const TubeLine& line : difference.tubes) {
    REQUIRE(line.name_a == line.name_b);
    const knit::TubeId tube = line.name_a[0] - 'A';
    CHECK(line.rounds_a == rounds_of(before, tube));
    CHECK(line.rounds_b == rounds_of(now, tube));
    CHECK(line.rounds_a > line.rounds_b);
  }
  const TubeLine& first = difference.tubes.front();
  const std::string text = text_of(difference, "fine", "coarse");
  CHECK(contains(text, "Tube A has " + std::to_string(first.rounds_b) + " rounds, " +
                           std::to_string(first.rounds_a) + " before, and "));
  REQUIRE(line_named(difference, "joins") != nullptr);
  CHECK(line_named(difference, "joins")->a == "1");
  CHECK(line_named(difference, "splits")->a == "0");
  CHECK(line_named(difference, "genus")->b == "0");
  CHECK(line_named(difference, "tubes")->difference.empty());
}

TEST_CASE("compare: tubes that only one run has are told with their size", "[compare]") {
  const auto input = two_legs();
  const knit::Parameters parameters = of_contours(0.12, *input);
  knit::Parameters pruned = parameters;
  pruned.tubes.smallest_limb = 100;
  const RunDifference difference = between(*input, parameters, pruned);
  const auto gone = std::count_if(difference.tubes.begin(), difference.tubes.end(),
                                  [](const TubeLine& line) { return line.name_b.empty(); });
  CHECK(gone == 2);
  CHECK(contains(text_of(difference, "a", "b"), " stitches, is in the first run only."));
  RunDifference missing;
  missing.rows = missing.rows_differ = 7;
  missing.first_row = FirstRow{5, RowDiffers::missing, 12, 0};
  CHECK(contains(rows_words(missing), "first row 5: only the first run has it."));
  CHECK(contains(rows_words(missing, {"the pinned run", "this run"}), ": only the pinned run has it."));
  CHECK(line_named(difference, "tubes")->b == "1");
  CHECK(line_named(difference, "left-out")->difference == "+1");
  const RunDifference back = between(*input, pruned, parameters);
  CHECK(contains(text_of(back, "a", "b"), " stitches, is in the second run only."));
}

TEST_CASE("compare: tubes that changed their names are known by their place on one mesh, by name on two",
          "[compare]") {
  knit::TubePlan plan, other;
  add_tube(plan, 0.0, 1.0);
  add_tube(plan, 5.0, 6.0);
  add_tube(other, 5.1, 6.0);
  add_tube(other, 9.0, 10.0);
  add_tube(other, 0.0, 1.1);
  knit::State a, b;
  a.tubes = knit::Shared(plan);
  b.tubes = knit::Shared(other);
  const auto names = [](const std::vector<TubeLine>& lines) {
    std::string all;
    for (const TubeLine& line : lines) all += line.name_a + "-" + line.name_b + " ";
    return all;
  };
  CHECK(names(tube_lines(a, b, true)) == "B-A -B A-C ");
  CHECK(names(tube_lines(b, a, true)) == "C-A A-B B- ");
  CHECK(names(tube_lines(a, b, false)) == "A-A B-B -C ");
}

TEST_CASE("compare and sweep: one is not many") {
  RunDifference difference;
  difference.rows = 4;
  difference.rows_differ = 1;
  difference.first_row = FirstRow{3, RowDiffers::size, 1, 2};
  CHECK(rows_words(difference) == "1 of 4 rows differs, first row 3: 1 stitch and 2.");
  difference.first_row = FirstRow{3, RowDiffers::places, 2, 2};
  CHECK(contains(rows_words(difference), ": 2 stitches in both, "));
  CHECK(words_of(TubeLine{"C", "B", 1, 2, 5, 1}) ==
        "Tube B, C before, has 2 rounds, 1 before, and 1 stitch, 5 before.");
  CHECK(with_commas(1, "run", "runs") == "1 run");
  CHECK(with_commas(1200, "run", "runs") == "1,200 runs");
}

TEST_CASE("compare: of one tube in both runs nothing is said about tubes", "[compare]") {
  Session session = test_support::finished_small_session();
  const knit::Input& input = session.document->timeline.input();
  const RunDifference difference = between(input, of_contours(0.3, input), of_contours(0.4, input));
  CHECK(difference.tubes.empty());
  CHECK(line_named(difference, "tubes") == nullptr);
  CHECK_FALSE(contains(text_of(difference, "a", "b"), "Tube"));
}

TEST_CASE("sweep: tubes, yarns, what is left out and uncovered stand in the table", "[sweep]") {
  Session session = on_two_legs(0.12);
  const auto lines = lines_of(sweep_answer(session, {"stitch-width=0.12:0.16:2"}).out);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].ends_with(
      ",why,tubes,splits,joins,genus,yarns,holders,left_out,uncovered,stalls,resampled,gaps_open,clamped"));
  const SweepWork& work = *session.document->sweep->work;
  const SweepRun& run = *work.run(0);
  CHECK(run.tubes.tubes == 3);
  CHECK(run.tubes.joins == 1);
  CHECK(run.tubes.yarns == 2);
  CHECK(run.tubes.holders == 1);
  REQUIRE(run.uncovered);
  const knit::Timeline& timeline = session.document->timeline;
  const knit::StitchSize stitch = timeline.parameters().stitch;
  CHECK(*run.uncovered ==
        knit::measure_uncovered(timeline.input(), timeline.furthest(), stitch.width, stitch.height).share);
  CHECK(contains(lines[1], ",3,0,1,0,2,1,0,"));
  // Rows of rings: one tube, and nothing measured that would hold up a sweep.
  Session rings = test_support::finished_small_session();
  CHECK(lines_of(sweep_answer(rings, {"epsilon=0.1:0.2:2"}).out)[1].ends_with(",,1,0,0,0,1,0,0,,0,0,0,0"));
}

TEST_CASE("compare and sweep sides: tubes that differ, and a figure of them to choose", "[panels]") {
  desk::Desk at(1280, 960);
  at.session.view->side = SidePanel::compare;
  at.session.document = std::move(on_two_legs(0.12).document);
  at.settle();
  at.act({PinRun{}});
  knit::Parameters parameters = at.session.document->timeline.parameters();
  knit::give_width(parameters, 0.15);
  at.act({Tune{parameters}});
  at.session.document->timeline.extend_to_end();
  at.settle();
  CHECK(at.ui.controls.count("compare/tube/A") == 1);
  CHECK(at.ui.controls.count("compare/figure/joins") == 1);

  at.session.view->side = SidePanel::sweep;
  at.act({StartSweep{{{"stitch-width", 0.12, 0.16, 2}, std::nullopt}}});
  at.settle();
  CHECK(at.ui.controls.count("sweep/course-cv") == 1);
  at.click("sweep/figure");
  at.click("sweep/figure/Tubes");
  at.settle();
  CHECK(at.ui.controls.count("sweep/tubes") == 1);
  CHECK(at.ui.own<SweepCache>().highest(SweepFigure::tubes) == 3.0);
}

TEST_CASE("units: one of them stands in the singular") {
  CHECK(with_unit("1", "rounds") == "1 round");
  CHECK(with_unit("1", "stitches") == "1 stitch");
  CHECK(with_unit("2", "stitch heights") == "2 stitch heights");
  CHECK(with_unit("1", "weight") == "1 weight");
  CHECK(with_unit("1.5", "stitch heights") == "1.5 stitch heights");
}
