// Long work beside the window: it comes to the same, nobody waits for it, and nothing stale counts.
#include "app/actions/background_work.h"
#include "app/session/document.h"
#include "app/session/jobs.h"

#include <algorithm>

#include "knit/mesh/branching_shapes.h"
#include "tests/support/beside.h"

using namespace app;
using knit::Stage;
using knit::TimingKind;
using namespace test_support;

namespace {

// What may take longer than a frame on a large mesh, told from what was done.
bool was_long(const knit::Step& step) {
  return knit::is<knit::FieldSolved>(step) || knit::is<knit::HeightsMeasured>(step) ||
         knit::is<knit::CriticalsFound>(step) || knit::is<knit::LevelsGrouped>(step);
}

std::size_t count_long(const knit::Timeline& timeline, std::size_t from) {
  const auto begin = timeline.steps().begin() + static_cast<std::ptrdiff_t>(from);
  return static_cast<std::size_t>(std::count_if(begin, timeline.steps().end(), was_long));
}

Session finished_beside(TimingKind timing = TimingKind::linear) {
  Session session = beside_session(large_parameters(timing));
  tick_until(session, run_is_complete);
  return session;
}

// Of a shape that branches, with some thousand triangles: another stitch size takes a moment.
knit::Parameters trousers_parameters(double width) {
  knit::Parameters parameters;
  parameters.timing.axis = {knit::AxisKind::y, {0.0, 1.0, 0.0}};
  parameters.rows.source = knit::RowSource::contours;
  parameters.stitches.placement = knit::PlacementPolicy::nearest;
  knit::give_width(parameters, width);
  return parameters;
}

std::uint64_t trousers_hash(const knit::Parameters& parameters) {
  knit::Timeline timeline(knit::make_input(knit::trousers(0.06)), parameters);
  timeline.extend_to_end();
  return knit::hash_of(timeline.furthest());
}

knit::Parameters settling_trousers(double width) {
  knit::Parameters parameters = trousers_parameters(width);
  parameters.settle.settling = knit::Settling::by_itself;
  return parameters;
}

Session finished_trousers(const knit::Parameters& parameters = trousers_parameters(0.1)) {
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  session.jobs->beside = true;
  const auto mesh = std::make_shared<const knit::Mesh>(knit::trousers(0.06));
  session.document = Document(knit::Timeline(knit::make_input(*mesh), parameters));
  session.document->original = mesh;
  session.document->defaults = parameters;
  apply(session, ToLast{});
  tick_until(session, run_is_complete);
  REQUIRE(session.document->timeline.state().finished());
  return session;
}

void tune_timing(Session& session, TimingKind timing) {
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.timing.kind = timing;
  apply(session, Tune{parameters});
}

}  // namespace

TEST_CASE(
    "beside a window a long run is worked out by ticks only, one long step at a time, to the same end") {
  const TimingKind timing = GENERATE(TimingKind::linear, TimingKind::arc_length, TimingKind::geodesic);
  CAPTURE(timing);
  Session session = beside_session(large_parameters(timing));
  std::size_t in_call = 0;
  tick_until(session, [&](Session& s) {
    const std::size_t known = s.document->timeline.known();
    const bool had_work = is_working(s);
    apply(s, PassTime{0.001});
    // At most the step that the worker had, and never one that nobody worked on beside.
    const std::size_t now = count_long(s.document->timeline, known);
    in_call += now > (had_work ? 1U : 0U) ? 1U : 0U;
    return s.document->timeline.complete();
  });
  CHECK(in_call == 0);
  const std::size_t taken = count_long(session.document->timeline, 0);
  CHECK(taken == (timing == TimingKind::geodesic ? 6 : timing == TimingKind::arc_length ? 3 : 2));
  CHECK(session.document->timeline.stop() == nullptr);
  CHECK(session.document->timeline.furthest().finished());
  CHECK(knit::hash_of(session.document->timeline.furthest()) == plain_hash(large_parameters(timing)));
  CHECK(session.document->run_ms > 0.0);
  CHECK_FALSE(is_working(session));
}

TEST_CASE("where each step is dear, a tick works out fewer") {
  Session session = small_session();
  session.jobs->beside = true;
  knit::Parameters geodesic = session.document->timeline.parameters();
  geodesic.rows.metric = knit::Metric::geodesic;
  apply(session, Tune{geodesic});
  CHECK(steps_of_slice(session.document->timeline) < 200);
  apply(session, PassTime{});
  CHECK(session.document->timeline.known() < 200);
  tick_until(session, run_is_complete);
  CHECK(steps_of_slice(session.document->timeline) > 10000);  // past the rows no step is
  CHECK(session.document->timeline.furthest().finished());
}

