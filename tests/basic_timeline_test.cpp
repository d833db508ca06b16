// The recorder knows no pipeline: the rewind contract holds for another machine, a counter that rises, then falls.
#include <compare>
#include <random>

#include "knit/model/bug.h"
#include "knit/run/basic_timeline_impl.h"
#include "tests/support/catch.h"

namespace {

struct Counter {
  struct Input {
    int top;
  };
  struct Parameters {
    int rise = 1, fall = 1;
    friend bool operator==(const Parameters&, const Parameters&) = default;
  };
  struct Place {
    int stage = 0, item = 0;  // rising, falling, finished
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  struct State {
    Place next;
    int count = 0;
    std::vector<int> seen;
    friend bool operator==(const State&, const State&) = default;
  };
  struct Step {
    Place place;
    int count;
    friend bool operator==(const Step&, const Step&) = default;
  };

  static Step advance(const Input& input, const Parameters& parameters, State& state,
                      const knit::Heard& heard) {
    knit::hear(heard, 0.5);
    const Place place = state.next;
    if (parameters.rise == 0 && place.stage == 0) return {place, -1};
    state.count += place.stage == 0 ? parameters.rise : -parameters.fall;
    state.seen.push_back(state.count);
    const bool turns = place.stage == 0 ? state.count >= input.top : state.count <= 0;
    state.next = turns ? Place{place.stage + 1, 0} : Place{place.stage, place.item + 1};
    return {place, state.count};
  }
  static bool finished(const State& state) { return state.next.stage == 2; }
  // Once it has fallen ten times.
  static bool is_whole(const State& state) { return state.next >= Place{1, 10}; }
  static Place next(const State& state) { return state.next; }
  static Place place_of(const Step& step) { return step.place; }
  static bool is_stop(const Step& step) { return step.count == -1 && step.place.stage == 0; }
  static bool sweeps(const Input& input, const Parameters& parameters, const State& state) {
    return is_long(input, parameters, state);
  }
  static bool is_long(const Input& /*input*/, const Parameters& /*parameters*/, const State& state) {
    return state.next == Place{1, 0} || state.next == Place{1, 20};
  }
  static Place first_reader(const Parameters& before, const Parameters& after) {
    if (before.rise != after.rise) return {0, 0};
    return before.fall != after.fall ? Place{1, 0} : Place{3, 0};
  }
  static Parameters resolved(const Parameters& parameters, const Input& /*input*/) { return parameters; }
  static Parameters with_change(const Parameters& kept, const Parameters& before, const Parameters& after) {
    return {before.rise == after.rise ? kept.rise : after.rise,
            before.fall == after.fall ? kept.fall : after.fall};
  }
  static std::size_t copy_bytes(const State& state) {
    return sizeof(State) + state.seen.size() * sizeof(int);
  }
  static bool enters(const Place& from, const Place& to) { return from.stage != to.stage; }
  static bool worth_keeping(const State& state) { return state.next.item == 0; }
  static std::size_t steps_expected(const Input& input) { return static_cast<std::size_t>(input.top); }
};

using Recorder = knit::BasicTimeline<Counter>;

constexpr std::size_t tiny = 2000;

Recorder recorder(const Counter::Parameters& parameters, std::size_t budget = tiny) {
  return {std::make_shared<const Counter::Input>(Counter::Input{400}), parameters, budget};
}

std::vector<Counter::State> states_of(Recorder& run) {
  run.seek(0);
  std::vector<Counter::State> states{run.state()};
  while (run.forward()) states.push_back(run.state());
  return states;
}

void check_scrubbing(Recorder& run, const std::vector<Counter::State>& states) {
  REQUIRE(run.known() + 1 == states.size());
  run.seek(run.known());
  std::size_t wrong = 0;
  while (run.back()) wrong += run.state() == states[run.position()] ? 0U : 1U;
  std::mt19937 random(20260101);
  for (int i = 0; i < 200; ++i) {
    run.seek(random() % states.size());
    wrong += run.state() == states[run.position()] ? 0U : 1U;
  }
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("another machine's run has one state a position: forward, back, at random, on a tiny budget") {
  Recorder wide = recorder({1, 3}, Recorder::default_budget_bytes);
  const std::vector<Counter::State> states = states_of(wide);
  REQUIRE(states.size() == 1 + 400 + 134);
  check_scrubbing(wide, states);
  Recorder tight = recorder({1, 3});
  CHECK(states_of(tight) == states);
  CHECK(tight.keyframe_bytes() <= tiny);
  check_scrubbing(tight, states);
}

TEST_CASE("another machine's run, tuned, is as if it had been so from the start, and shows the same place") {
  const std::vector<Counter::Parameters> changes{{2, 3}, {1, 5}, {7, 1}};
  for (const Counter::Parameters& changed : changes) {
    for (const std::size_t at : {std::size_t{0}, std::size_t{150}, std::size_t{401}, std::size_t{430}}) {
      CAPTURE(changed.rise, changed.fall, at);
      Recorder run = recorder({1, 3});
      run.extend_to_end();
      run.seek(at);
      const Counter::Place place = run.place();
      run.tune(changed);
      run.extend_to_end();
      CHECK(run.place() <= place);
      CHECK(run.position() == (at == 0 ? 0 : run.position_of(place)));
      Recorder fresh = recorder(changed);
      const std::vector<Counter::State> states = states_of(fresh);
      check_scrubbing(run, states);
      CHECK(run.steps() == fresh.steps());
    }
  }
}

TEST_CASE("another machine's run, edited, keeps its past, and the edit counts when the run is tuned") {
  Recorder run = recorder({1, 3});
  run.extend_to_end();
  const std::vector<Counter::Step> before = run.steps();
  run.seek(100);
  run.edit_from_here({10, 3});
  run.extend_to_end();
  CHECK(run.position() == 100);
  CHECK(std::equal(before.begin(), before.begin() + 100, run.steps().begin()));
  CHECK(run.known() == 100 + 30 + 134);
  const std::vector<Counter::State> states = states_of(run);
  check_scrubbing(run, states);
  run.seek(50);
  run.tune({1, 100});
  run.extend_to_end();
  CHECK(run.known() == 100 + 30 + 4);
  CHECK(run.edits().size() == 1);
  run.remove_edit(0);
  run.extend_to_end();
  CHECK(run.known() == 400 + 4);
}

TEST_CASE(
    "another machine's run, tuned again and again on a budget that holds no keyframe, is still gone "
    "through") {
  Recorder run = recorder({1, 3}, 100);
  for (int i = 0; i < 40; ++i) {
    run.tune({1, i % 2 == 0 ? 40 : 50});
    run.extend_to_end();
  }
  Recorder fresh = recorder({1, 50});
  CHECK(states_of(run) == states_of(fresh));
}

TEST_CASE("another machine's long step can be taken elsewhere, and its stop ends the run") {
  Recorder run = recorder({1, 3});
  while (run.extend_briefly(1000) && run.next_is_long())
    run.accept(run.next_job(), Recorder::work(run.next_job()));
  Recorder plain = recorder({1, 3});
  plain.extend_to_end();
  CHECK(run.steps() == plain.steps());
  run.tune({0, 3});
  run.extend_to_end();
  REQUIRE(run.stop() != nullptr);
  CHECK(run.known() == 0);
}

TEST_CASE("another machine's run stays, whole, until the one that is waited for takes over") {
  Recorder run = recorder({1, 3});
  run.extend_to_end();
  run.seek(430);
  const Recorder before = run;
  run.tune_beside({1, 5});
  CHECK(run.is_waiting());
  CHECK_FALSE(run.complete());
  CHECK(run.extend_briefly(1000));  // there is more to come, elsewhere
  CHECK(run.steps() == before.steps());
  CHECK(run.state() == before.state());
  CHECK(run.parameters() == Counter::Parameters{1, 5});
  CHECK(run.wished_parameters() == Counter::Parameters{1, 5});
  CHECK(run.base_parameters() == Counter::Parameters{1, 3});
  CHECK(run.back());
  CHECK(run.position() == 429);

  Recorder other = run.awaited_run();
  CHECK(other.known() == 400);        // what reads the change is still to come
  CHECK_FALSE(run.take_over(other));  // it is not whole
  other.extend_to_end();
  Recorder fresh = recorder({1, 5});
  const std::vector<Counter::State> states = states_of(fresh);
  CHECK(other.steps() == fresh.steps());
  CHECK(run.take_over(other));
  CHECK(run.complete());
  CHECK(run.position() == 429);
  check_scrubbing(run, states);
  CHECK_FALSE(run.take_over(other));  // none is waited for
}

TEST_CASE("a run of an earlier wish is shown, and the wish stays, but one that is taken back is none") {
  Recorder run = recorder({1, 3});
  run.extend_to_end();
  run.seek(0);
  run.tune_beside({1, 5});
  Recorder first = run.awaited_run();
  first.extend_to_end();
  run.tune_beside({1, 7});
  CHECK(run.take_over(first));
  CHECK(run.base_parameters() == Counter::Parameters{1, 5});
  CHECK(run.wished_parameters() == Counter::Parameters{1, 7});
  CHECK(run.is_waiting());
  CHECK(run.position() == 0);
  run.tune_beside({1, 5});
  CHECK_FALSE(run.is_waiting());
  CHECK(run.complete());
}

TEST_CASE("what else changes parameters, or works the run out, makes the wish the run first") {
  for (const int how : {0, 1, 2, 3}) {
    CAPTURE(how);
    Recorder run = recorder({1, 3});
    run.extend_to_end();
    run.seek(100);
    run.tune_beside({1, 5});
    Recorder late = run.awaited_run();
    late.extend_to_end();
    if (how == 0) run.tune({2, 5});
    if (how == 1) run.edit_from_here({2, 5});
    if (how == 2) run.set_knobs({1, 3}, {});
    if (how == 3) run.extend(1);
    CHECK_FALSE(run.is_waiting());
    CHECK_FALSE(run.take_over(late));
    run.extend_to_end();
    Recorder fresh =
        recorder(how == 0 ? Counter::Parameters{2, 5} : Counter::Parameters{1, how == 2 ? 3 : 5});
    fresh.extend_to_end();
    if (how == 1) {
      fresh.seek(100);
      fresh.edit_from_here({2, 5});
      fresh.extend_to_end();
    }
    CHECK(run.steps() == fresh.steps());
    CHECK(run.edits() == fresh.edits());
  }
}

TEST_CASE("another machine's run is heard while it is worked out, and broken off between two steps") {
  struct BrokenOff {};
  Recorder run = recorder({1, 3});
  run.extend_to({1, 4});
  CHECK(run.known() == 400 + 4);
  CHECK_FALSE(run.whole());
  run.extend_to({1, 2});  // behind it already
  CHECK(run.known() == 400 + 4);
  std::size_t calls = 0;
  const knit::Heard stopping = [&](double /*share*/) {
    if (++calls == 12) throw BrokenOff{};
  };
  CHECK_THROWS_AS(run.extend_to({2, 0}, stopping), BrokenOff);
  CHECK(run.known() > 400 + 4);
  CHECK(run.known() < 400 + 4 + 12);
  CHECK_THROWS_AS(Recorder::work(run.next_job(), [](double /*share*/) { throw BrokenOff{}; }), BrokenOff);
  Recorder fresh = recorder({1, 3});
  const std::vector<Counter::State> states = states_of(fresh);
  run.extend_to({2, 0});
  run.extend_to_end();
  check_scrubbing(run, states);
}

TEST_CASE(
    "another machine's run that is whole but not complete waits too, and takes over as soon as it is whole") {
  Recorder run = recorder({1, 3});
  run.extend_to({1, 20});
  run.await({2, 0});
  REQUIRE(run.position() == 420);
  REQUIRE(run.next_is_long());
  run.tune_beside({1, 5});
  CHECK(run.is_waiting());
  CHECK(run.extend_briefly(1000));  // it does not go on
  CHECK(run.known() == 420);
  CHECK_FALSE(run.next_is_long());
  CHECK_FALSE(run.forward());
  run.await({2, 0});

  Recorder other = run.awaited_run();
  other.extend_to({1, 9});
  CHECK_FALSE(run.take_over(other));  // not whole yet
  other.extend_to({1, 10});
  CHECK(run.take_over(other));
  CHECK_FALSE(run.is_waiting());
  CHECK_FALSE(run.complete());
  CHECK(run.position() == 410);
  CHECK(run.sought() == Counter::Place{2, 0});
  run.extend_to_end();
  CHECK(run.position() == 480);
  Recorder fresh = recorder({1, 5});
  const std::vector<Counter::State> states = states_of(fresh);
  check_scrubbing(run, states);

  Recorder rising = recorder({1, 3});
  rising.extend_to({1, 5});
  rising.tune_beside({1, 5});  // nothing that could stay
  CHECK_FALSE(rising.is_waiting());
  CHECK(rising.known() == 400);
}

TEST_CASE("while a place is sought, what another machine's long steps come to is shown") {
  Recorder run = recorder({1, 3});
  run.extend_briefly(1000);
  run.await({1, 5});
  REQUIRE(run.position() == 400);
  run.accept(run.next_job(), Recorder::work(run.next_job()));
  CHECK(run.position() == 401);
  CHECK(run.state() == run.furthest());
  CHECK(run.sought() == Counter::Place{1, 5});
  run.extend(10);
  CHECK(run.place() == Counter::Place{1, 5});
  run.seek(100);  // nothing is sought: the place stays
  run.extend_to_end();
  CHECK(run.position() == 100);
}
