// Steps that take long: where they are, that they can be taken elsewhere, and that they are taken once.
#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "knit/insight/narrate.h"
#include "knit/mesh/branching_shapes.h"
#include "knit/model/heard_sort.h"
#include "knit/model/stitch_size.h"
#include "tests/support/beside.h"

using namespace knit;
using test_support::large_parameters;

namespace {

Timeline large_run(TimingKind timing) {
  return {make_input(*test_support::large_ball()), large_parameters(timing)};
}

// Works the run out as a window does; the kinds of the steps that were taken at once.
std::set<std::string> run_briefly(Timeline& timeline) {
  std::set<std::string> brief;
  while (!timeline.complete()) {
    const std::size_t known = timeline.known();
    timeline.extend_briefly(10000);
    for (std::size_t i = known; i < timeline.known(); ++i)
      brief.insert(std::string(kind_name(timeline.step(i))));
    if (timeline.next_is_long()) timeline.accept(timeline.next_job(), Timeline::work(timeline.next_job()));
  }
  return brief;
}

std::set<std::string> solves() {
  const auto name = [](const Event& what) { return std::string(kind_name({{}, what})); };
  return {name(FieldSolved{}), name(HeightsMeasured{}), name(CriticalsFound{}), name(LevelsGrouped{})};
}

// What a state holds that was long in the making.
std::vector<std::shared_ptr<const void>> long_products(const State& state) {
  std::vector<std::shared_ptr<const void>> all{state.timing.pointer()};
  if (const auto* timing = std::get_if<TimingWork>(&state.work)) {
    all.insert(all.end(), {timing->net.pointer(), timing->heat.pointer(), timing->slopes.pointer(),
                           timing->field.pointer(), timing->scale.pointer(), timing->criticals.pointer()});
  }
  if (const auto* tubes = std::get_if<TubesWork>(&state.work))
    all.insert(all.end(), {tubes->graph.pointer(), tubes->plan.pointer()});
  return all;
}

// Trousers, some thousand stitches, where they begin to settle.
Timeline settling_run() {
  Parameters parameters;
  parameters.timing.axis = {AxisKind::y, {0.0, 1.0, 0.0}};
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters.settle.settling = Settling::by_itself;
  give_width(parameters, 0.07);
  Timeline timeline(make_input(trousers(0.08)), parameters);
  timeline.extend_to({Stage::settle, 0, 0});
  return timeline;
}

struct BrokenOff {};

// How often the step is heard. Whenever it is broken off, the state is as before.
std::size_t times_heard(const Timeline::Job& job, const Timeline::Outcome& whole) {
  std::vector<double> shares;
  const Timeline::Outcome heard = Timeline::work(job, [&](double share) { shares.push_back(share); });
  CHECK(heard.step == whole.step);
  CHECK(heard.state == whole.state);
  if (shares.empty()) return 0;
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.front() >= 0.0);
  CHECK(shares.back() <= 1.0);
  for (const std::size_t stop_at : {std::size_t{1}, (shares.size() + 1) / 2, shares.size()}) {
    State state = job.state;
    std::size_t calls = 0;
    const Heard stopping = [&](double /*share*/) {
      if (++calls == stop_at) throw BrokenOff{};
    };
    CHECK_THROWS_AS(advance(*job.input, job.parameters, state, stopping), BrokenOff);
    CHECK(calls == stop_at);
    CHECK(state == job.state);
    CHECK(static_cast<bool>(state.placed) == static_cast<bool>(job.state.placed));
  }
  return shares.size();
}

}  // namespace

TEST_CASE("settling is heard, and broken off without a trace") {
  Timeline timeline = settling_run();
  REQUIRE(timeline.whole());
  for (int step = 0; step < 3; ++step) {  // the beginning, two iterations
    REQUIRE(timeline.next_is_long());
    const Timeline::Job job = timeline.next_job();
    const Timeline::Outcome whole = Timeline::work(job);
    CHECK(times_heard(job, whole) >= 8);
    timeline.accept(job, whole);
  }
  CHECK(timeline.furthest().placed);
}