TEST_CASE("without a window nothing is left to a worker") {
  Session session = beside_session(large_parameters(TimingKind::geodesic));
  session.jobs->beside = false;
  apply(session, ToLast{});
  CHECK(session.document->timeline.state().finished());
  work_beside(session, 1.0);
  CHECK_FALSE(is_working(session));
  CHECK_FALSE(session.jobs->run.measuring);
  Session empty;
  empty.jobs->beside = true;
  work_beside(empty, 1.0);
  CHECK_FALSE(is_working(empty));
}

TEST_CASE("no action but the clock crosses a long step") {
  const Action action =
      GENERATE(Action(StepBy{Unit::item, 1}), Action(StepBy{Unit::row, 1}), Action(StepBy{Unit::stage, 1}),
               Action(SeekTo{1000000}), Action(SeekPlace{{Stage::rows, 5, 0}}), Action(ToLast{}),
               Action(SetPlaying{}));
  CAPTURE(action.index());
  Session session = beside_session(large_parameters(TimingKind::geodesic));
  for (int i = 0; i < 3; ++i) apply(session, action);
  CHECK(count_long(session.document->timeline, 0) == 0);
  CHECK(session.document->timeline.known() <= 1);  // the ends, before the first solve
}

TEST_CASE("what leads past a long step leads there once it is done") {
  struct Wish {
    Action action;
    knit::Place place;
  };
  const auto vertices = static_cast<std::int32_t>(large_ball()->positions.size());
  const knit::Place timed{Stage::timing, 0, vertices + 6};  // ends, four solves, times, criticals, levels
  const Wish wish = GENERATE_COPY(Wish{StepBy{Unit::item, 1}, {Stage::timing, 0, 1}},
                                  Wish{StepBy{Unit::row, 1}, timed}, Wish{StepBy{Unit::stage, 1}, timed},
                                  Wish{SeekPlace{{Stage::rows, 5, 2}}, {Stage::rows, 5, 2}});
  CAPTURE(wish.action.index());
  Session session = beside_session(large_parameters(TimingKind::geodesic));
  tick_until(session, is_working);
  REQUIRE(session.document->timeline.known() == 1);
  apply(session, StepBy{Unit::item, 1});
  REQUIRE(session.document->timeline.position() == 1);
  apply(session, wish.action);
  CHECK(session.document->timeline.position() == 1);
  CHECK(session.document->timeline.sought());
  tick_until(session, run_is_complete);
  CHECK(session.document->timeline.place() == wish.place);
  CHECK_FALSE(session.document->timeline.sought());
}

TEST_CASE("to the last leads to the end once the work is done") {
  Session session = beside_session(large_parameters(TimingKind::geodesic));
  apply(session, ToLast{});
  tick_until(session, run_is_complete);
  CHECK(session.document->timeline.position() == session.document->timeline.known());
  CHECK(session.document->timeline.state().finished());
}

TEST_CASE("cancelling goes back to the parameters before the change that asked for the work") {
  Session session = finished_beside(TimingKind::arc_length);
  const knit::Parameters before = session.document->timeline.parameters();
  const std::uint64_t end = knit::hash_of(session.document->timeline.furthest());
  apply(session, SeekPlace{{Stage::rows, 5, 2}});
  tune_timing(session, TimingKind::geodesic);
  tick_until(session, is_working);
  tune_timing(session, TimingKind::harmonic);  // changed again before the first was there
  apply(session, CancelWork{});
  CHECK_FALSE(is_working(session));
  CHECK(session.document->timeline.parameters() == before);
  tick_until(session, run_is_complete);
  CHECK(session.document->timeline.place() == knit::Place{Stage::rows, 5, 2});
  CHECK(knit::hash_of(session.document->timeline.furthest()) == end);
  apply(session, CancelWork{});  // nothing to cancel
  CHECK(session.document->timeline.parameters() == before);
  CHECK(session.document->timeline.complete());
}

TEST_CASE("work that is cancelled before anything was changed leaves the solves away") {
  Session session = beside_session(large_parameters(TimingKind::geodesic));
  tick_until(session, is_working);
  apply(session, CancelWork{});
  CHECK(session.document->timeline.parameters().timing.kind == TimingKind::linear);
  tick_until(session, run_is_complete);
  CHECK(knit::hash_of(session.document->timeline.furthest()) ==
        plain_hash(large_parameters(TimingKind::linear)));
}

TEST_CASE("work that an edit asked for is cancelled back to before the edit") {
  Session session = finished_beside();
  tune_timing(session, TimingKind::arc_length);
  tick_until(session, run_is_complete);
  apply(session, SeekPlace{{Stage::timing, 0, 1}});
  const knit::Parameters before = session.document->timeline.parameters();
  knit::Parameters edited = before;
  edited.timing.end = 17;
  apply(session, SeekTo{0});
  apply(session, EditFromHere{edited});
  tick_until(session, is_working);
  apply(session, CancelWork{});
  CHECK(session.document->timeline.parameters() == before);
}

