// Loops on holders: which wait is known at every step, the same in the stages after the rows; a break holds where one begins to.
#include <algorithm>

#include "knit/insight/breaks.h"
#include "knit/insight/waiting.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace knit;

namespace {

Timeline contour_run(const Mesh& mesh, Smoothing smoothing = Smoothing::by_itself,
                     AxisKind axis = AxisKind::y) {
  const auto input = make_input(mesh);
  Parameters parameters;
  give_width(parameters, 0.12);
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters.tubes.smoothing = smoothing;
  parameters.timing.axis.kind = axis;
  Timeline timeline(input, resolved(parameters, *input));
  timeline.extend_to_end();
  return timeline;
}

Timeline octopus_run() {
  app::Session session = test_support::example_session("octopus");
  Timeline timeline = session.document->timeline;
  timeline.extend_to_end();
  return timeline;
}

std::vector<Timeline> branching_runs() {
  Mesh horns = test_support::arch();
  for (glm::dvec3& p : horns.positions) p = {p.x, -p.y, -p.z};
  return {contour_run(test_support::arch()), contour_run(horns),
          contour_run(torus(48, 24, 0.68, 0.32), Smoothing::by_itself, AxisKind::x),
          contour_run(torus(48, 24, 0.68, 0.32), Smoothing::off), octopus_run()};
}

std::vector<TubeId> tubes_of(const std::vector<LiveLoop>& loops) {
  std::vector<TubeId> tubes;
  for (const LiveLoop& loop : loops) tubes.push_back(loop.tube);
  std::sort(tubes.begin(), tubes.end());
  return tubes;
}

std::vector<LiveLoop> by_tube(std::vector<LiveLoop> loops) {
  std::sort(loops.begin(), loops.end(), [](const LiveLoop& a, const LiveLoop& b) { return a.tube < b.tube; });
  return loops;
}

// Of the condition `hold`, by step.
std::vector<std::size_t> hits_of_hold(const Timeline& timeline) {
  BreakScanner scanner({std::get<BreakCondition>(parse_break("hold"))});
  for (std::size_t i = 0; i < timeline.known(); ++i)
    scanner.take(timeline.step(i), timeline.parameters_of_step(i), timeline.furthest().fabric);
  std::vector<std::size_t> steps;
  for (const BreakHit& hit : scanner.hits()) steps.push_back(hit.step);
  return steps;
}

}  // namespace

TEST_CASE("waiting: while a row is placed, labelled and sewn, the same loops wait, with their stitches") {
  for (Timeline& timeline : branching_runs()) {
    const State end = timeline.furthest();
    std::size_t waits = 0;
    for (RowId row = 1; row <= end.fabric.row_count(); ++row) {
      const std::vector<LiveLoop> told = by_tube(waiting_loops(*end.tubes, end.fabric, row));
      waits += told.size();
      // In the middle of placing its stitches.
      const Place last{stage_of_row(row), row, std::numeric_limits<std::int32_t>::max()};
      timeline.seek(timeline.position_of(last) - 1);
      REQUIRE(std::holds_alternative<ContourWork>(timeline.state().work));
      CHECK(by_tube(waiting_loops(timeline.state())) == told);
      CHECK(tubes_of(waiting_loops(timeline.state())).size() == waiting_tubes(timeline.state()).size());
      for (const Stage stage : {Stage::stitches, Stage::faces, Stage::pattern}) {
        timeline.seek(timeline.position_of({stage, row, -1}));
        if (timeline.state().next.row == row && timeline.state().next.stage == stage)
          CHECK(by_tube(waiting_loops(timeline.state())) == told);
      }
      std::int32_t stitches = 0;
      for (const LiveLoop& loop : told) stitches += loop.stitches.size();
      CHECK((stitches > 0) == !told.empty());
    }
    CHECK(waits > 0);
    CHECK(waiting_loops(end).empty());
  }
}

TEST_CASE("waiting: taking up a tube tells what waits from then on, and which begins to") {
  for (Timeline& timeline : branching_runs()) {
    const std::vector<std::size_t> hits = hits_of_hold(timeline);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < timeline.known(); ++i) {
      const auto* taken = get_if<TubeTaken>(timeline.step(i));
      if (taken == nullptr) continue;
      timeline.seek(i);
      const std::vector<TubeId> before = tubes_of(waiting_loops(timeline.state()));
      timeline.seek(i + 1);
      const std::vector<TubeId> then = tubes_of(waiting_loops(timeline.state()));
      if (timeline.state().stage() > Stage::rows) continue;  // the last step of the rows
      wrong += taken->held == static_cast<std::int32_t>(then.size()) ? 0U : 1U;
      std::vector<TubeId> begins;
      std::set_difference(then.begin(), then.end(), before.begin(), before.end(), std::back_inserter(begins));
      wrong +=
          begins == (taken->aside < 0 ? std::vector<TubeId>{} : std::vector<TubeId>{taken->aside}) ? 0U : 1U;
      if (!begins.empty()) CHECK(std::find(hits.begin(), hits.end(), i) != hits.end());
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE(
    "waiting: the break holds where a leg is laid aside for the next, and where a split leaves one over") {
  const std::vector<Timeline> runs = branching_runs();
  const std::vector<std::size_t> arch = hits_of_hold(runs[0]);
  REQUIRE(arch.size() == 1);  // the first leg, when the second is cast on; the join takes both
  const auto* second = get_if<TubeTaken>(runs[0].step(arch[0]));
  REQUIRE(second != nullptr);
  CHECK(second->live == 0);
  CHECK(second->aside == 0);
  const std::vector<std::size_t> horns = hits_of_hold(runs[1]);
  REQUIRE(horns.size() == 1);
  CHECK(is<LoopsDealt>(runs[1].step(horns[0])));
  CHECK(hits_of_hold(runs[4]).size() == 8);  // of an octopus: each leg, or what it was joined to
}