TEST_CASE("the rhythm of a large piece is planned elsewhere, heard, and broken off without a trace") {
  Parameters parameters;
  parameters.timing.kind = TimingKind::arc_length;
  parameters.rows.source = RowSource::contours;
  parameters.rhythm.counts = CountPlanning::rhythm;
  parameters.rhythm.changes = 8;
  parameters.rhythm.dial = 1.0;
  for (const bool large : {false, true}) {
    give_width(parameters, large ? 0.03 : 0.1);
    Timeline timeline(make_input(sphere(24, 12)), parameters);
    bool planned = false;
    while (!planned) {
      const Timeline::Job job = timeline.next_job();
      const Timeline::Outcome whole = Timeline::work(job);
      planned = get_if<RhythmPlanned>(whole.step) != nullptr;
      if (planned) {
        CHECK(timeline.next_is_long() == large);
        CHECK(times_heard(job, whole) >= 8);
      }
      timeline.accept(job, whole);
    }
  }
}

TEST_CASE("what is solved for on a large mesh is heard, and broken off without a trace") {
  const TimingKind timing = GENERATE(TimingKind::geodesic, TimingKind::harmonic);
  Timeline timeline = large_run(timing);
  timeline.extend_briefly(10);
  std::size_t solved = 0;
  while (timeline.next_is_long() && !timeline.furthest().timing) {
    const Timeline::Job job = timeline.next_job();
    const Timeline::Outcome whole = Timeline::work(job);
    const auto* step = get_if<FieldSolved>(whole.step);
    const bool is_solve =
        step != nullptr && step->which != FieldStep::net && step->which != FieldStep::slopes;
    const std::size_t times = times_heard(job, whole);
    CAPTURE(kind_name(whole.step));
    CHECK(times >= (is_solve ? 8 : step != nullptr ? 2 : 0));
    solved += is_solve ? 1U : 0U;
    timeline.accept(job, whole);
    if (timeline.furthest().stage() != Stage::timing) break;
    timeline.extend_briefly(20000);
  }
  CHECK(solved == (timing == TimingKind::geodesic ? 2 : 1));
}

TEST_CASE("every other long step on a large mesh is heard too, and broken off without a trace") {
  const TimingKind timing = GENERATE(TimingKind::linear, TimingKind::arc_length);
  const Smoothing smoothing = timing == TimingKind::linear ? Smoothing::on : Smoothing::off;
  Parameters parameters = large_parameters(timing);
  parameters.tubes.smoothing = smoothing;
  Timeline timeline(make_input(*test_support::large_ball()), parameters);
  std::set<std::string> heard;
  while (timeline.furthest().stage() <= Stage::tubes) {
    timeline.extend_briefly(20000);
    if (!timeline.next_is_long()) continue;
    const Timeline::Job job = timeline.next_job();
    const Timeline::Outcome whole = Timeline::work(job);
    CAPTURE(kind_name(whole.step));
    CHECK(times_heard(job, whole) >= (get_if<LevelsGrouped>(whole.step) != nullptr ? 2 : 4));
    heard.insert(std::string(kind_name(whole.step)));
    timeline.accept(job, whole);
  }
  const auto name = [](const Event& what) { return std::string(kind_name({{}, what})); };
  const bool smoothed = smoothing == Smoothing::on;
  CHECK(heard.count(name(CriticalsFound{})) == 1);
  CHECK(heard.count(name(LevelsGrouped{})) == 1);
  CHECK(heard.count(name(GraphFound{})) == 1);
  CHECK(heard.count(name(FieldSmoothed{})) == (smoothed ? 1 : 0));
  CHECK(heard.count(name(HeightsMeasured{})) == (smoothed ? 0 : 1));
}