TEST_CASE("a result that comes after a change does not count") {
  Session session = beside_session(large_parameters(TimingKind::geodesic));
  tick_until(session, [](Session& s) { return is_working(s) && s.document->timeline.known() == 2; });
  while (!session.jobs->run.long_step->work.ready())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  tune_timing(session, TimingKind::harmonic);
  apply(session, PassTime{0.001});
  CHECK(session.document->timeline.known() <= 1);
  tick_until(session, run_is_complete);
  CHECK(knit::hash_of(session.document->timeline.furthest()) ==
        plain_hash(large_parameters(TimingKind::harmonic)));
}

TEST_CASE("another mesh opened meanwhile is not touched by the work on the first") {
  Session session = beside_session(large_parameters(TimingKind::geodesic));
  tick_until(session, [](Session& s) { return is_working(s) && s.document->timeline.known() == 2; });
  apply(session, OpenExample{"egg"});
  CHECK_FALSE(is_working(session));
  tick_until(session, is_measured);
  Session plain = example_session("egg");
  apply(plain, ToLast{});
  CHECK(knit::hash_of(session.document->timeline.furthest()) ==
        knit::hash_of(plain.document->timeline.state()));
  CHECK(session.document->closeness->knit_area == closeness_now(*plain.document)->knit_area);
}

TEST_CASE("while another stitch size is worked out the picture of before stays, whole") {
  Session session = finished_trousers();
  const knit::Timeline& timeline = session.document->timeline;
  const std::uint64_t before = knit::hash_of(timeline.state());
  const std::uint64_t after = trousers_hash(trousers_parameters(0.12));
  REQUIRE(before != after);
  apply(session, Tune{trousers_parameters(0.12)});
  CHECK(timeline.parameters().stitch.width == 0.12);  // as the knob says
  CHECK(knobs_of(timeline).base.stitch.width == 0.12);
  CHECK_FALSE(timeline.complete());
  std::size_t neither = 0;
  tick_until(session, [&](Session&) {
    const std::uint64_t shown = knit::hash_of(timeline.state());
    neither += shown != before && shown != after ? 1U : 0U;
    return timeline.complete();
  });
  CHECK(neither == 0);
  CHECK(knit::hash_of(timeline.furthest()) == after);
  CHECK(timeline.base_parameters().stitch.width == 0.12);
  CHECK_FALSE(session.jobs->run.awaited);
  apply(session, Undo{});
  tick_until(session, run_is_complete);
  CHECK(knit::hash_of(timeline.furthest()) == before);
}

