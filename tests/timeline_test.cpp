// The rewind contract, proved by scrubbing: the state at a position never depends on the way there.
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "tests/support/samples.h"
#include "tests/support/scrub.h"

using namespace knit;
using namespace test_support;

TEST_CASE("every position of the thesis sphere has one hash: forward, back, at random, on a tiny budget") {
  Timeline timeline(test_support::thesis_sphere(), test_support::thesis_parameters());
  const std::vector<std::uint64_t> hashes = hashes_forward(timeline);
  REQUIRE(hashes.size() > 20000);
  check_backward(timeline, hashes);
  check_at_random(timeline, hashes, 5000);

  Timeline tight(test_support::thesis_sphere(), test_support::thesis_parameters(), 4096);
  tight.extend_to_end();
  CHECK(tight.keyframe_bytes() <= 4096);
  check_at_random(tight, hashes, 150);
  CHECK(hashes_forward(tight) == hashes);
}

TEST_CASE("every position of a small run, backward on a tiny budget") {
  Timeline timeline(small_sphere(), small_parameters(), 3000);
  const std::vector<std::uint64_t> hashes = hashes_forward(timeline);
  CHECK(timeline.keyframe_bytes() <= 3000);
  check_backward(timeline, hashes);
}

TEST_CASE("neighbouring positions differ, so that the hashes above mean something") {
  Timeline timeline(small_sphere(), small_parameters());
  const std::vector<std::uint64_t> hashes = hashes_forward(timeline);
  for (std::size_t i = 1; i < hashes.size(); ++i) CHECK(hashes[i] != hashes[i - 1]);
}

TEST_CASE("a state equals a copy and another state of the same content") {
  Timeline a(small_sphere(), small_parameters());
  Timeline b(small_sphere(), small_parameters());
  for (const std::size_t position : {std::size_t{5}, std::size_t{600}, std::size_t{900}}) {
    a.extend_to_end();
    b.extend_to_end();
    a.seek(position);
    b.seek(position);
    const State copy = a.state();
    CHECK(copy == a.state());
    CHECK(a.state() == b.state());
    b.forward();
    CHECK_FALSE(a.state() == b.state());
  }
}

TEST_CASE("tuning any parameter anywhere gives the run as if it had been so from the start") {
  struct Change {
    const char* key;
    const char* value;
  };
  const Change change = GENERATE(
      Change{"epsilon", "0.1"}, Change{"epsilon", "0.02"}, Change{"stitch-width", "0.4"},
      Change{"cast-on", "8"}, Change{"close", "thesis"}, Change{"close", "none"}, Change{"placement", "even"},
      Change{"axis", "z"}, Change{"axis", "0.1,1,0"}, Change{"level-tolerance", "0.01"}, Change{"end", "70"},
      Change{"on-stall", "stop"}, Change{"last-anchor", "drop"}, Change{"resample", "off"});
  CAPTURE(change.key, change.value);
  Parameters tuned = small_parameters();
  const auto error = set_value(*find_parameter(change.key), tuned, change.value);
  REQUIRE_FALSE(error);
  for (const double part : {0.0, 0.3, 0.6, 0.85, 1.0}) {
    Timeline timeline(small_sphere(), small_parameters(), 20000);
    timeline.extend_to_end();
    timeline.seek(static_cast<std::size_t>(part * static_cast<double>(timeline.known())));
    timeline.tune(tuned);
    check_equals_fresh(timeline, tuned);
  }
}

TEST_CASE("tuning any parameter of the table equals a run from the start with it") {
  for (const ParameterInfo& info : parameter_table()) {
    CAPTURE(info.key);
    Parameters tuned = small_parameters();
    REQUIRE_FALSE(set_value(info, tuned, test_support::sample_of(info)));
    if (info.first_reader == Stage::import || fault_of(tuned, *small_sphere())) continue;
    Timeline timeline(small_sphere(), small_parameters(), 20000);
    timeline.extend_to_end();
    timeline.seek(timeline.known() / 2);
    timeline.tune(tuned);
    check_equals_fresh(timeline, tuned);
  }
}

TEST_CASE("tuning keeps the place: stage, row and item, or the nearest before it") {
  Timeline timeline(small_sphere(), small_parameters());
  timeline.extend_to_end();
  const Place place{Stage::rows, 6, 9};
  timeline.seek(timeline.position_of(place));
  REQUIRE(timeline.place() == place);

  Parameters wider = small_parameters();
  give_epsilon(wider, 0.2);
  timeline.tune(wider);
  timeline.extend_to_end();
  CHECK(timeline.place() == place);
  CHECK_FALSE(timeline.sought());

  // Along z this sphere has no rings: the run stops long before row 6.
  Parameters other_axis = wider;
  other_axis.timing.axis = Axis{AxisKind::z, {0.0, 1.0, 0.0}};
  timeline.tune(other_axis);
  timeline.extend_to_end();
  CHECK(timeline.place() <= place);
  CHECK(timeline.position() == timeline.known());
}

