// Sweeps: each run is what a run of its own would be, on however many threads, and faults are sentences.
#include "app/compare/sweep_work.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "app/script/queries.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using test_support::is_one_sentence;
using test_support::lines_of;
using test_support::small_session;

namespace {

SweepPlan plan_of(const std::string& key, double from, double to, int count) {
  return {{key, from, to, count}, std::nullopt};
}

// A run of its own, recorded, tuned where the sweep was begun.
RunFigures fresh_figures(const Session& session, const SweepPlan& plan, const std::vector<double>& values) {
  knit::Timeline timeline = session.document->timeline;
  timeline.tune(with_values(timeline.parameters(), plan, values));
  // From nothing, so that nothing is shared with it.
  knit::Timeline anew(timeline.input_pointer(), timeline.base_parameters());
  anew.set_knobs(timeline.base_parameters(), timeline.edits());
  anew.extend_to_end();
  return figures_of(tally_of(anew), knobs_of(anew));
}

void check_same(const RunFigures& a, const RunFigures& b) {
  CHECK(a.steps == b.steps);
  CHECK(a.rows == b.rows);
  CHECK(a.stitches == b.stitches);
  CHECK(a.problems == b.problems);
  CHECK(a.increases == b.increases);
  CHECK(a.decreases == b.decreases);
  CHECK(a.most_in_a_row == b.most_in_a_row);
  CHECK(a.course.cv == b.course.cv);
  CHECK(a.wale.cv == b.wale.cv);
  CHECK(a.finished == b.finished);
  CHECK(a.stop == b.stop);
}

void check_all(const Session& session, const SweepPlan& plan, unsigned threads) {
  SweepWork work(sweep_base_of(session.document->timeline), plan, threads);
  work.wait();
  REQUIRE(work.done() == work.total());
  for (std::size_t i = 0; i < work.total(); ++i) {
    const SweepRun& run = *work.run(i);
    CAPTURE(plan.axis.key, run.values, threads);
    if (run.refused.empty()) check_same(run.figures, fresh_figures(session, plan, run.values));
  }
}

}  // namespace

TEST_CASE("sweep: every run equals one of its own, whatever is shared and on however many threads",
          "[sweep]") {
  Session session = small_session();
  apply(session, ToLast{});
  for (const unsigned threads : {1U, 3U}) check_all(session, plan_of("epsilon", 0.02, 0.29, 12), threads);
  check_all(session, plan_of("stitch-width", 0.2, 0.6, 5), 2);
  check_all(session, plan_of("level-tolerance", 1e-5, 0.05, 4), 2);
  check_all(session, plan_of("height-cm", 5, 20, 3), 2);
  check_all(session, plan_of("cast-on", 3, 9, 7), 2);
  SweepPlan grid = plan_of("epsilon", 0.05, 0.2, 3);
  grid.second = SweepAxis{"stitch-width", 0.25, 0.5, 4};
  check_all(session, grid, 2);
}

TEST_CASE("sweep: edits on the way are kept and changed as tuning would", "[sweep]") {
  Session session = small_session();
  apply(session, SeekPlace{{knit::Stage::rows, 5, 0}});
  knit::Parameters edited = session.document->timeline.parameters();
  knit::give_epsilon(edited, 0.1);
  edited.rows.close = knit::Closing::none;
  apply(session, EditFromHere{edited});
  check_all(session, plan_of("epsilon", 0.02, 0.29, 9), 2);
}

TEST_CASE("sweep: a value that is refused is a result, and one that stops tells why", "[sweep]") {
  Session session = small_session();
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.rows.on_stall = knit::OnStall::stop;
  apply(session, Tune{parameters});
  apply(session, StartSweep{plan_of("epsilon", 0.001, 0.4, 9)});
  const SweepWork& work = *session.document->sweep->work;
  REQUIRE(work.done() == 9);
  CHECK_FALSE(work.run(0)->figures.finished);
  CHECK(is_one_sentence(work.run(0)->figures.stop));
  CHECK(work.run(0)->figures.problems.total() > 0);
  // A stop at a stall is one.
  CHECK(work.run(0)->figures.problems.of(knit::ProblemKind::band_missed) == 1);
  CHECK(work.run(0)->figures.problems.of(knit::ProblemKind::stopped) == 0);
  CHECK(work.run(8)->figures.rows == 0);
  CHECK(is_one_sentence(work.run(8)->refused));
  CHECK(work.run(3)->refused.empty());
}