TEST_CASE("a knob that is dragged on is followed by the picture of a moment ago") {
  Session session = finished_trousers();
  const knit::Timeline& timeline = session.document->timeline;
  apply(session, Tune{trousers_parameters(0.12), true});
  apply(session, PassTime{0.01});
  REQUIRE(session.jobs->run.awaited);
  while (!session.jobs->run.awaited->work.ready()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  apply(session, Tune{trousers_parameters(0.13), true});
  apply(session, PassTime{0.01});
  CHECK(timeline.base_parameters().stitch.width == 0.12);
  CHECK(knit::hash_of(timeline.furthest()) == trousers_hash(trousers_parameters(0.12)));
  CHECK(timeline.parameters().stitch.width == 0.13);
  CHECK_FALSE(timeline.complete());
  tick_until(session, run_is_complete);
  CHECK(knit::hash_of(timeline.furthest()) == trousers_hash(trousers_parameters(0.13)));
  CHECK(session.document->changes.undo.size() == 1);  // one drag
}

TEST_CASE(
    "where stitches settle, the picture of before stays until all are placed anew, and then they settle") {
  Session session = finished_trousers(settling_trousers(0.1));
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Place end = timeline.place();
  const std::uint64_t before = knit::hash_of(timeline.state());
  const std::uint64_t after = trousers_hash(settling_trousers(0.12));
  apply(session, Tune{settling_trousers(0.12)});
  std::size_t early = 0, unsettled = 0, iterations = 0;
  tick_until(session, [&](Session&) {
    const bool is_of_before = timeline.is_waiting();
    if (is_of_before) early += knit::hash_of(timeline.state()) == before ? 0U : 1U;
    const bool has_all =
        timeline.state().fabric.strips().size() == timeline.furthest().fabric.strips().size();
    unsettled += timeline.state().stage() >= Stage::settle && has_all ? 0U : 1U;
    const auto* work = std::get_if<knit::SettleWork>(&timeline.state().work);
    if (work != nullptr && !is_of_before)
      iterations = std::max<std::size_t>(iterations, static_cast<std::size_t>(work->iteration));
    return timeline.complete();
  });
  CHECK(early == 0);
  CHECK(unsettled == 0);
  CHECK(iterations >= 3);  // it is seen to settle, though the end is what is wanted
  CHECK(timeline.place() <= end);
  CHECK(timeline.state().finished());
  CHECK(knit::hash_of(timeline.furthest()) == after);
}

TEST_CASE("a knob that is dragged on while stitches settle makes them settle no further") {
  Session session = finished_trousers(settling_trousers(0.1));
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Parameters before = timeline.parameters();
  apply(session, Tune{settling_trousers(0.12), true});
  tick_until(session, is_working);
  REQUIRE(std::holds_alternative<knit::SettleWork>(timeline.furthest().work));
  const std::size_t known = timeline.known();
  apply(session, Tune{settling_trousers(0.13), true});
  CHECK(timeline.is_waiting());
  apply(session, PassTime{0.01});
  CHECK_FALSE(is_working(session));  // given up
  CHECK(session.jobs->run.awaited);
  CHECK(timeline.known() == known);
  CHECK(timeline.base_parameters().stitch.width == 0.12);  // shown, as far as it had settled
  tick_until(session, [&](Session&) { return !timeline.is_waiting(); });
  apply(session, CancelWork{});  // all of the drag
  CHECK(timeline.parameters() == before);
  apply(session, Redo{});
  CHECK(timeline.parameters() == before);

  apply(session, Tune{settling_trousers(0.13), true});
  tick_until(session, run_is_complete);
  CHECK(knit::hash_of(timeline.furthest()) == trousers_hash(settling_trousers(0.13)));
}

TEST_CASE("settling that nobody asked for otherwise is cancelled to stitches as they are placed") {
  Session session = finished_trousers(settling_trousers(0.1));
  session.document->timeline.tune(settling_trousers(0.11));
  session.document->before_change.reset();
  tick_until(session, is_working);
  REQUIRE(session.document->timeline.whole());
  apply(session, CancelWork{});
  CHECK_FALSE(is_working(session));
  CHECK(session.document->timeline.parameters().settle.settling == knit::Settling::off);
  tick_until(session, run_is_complete);
  CHECK(knit::hash_of(session.document->timeline.furthest()) == trousers_hash(trousers_parameters(0.11)));
}

TEST_CASE("what is worked out beside says how far it is") {
  Session session = beside_session(large_parameters(TimingKind::geodesic));
  double greatest = 0.0;
  tick_until(session, [&](Session& s) {
    if (s.jobs->run.long_step) greatest = std::max(greatest, s.jobs->run.long_step->work.share());
    return s.document->timeline.complete();
  });
  CHECK(greatest > 0.0);
  CHECK(greatest <= 1.0);
}

TEST_CASE("a run that is waited for is given up with what asked for it") {
  Session session = finished_trousers();
  const std::uint64_t before = knit::hash_of(session.document->timeline.state());
  apply(session, Tune{trousers_parameters(0.12)});
  apply(session, PassTime{0.01});
  REQUIRE(session.jobs->run.awaited);
  apply(session, Undo{});
  apply(session, PassTime{0.01});
  CHECK(session.document->timeline.complete());
  CHECK(knit::hash_of(session.document->timeline.state()) == before);
  CHECK_FALSE(session.jobs->run.awaited);

  apply(session, Tune{trousers_parameters(0.12)});
  apply(session, PassTime{0.01});
  knit::Parameters other = trousers_parameters(0.12);
  other.timing.kind = TimingKind::arc_length;
  apply(session, Tune{other});
  CHECK_FALSE(session.document->timeline.is_waiting());
  tick_until(session, run_is_complete);
  CHECK(knit::hash_of(session.document->timeline.furthest()) == trousers_hash(other));

  knit::give_width(other, 0.14);
  apply(session, Tune{other});
  apply(session, PassTime{0.01});
  REQUIRE(session.jobs->run.awaited);
  apply(session, OpenExample{"egg"});
  CHECK_FALSE(session.jobs->run.awaited);
}

TEST_CASE("rows from rings, and small meshes, follow the knob at once") {
  Session session = small_session();
  session.jobs->beside = true;
  tick_until(session, run_is_complete);
  for (const knit::RowSource source : {knit::RowSource::rings, knit::RowSource::contours}) {
    knit::Parameters parameters = session.document->timeline.parameters();
    parameters.rows.source = source;
    apply(session, Tune{parameters});
    tick_until(session, run_is_complete);
    knit::give_width(parameters, 1.1 * parameters.stitch.width);
    apply(session, Tune{parameters});
    CHECK_FALSE(session.document->timeline.is_waiting());
    apply(session, PassTime{0.0});
    CHECK(session.document->timeline.complete());
  }
}