TEST_CASE("many values are sorted in the order that std::sort finds, heard on the way") {
  std::vector<std::uint32_t> values(150000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint32_t>(i * 2654435761U);
  std::vector<std::uint32_t> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> shares;
  const Heard heard = [&](double share) { shares.push_back(share); };
  sort_heard(values, std::less<>(), heard);
  CHECK(values == sorted);
  CHECK(shares.size() >= 8);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  shares.clear();
  sort_heard(values, std::less<>(), heard);  // in order already
  CHECK(shares.empty());
  CHECK(values == sorted);
}

TEST_CASE("what takes long on a large mesh is not taken by the way") {
  const TimingKind timing =
      GENERATE(TimingKind::linear, TimingKind::arc_length, TimingKind::geodesic, TimingKind::harmonic);
  CAPTURE(timing);
  Timeline timeline = large_run(timing);
  const std::set<std::string> brief = run_briefly(timeline);
  for (const std::string& solve : solves()) CHECK(brief.count(solve) == 0);
  CHECK(timeline.furthest().finished());
  Timeline plain = large_run(timing);
  plain.extend_to_end();
  CHECK(timeline.steps() == plain.steps());
  CHECK(timeline.furthest() == plain.furthest());
}

TEST_CASE("finding and planning tubes on a large mesh is not taken by the way either") {
  Timeline timeline = large_run(TimingKind::linear);
  const std::set<std::string> brief = run_briefly(timeline);
  CHECK(brief.count(std::string(kind_name({{}, GraphFound{}}))) == 0);
  CHECK(brief.count(std::string(kind_name({{}, FieldSmoothed{}}))) == 0);
}

TEST_CASE("on a small mesh no step is long") {
  Timeline timeline(test_support::small_sphere(), large_parameters(TimingKind::geodesic));
  while (timeline.extend_briefly(1)) CHECK_FALSE(timeline.next_is_long());
  CHECK(timeline.furthest().finished());
}

TEST_CASE("brief steps end before a long one, however often they are asked for") {
  Timeline timeline = large_run(TimingKind::geodesic);
  CHECK(timeline.extend_briefly(1000000));  // there is more to come
  CHECK(timeline.known() == 1);
  CHECK(timeline.extend_briefly(1000000));
  CHECK(timeline.known() == 1);
  CHECK(timeline.next_is_long());
  timeline.extend(1);  // this one waits for it
  CHECK(timeline.known() == 2);
}

TEST_CASE("an outcome counts once, where its job was given out, and as long as nothing was changed") {
  Timeline timeline = large_run(TimingKind::geodesic);
  timeline.extend_briefly(10);
  const Timeline::Job job = timeline.next_job();
  const Timeline::Outcome outcome = Timeline::work(job);
  CHECK(job.state == timeline.furthest());  // the job is worked on copies

  Timeline other = large_run(TimingKind::geodesic);  // the same mesh, but another object
  other.extend_briefly(10);
  other.accept(job, outcome);
  CHECK(other.known() == 1);

  Timeline tuned = timeline;
  Parameters wider = tuned.parameters();
  give_width(wider, 0.25);
  tuned.tune(wider);
  tuned.accept(job, outcome);
  CHECK(tuned.known() == 1);
  tuned.tune(job.parameters);  // back again: it is the step that is due
  tuned.accept(job, outcome);
  CHECK(tuned.known() == 2);

  Timeline back = timeline;
  back.seek(0);
  wider.timing.kind = TimingKind::harmonic;
  back.tune(wider);
  back.accept(job, outcome);
  CHECK(back.known() == 0);

  timeline.accept(job, outcome);
  REQUIRE(timeline.known() == 2);
  CHECK(timeline.furthest() == outcome.state);
  CHECK(timeline.step(1) == outcome.step);
  timeline.accept(job, outcome);
  CHECK(timeline.known() == 2);
}

TEST_CASE("a place that is awaited is shown as soon as an outcome reaches it") {
  Timeline timeline = large_run(TimingKind::geodesic);
  timeline.extend_briefly(10);
  const Place net{Stage::timing, 0, 1};
  timeline.await(net);
  CHECK(timeline.position() == 1);  // until then the end of what is known
  CHECK(timeline.sought() == net);
  timeline.accept(timeline.next_job(), Timeline::work(timeline.next_job()));
  CHECK(timeline.place() == net);
  CHECK_FALSE(timeline.sought());
  timeline.await({Stage::done, 0, 0});
  run_briefly(timeline);
  CHECK(timeline.position() == timeline.known());
  timeline.await(net);  // known already
  CHECK(timeline.place() == net);
  CHECK_FALSE(timeline.sought());
}

TEST_CASE("a long step is not taken again on the way back and forth") {
  Timeline timeline = large_run(TimingKind::geodesic);
  timeline.extend_to_end();
  const std::size_t times = large_run(TimingKind::geodesic).input().mesh.positions.size();
  // Ends, four solves; the times; critical points and levels.
  for (const std::size_t at :
       {std::size_t{2}, std::size_t{3}, std::size_t{4}, std::size_t{5}, times + 6, times + 7}) {
    CAPTURE(at);
    timeline.seek(at);
    const auto kept = long_products(timeline.state());  // held, so that no other gets their places
    timeline.seek(0);
    timeline.seek(timeline.known());
    timeline.seek(at - 1);
    timeline.forward();
    CHECK(timeline.position() == at);
    CHECK(long_products(timeline.state()) == kept);
    timeline.seek(at - 1);
    timeline.seek(at + 1);
    timeline.back();
    CHECK(long_products(timeline.state()) == kept);
  }
  timeline.seek(times + 7);
  CHECK(timeline.state().timing.pointer() == timeline.furthest().timing.pointer());
}