TEST_CASE("sweep: values are tidy, and those of a count are whole and each there once", "[sweep]") {
  CHECK(values_of({"epsilon", 0.01, 0.05, 5}) == std::vector<double>{0.01, 0.02, 0.03, 0.04, 0.05});
  CHECK(values_of({"cast-on", 3, 6, 100}) == std::vector<double>{3, 4, 5, 6});
  const auto many = values_of({"epsilon", 0.1, 0.7, 10000});
  CHECK(many.size() == 10000);
  CHECK(many.front() == 0.1);
  CHECK(many.back() == 0.7);
}

TEST_CASE("sweep: what cannot be swept is told in one sentence each", "[sweep]") {
  const auto fault = [](const std::vector<std::string>& axes) { return fault_of_sweep(axes).value_or(""); };
  CHECK(fault({}).empty());
  CHECK(fault({"epsilon=0.02:0.04:3"}).empty());
  CHECK(fault({"epsilon=0.02:0.04:3", "stitch-width=0.1:0.2:3"}).empty());
  std::set<std::string> sentences;
  const std::vector<std::vector<std::string>> wrong{
      {"epsilon"},
      {"epsilons=1:2:3"},
      {"axis=1:2:3"},
      {"epsilon=0.02:0.04:1"},
      {"epsilon=0.02:0.04:10001"},
      {"epsilon=0.04:0.02:3"},
      {"epsilon=-1:0.02:3"},
      {"cast-on=3:1001:3"},
      {"epsilon=nan:0.02:3"},
      {"epsilon=0.1:0.2:3", "epsilon=0.1:0.2:3"},
      {"epsilon=0.1:0.2:400", "stitch-width=0.1:0.2:400"},
      {"epsilon=0.1:0.2:3", "cast-on=3:9:3", "height-cm=3:9:3"}};
  for (const auto& axes : wrong) {
    CAPTURE(axes);
    CHECK(is_one_sentence(fault(axes)));
    sentences.insert(fault(axes));
  }
  CHECK(sentences.size() == wrong.size());
}

TEST_CASE("sweep: cancelled work ends soon and keeps what is done", "[sweep]") {
  const Session session = test_support::example_session("thesis-sphere");
  SweepWork work(sweep_base_of(session.document->timeline), plan_of("epsilon", 0.02, 0.09, 10000), 2);
  while (work.done() < 2) std::this_thread::yield();
  const auto start = std::chrono::steady_clock::now();
  work.cancel();
  work.wait();
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
  CHECK_FALSE(work.running());
  CHECK(work.done() >= 2);
  CHECK(work.done() < 1000);
}

TEST_CASE("sweep: the table has a header and a line a run, whatever is in the cells", "[sweep]") {
  Session session = small_session();
  const auto lines = lines_of(sweep_answer(session, {"epsilon=0.1:0.4:4"}).out);
  REQUIRE(lines.size() == 5);
  CHECK(
      lines[0] ==
      "epsilon,outcome,steps,rows,stitches,increases,decreases,most_in_a_row,problems,course_cv,wale_cv,why,"
      "tubes,splits,joins,genus,yarns,holders,left_out,uncovered,stalls,resampled,gaps_open,clamped");
  CHECK(lines[1].rfind("0.1,finished,", 0) == 0);
  CHECK(std::count(lines[4].begin(), lines[4].end(), ',') >= 23);  // its sentence may have some
  CHECK(lines[4].rfind("0.4,refused,,,,,,,,,,", 0) == 0);
  CHECK(std::count(lines[1].begin(), lines[1].end(), ',') == 23);
  const auto grid = lines_of(sweep_answer(session, {"epsilon=0.1:0.2:3", "cast-on=4:7:4"}).out);
  REQUIRE(grid.size() == 13);
  CHECK(grid[0].rfind("epsilon,cast-on,outcome,", 0) == 0);
  CHECK(grid[1].rfind("0.1,4,", 0) == 0);
  CHECK(grid[2].rfind("0.1,5,", 0) == 0);
  CHECK(grid[12].rfind("0.2,7,", 0) == 0);
}