TEST_CASE("tuning at the start stays at the start, a place not reached yet is sought") {
  Timeline timeline(small_sphere(), small_parameters());
  Parameters tuned = small_parameters();
  tuned.rows.cast_on = 7;
  timeline.tune(tuned);
  timeline.extend_to_end();
  CHECK(timeline.position() == 0);

  timeline.seek(timeline.known());
  const Place end = timeline.place();
  give_epsilon(tuned, 0.12);
  timeline.tune(tuned);
  CHECK(timeline.sought());
  while (timeline.extend(100)) {
  }
  CHECK_FALSE(timeline.sought());
  CHECK(timeline.place() == end);
}

TEST_CASE("edit from here: the past stays to the bit, what follows is run with the new parameters") {
  Timeline plain(small_sphere(), small_parameters());
  plain.extend_to_end();
  const std::size_t at = plain.position_of({Stage::rows, 5, 4});

  Timeline timeline(small_sphere(), small_parameters());
  timeline.extend_to_end();
  timeline.seek(at);
  Parameters later = small_parameters();
  give_epsilon(later, 0.28);
  timeline.edit_from_here(later);
  timeline.extend_to_end();
  CHECK(timeline.position() == at);
  CHECK(timeline.parameters() == resolved(later, timeline.input()));
  CHECK(std::equal(plain.steps().begin(), plain.steps().begin() + static_cast<std::ptrdiff_t>(at),
                   timeline.steps().begin()));
  CHECK(plain.furthest().fabric.rows()[4] != timeline.furthest().fabric.rows()[4]);
  CHECK(plain.furthest().fabric.rows()[3] == timeline.furthest().fabric.rows()[3]);
  const std::vector<std::uint64_t> hashes = hashes_forward(timeline);
  check_backward(timeline, hashes);
  check_at_random(timeline, hashes, 200);

  REQUIRE(timeline.edits().size() == 1);
  timeline.remove_edit(0);
  timeline.extend_to_end();
  CHECK(timeline.steps() == plain.steps());
}

TEST_CASE("tuning counts in edits too, and edits keep their own change") {
  Timeline timeline(small_sphere(), small_parameters());
  timeline.extend_to_end();
  timeline.seek(timeline.position_of({Stage::rows, 5, 4}));
  Parameters edited = timeline.parameters();
  give_epsilon(edited, 0.1);
  timeline.edit_from_here(edited);
  timeline.extend_to_end();
  timeline.seek(timeline.known());
  Parameters tuned = timeline.parameters();
  tuned.rows.cast_on = 9;
  timeline.tune(tuned);
  timeline.extend_to_end();
  CHECK(timeline.base_parameters().rows.cast_on == 9);
  CHECK(timeline.base_parameters().epsilon() == 0.15);
  CHECK(timeline.parameters().rows.cast_on == 9);
  CHECK(timeline.parameters().epsilon() == 0.1);
  CHECK(timeline.furthest().fabric.rows()[0]->stitches.size() == 9);
}

TEST_CASE("a copy of the state does not grow with what is finished beyond a few pointers a row") {
  Timeline timeline(test_support::thesis_sphere(), test_support::thesis_parameters());
  timeline.extend_to_end();
  const std::size_t rows = timeline.furthest().fabric.rows().size();
  CHECK(copy_bytes(timeline.furthest()) <=
        sizeof(State) + rows * 4 * 2 * sizeof(void*) + sizeof(LiveLoop) + sizeof(StitchSpan));
  // In the middle of timing 8258 vertices: whole blocks are shared.
  timeline.seek(8000);
  CHECK(copy_bytes(timeline.state()) <=
        sizeof(State) + 8000 / 512 * 2 * sizeof(void*) + 512 * sizeof(double));
  // Finished products are one object in all copies.
  timeline.seek(timeline.known());
  const State copy = timeline.state();
  CHECK(copy.fabric.shared_row(11).pointer() == timeline.furthest().fabric.shared_row(11).pointer());
}

TEST_CASE("a step that was taken elsewhere is taken as if here, and a stale one is not taken at all") {
  Timeline here(small_sphere(), small_parameters());
  Timeline elsewhere(small_sphere(), small_parameters());
  here.extend_to_end();
  while (!elsewhere.complete() && elsewhere.known() < here.known()) {
    const Timeline::Job job = elsewhere.next_job();
    elsewhere.accept(job, Timeline::work(job));
  }
  CHECK(elsewhere.steps() == here.steps());
  CHECK(hash_of(elsewhere.furthest()) == hash_of(here.furthest()));

  elsewhere.tune(test_support::thesis_parameters());
  elsewhere.seek(0);
  const Timeline::Job job = elsewhere.next_job();
  const Timeline::Outcome outcome = Timeline::work(job);
  elsewhere.extend(1);
  const std::size_t known = elsewhere.known();
  elsewhere.accept(job, outcome);  // the run has gone on meanwhile
  CHECK(elsewhere.known() == known);
}