TEST_CASE("sweep: a value is taken like a turned knob, and a fault is a notice", "[sweep]") {
  Session session = small_session();
  apply(session, StartSweep{plan_of("axis", 1, 2, 3)});
  CHECK_FALSE(session.document->sweep);
  REQUIRE(session.outbox->notices.size() == 1);
  apply(session, StartSweep{plan_of("epsilon", 0.05, 0.25, 5)});
  REQUIRE(session.document->sweep);
  CHECK_FALSE(swept_otherwise(*session.document->sweep->work, session.document->timeline));
  apply(session, TakeSweepValue{1});
  CHECK(session.document->timeline.parameters().epsilon() == 0.1);
  CHECK_FALSE(swept_otherwise(*session.document->sweep->work, session.document->timeline));
  session.document->timeline.extend_to_end();
  check_same(session.document->sweep->work->run(1)->figures,
             figures_of(tally_of(session.document->timeline), knobs_of(session.document->timeline)));
  apply(session, TakeSweepValue{99});
  CHECK(session.document->timeline.parameters().epsilon() == 0.1);
  knit::Parameters other = session.document->timeline.parameters();
  other.rows.close = knit::Closing::none;
  apply(session, Tune{other});
  CHECK(swept_otherwise(*session.document->sweep->work, session.document->timeline));
  apply(session, OpenExample{"thesis-sphere"});
  CHECK_FALSE(session.document->sweep);
}

TEST_CASE("sweep: the longest stretch without problems, of equally long ones the last", "[sweep]") {
  const std::vector<double> values{1, 2, 3, 4, 5, 6};
  CHECK_FALSE(longest_quiet(values, {false, false, false, false, false, false}));
  CHECK(longest_quiet(values, {true, true, true, true, true, true}) == QuietStretch{1, 6, true, true});
  CHECK(longest_quiet(values, {true, true, false, false, true, true}) == QuietStretch{5, 6, false, true, 4});
  CHECK(longest_quiet(values, {false, true, true, false, true, false}) ==
        QuietStretch{2, 3, false, false, 1, 4});
}

TEST_CASE("sweep: the ends of the stretch are narrowed down to five digits and keep their invariant",
          "[sweep]") {
  QuietStretch stretch{0.2, 0.4, false, false, 0.1, 0.5};
  std::size_t runs = 0;
  narrow_down(stretch, false, [&](double value) {
    ++runs;
    return std::optional(value >= 0.123455 && value < 0.4321);
  });
  CHECK(stretch == QuietStretch{0.12346, 0.43209, false, false, 0.12345, 0.4321});
  CHECK(runs <= 2 * 15);
  QuietStretch whole{20, 30, false, true, 10};
  narrow_down(whole, true, [](double value) { return std::optional(value >= 13); });
  CHECK(whole == QuietStretch{13, 30, false, true, 12});
  QuietStretch dropped{0.2, 0.4, false, true, 0.1};
  narrow_down(dropped, false, [](double) { return std::optional<bool>(); });
  CHECK(dropped == QuietStretch{0.2, 0.4, false, true, 0.1});
}

TEST_CASE("sweep: after its runs it says to five digits from where on there is no stall", "[sweep]") {
  const Session session = test_support::example_session("thesis-sphere");
  SweepWork work(sweep_base_of(session.document->timeline), plan_of("epsilon", 0.015, 0.025, 3), 2);
  work.wait();
  CHECK_FALSE(work.running());
  const QuietStretch* stalls = work.quiet(knit::ProblemKind::band_missed);
  REQUIRE(stalls != nullptr);
  CHECK(work.quiet(knit::ProblemKind::gap_left_open) == nullptr);
  CHECK(stalls->to_last);
  REQUIRE(stalls->not_yet);
  CHECK(stalls->from - *stalls->not_yet < 1.5e-6);
  const auto stalls_at = [&](double epsilon) {
    return fresh_figures(session, work.plan(), {epsilon}).problems.of(knit::ProblemKind::band_missed);
  };
  CHECK(stalls_at(stalls->from) == 0);
  CHECK(stalls_at(*stalls->not_yet) > 0);
  CAPTURE(stalls->from, *stalls->not_yet);
  CHECK(stalls->from == 0.019237);
}
