// The rewind contract for rows from contours and for times solved for on the surface.
#include "knit/import/check.h"
#include "knit/insight/narrate.h"
#include "knit/mesh/branching_shapes.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/timing/heights.h"
#include "tests/support/promises.h"
#include "tests/support/scrub.h"

using namespace knit;
using namespace test_support;

namespace {

Parameters contours(TimingKind timing) {
  Parameters p = small_parameters();
  p.timing.kind = timing;
  p.rows.source = RowSource::contours;
  p.stitches.placement = PlacementPolicy::nearest;
  return p;
}

Parameters changed(Parameters p, const char* key, const char* value) {
  REQUIRE_FALSE(set_value(*find_parameter(key), p, value));
  return p;
}

// The position after the first step at or after `from` that is of the kind.
template <class Kind>
std::size_t position_after_step(const Timeline& timeline, const Place& from) {
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    const Step& step = timeline.step(i);
    if (step.place >= from && knit::is<Kind>(step)) return i + 1;
  }
  return timeline.known() + 1;
}

template <class Kind>
std::vector<Kind> steps_of(const Timeline& timeline) {
  std::vector<Kind> found;
  for (const Step& step : timeline.steps()) {
    if (const auto* what = knit::get_if<Kind>(step)) found.push_back(*what);
  }
  return found;
}

// A run edited just after row 6 was counted.
struct Edited {
  Timeline plain;
  Timeline timeline;
  std::size_t at;
};
Edited edited(const Parameters& base, const char* key, const char* value) {
  Edited run{Timeline(small_sphere(), base), Timeline(small_sphere(), base), 0};
  run.plain.extend_to_end();
  run.timeline.extend_to_end();
  REQUIRE(run.plain.furthest().finished());
  run.at = position_after_step<CountChosen>(run.plain, {Stage::rows, 6, 0});
  run.timeline.seek(run.at);
  run.timeline.edit_from_here(changed(base, key, value));
  run.timeline.extend_to_end();
  return run;
}

// Past and the row in the making stay to the bit; positions still have one hash.
void check_past(Edited& run) {
  CHECK(run.timeline.position() == run.at);
  CHECK(std::equal(run.plain.steps().begin(), run.plain.steps().begin() + static_cast<std::ptrdiff_t>(run.at),
                   run.timeline.steps().begin()));
  REQUIRE(run.timeline.furthest().finished());
  for (std::size_t row = 0; row < 6; ++row)
    CHECK(run.plain.furthest().fabric.rows()[row] == run.timeline.furthest().fabric.rows()[row]);
  const std::vector<std::uint64_t> hashes = hashes_forward(run.timeline);
  check_backward(run.timeline, hashes);
  check_at_random(run.timeline, hashes, 100);
}

}  // namespace

TEST_CASE("every position of a run from contours has one hash: forward, back, at random, on a tiny budget") {
  const TimingKind timing =
      GENERATE(TimingKind::linear, TimingKind::arc_length, TimingKind::geodesic, TimingKind::harmonic);
  CAPTURE(timing);
  Timeline timeline(small_sphere(), contours(timing));
  const std::vector<std::uint64_t> hashes = hashes_forward(timeline);
  REQUIRE(timeline.furthest().finished());
  for (std::size_t i = 1; i < hashes.size(); ++i) CHECK(hashes[i] != hashes[i - 1]);
  check_backward(timeline, hashes);
  check_at_random(timeline, hashes, 1000);

  Timeline tight(small_sphere(), contours(timing), 4096);
  tight.extend_to_end();
  CHECK(tight.keyframe_bytes() <= 4096);
  check_at_random(tight, hashes, 40);
  CHECK(hashes_forward(tight) == hashes);
}

TEST_CASE("a run from contours that stops has one hash a position, too") {
  Parameters p = contours(TimingKind::arc_length);
  give_width(p, 100.0);  // no curve is long enough
  Parameters too_fine = contours(TimingKind::linear);
  give_height(too_fine, 1e-7);
  const auto stops =
      GENERATE_COPY(std::pair(small_sphere(), p), std::pair(make_input(torus(24, 12, 0.7, 0.3)), too_fine));
  Timeline timeline(stops.first, stops.second);
  const std::vector<std::uint64_t> hashes = hashes_forward(timeline);
  REQUIRE(timeline.stop() != nullptr);
  check_backward(timeline, hashes);
  check_at_random(timeline, hashes, 100);
}

TEST_CASE("tuning a run from contours gives the run as if it had been so from the start") {
  struct Change {
    const char* key;
    const char* value;
  };
  const Change change =
      GENERATE(Change{"stitch-height", "0.15"}, Change{"stitch-width", "0.25"}, Change{"cast-on", "7"},
               Change{"timing", "linear"}, Change{"timing", "geodesic"}, Change{"timing", "harmonic"},
               Change{"rows", "rings"}, Change{"placement", "even"}, Change{"placement", "thesis"},
               Change{"start-direction", "1,0,0"}, Change{"stacking-penalty", "4"}, Change{"epsilon", "0.1"},
               Change{"axis", "x"}, Change{"end", "70"});
  CAPTURE(change.key, change.value);
  const Parameters before = contours(TimingKind::arc_length);
  for (const double part : {0.0, 0.45, 0.6, 0.8, 1.0}) {
    Timeline timeline(small_sphere(), before, 20000);
    timeline.extend_to_end();
    timeline.seek(static_cast<std::size_t>(part * static_cast<double>(timeline.known())));
    timeline.tune(changed(before, change.key, change.value));
    check_equals_fresh(timeline, changed(before, change.key, change.value));
    timeline.tune(before);
    check_equals_fresh(timeline, before);
  }
}

TEST_CASE("rings tuned to contours, and times of one kind to another") {
  for (const TimingKind timing : {TimingKind::arc_length, TimingKind::geodesic, TimingKind::harmonic}) {
    Timeline timeline(small_sphere(), small_parameters());
    timeline.extend_to_end();
    timeline.seek(timeline.position_of({Stage::rows, 6, 9}));
    timeline.tune(contours(timing));
    check_equals_fresh(timeline, contours(timing));
  }
}

TEST_CASE("a stitch height edited between two rows plans the rest anew and keeps what is knitted") {
  const Parameters base = contours(TimingKind::arc_length);
  Edited run = edited(base, "stitch-height", "0.1");
  check_past(run);
  const auto plans = steps_of<RowsReplanned>(run.timeline);
  REQUIRE(plans.size() == 1);
  const State& end = run.timeline.furthest();
  CHECK(plans[0].stitch_height == 0.1);
  CHECK(plans[0].rows == end.fabric.row_count() - 6);
  CHECK(end.fabric.rows().size() > run.plain.furthest().fabric.rows().size());
  const double total = end.timing->scale.total();
  const double spacing = end.tubes->tube(0).spacing;
  CHECK(spacing == Approx(0.1).epsilon(0.06));
  for (std::size_t row = 6; row < end.fabric.rows().size(); ++row) {
    CAPTURE(row);
    CHECK((end.fabric.rows()[row]->time - end.fabric.rows()[row - 1]->time) * total ==
          Approx(spacing).epsilon(0.03));
  }
}

TEST_CASE(
    "a stitch width edited between two rows changes the counts to come, and left to itself the height "
    "follows") {
  Parameters base = contours(TimingKind::arc_length);
  for (const double height : {0.216, 0.0}) {
    give_height(base, height);
    Edited run = edited(base, "stitch-width", "0.2");
    check_past(run);
    const auto plans = steps_of<RowsReplanned>(run.timeline);
    REQUIRE(plans.size() == 1);
    CHECK(plans.back().width == Approx(0.2));
    CHECK(plans.back().stitch_height == Approx(height > 0.0 ? 0.216 : 0.144));
    const auto counts = steps_of<CountChosen>(run.timeline);
    CHECK(counts[5].count == steps_of<CountChosen>(run.plain)[5].count);
    for (std::size_t row = 6; row < counts.size(); ++row) {
      CAPTURE(row);
      CHECK(counts[row].ideal == Approx(run.timeline.furthest().fabric.rows()[row]->ring->length / 0.2));
    }
    CHECK(run.timeline.furthest().fabric.rows()[7]->stitches.size() >
          run.plain.furthest().fabric.rows()[7]->stitches.size());
  }
}

TEST_CASE("an edited run from contours is the unedited one again when the edit is removed") {
  const auto [key, value] = GENERATE(std::pair{"stitch-height", "0.1"}, std::pair{"stitch-width", "0.2"},
                                     std::pair{"placement", "even"});
  Edited run = edited(contours(TimingKind::arc_length), key, value);
  CHECK(run.timeline.steps() != run.plain.steps());
  run.timeline.remove_edit(0);
  run.timeline.extend_to_end();
  CHECK(run.timeline.steps() == run.plain.steps());
  CHECK(run.timeline.furthest() == run.plain.furthest());
}

// Found by fuzzing. Six vertices of three edges each stand on the axis, one above the other.
TEST_CASE("contours: a surface pinched to a needle is knitted round it") {
  const std::vector<ProfilePoint> profile{{0.0, 0.0}, {1.0, 0.3}, {0.5, 1.0},
                                          {0.5, 2.0}, {1.0, 2.7}, {0.0, 3.0}};
  Mesh mesh = revolve("needle", profile, 6, false);
  double higher = 0.0;
  for (glm::dvec3& p : mesh.positions) {
    if (p.y < 0.9 || p.y > 2.1) continue;
    p = {0.0, p.y + higher, 0.0};
    higher += 0.01;
  }
  REQUIRE(check(mesh).fit());
  Parameters parameters;
  parameters.rows.source = RowSource::contours;
  parameters.timing.kind = TimingKind::linear;
  give_width(parameters, 0.2);
  for (const double height : {0.5, 0.2, 0.1, 0.05}) {
    CAPTURE(height);
    give_height(parameters, height);
    Timeline timeline(make_input(mesh), parameters);
    timeline.extend_to_end();
    CHECK(timeline.stop() == nullptr);
    CHECK(test_support::broken_promise(timeline.furthest()) == "");
  }
}

TEST_CASE("contours: a tube pressed flat is knitted there and back") {
  Mesh mesh;
  mesh.name = "pressed";
  mesh.positions = {
      {-0.25, 0.25, 0.25}, {0.25, -0.25, 0.25}, {0.25, 0.0, -0.25}, {0.0, 0.0, 0.25}, {0.25, 0.0, 0.25}};
  mesh.triangles = {{2, 1, 0}, {0, 2, 3}, {0, 3, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 1}};
  REQUIRE(check(mesh).fit());
  Parameters parameters;
  parameters.rows.source = RowSource::contours;
  parameters.timing.kind = TimingKind::arc_length;
  parameters.timing.start = 2;
  give_width(parameters, 0.1);
  for (const double height : {0.05, 0.03, 0.02}) {
    give_height(parameters, height);
    Timeline timeline(make_input(mesh), parameters);
    timeline.extend_to_end();
    CAPTURE(height);
    CHECK(timeline.furthest().finished());
  }
}

TEST_CASE(
    "another stitch size leaves the times' own graph and what smoothing needs as they are, to the same "
    "bits") {
  Parameters parameters = contours(TimingKind::linear);
  give_width(parameters, 0.15);
  const auto input = make_input(trousers(0.12));
  Timeline timeline(input, parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.furthest().finished());
  REQUIRE(steps_of<FieldSmoothed>(timeline).size() == 1);
  const std::size_t graph_found = position_after_step<GraphFound>(timeline, {});
  const auto graph_at = [&](std::size_t position) {
    timeline.seek(position);
    return std::get<TubesWork>(timeline.state().work).graph.pointer();
  };
  const auto raw = graph_at(graph_found);
  const auto smoothed = graph_at(graph_found + 1);
  give_width(parameters, 0.18);
  timeline.tune(parameters);
  CHECK(timeline.known() == graph_found);
  timeline.extend_to_end();
  CHECK(graph_at(graph_found) == raw);
  CHECK(graph_at(graph_found + 1) != smoothed);
  Timeline fresh(input, parameters);
  fresh.extend_to_end();
  CHECK(timeline.steps() == fresh.steps());
  CHECK(hash_of(timeline.furthest()) == hash_of(fresh.furthest()));
  parameters.tubes.smoothing = Smoothing::off;  // which the first step reads
  timeline.tune(parameters);
  CHECK(timeline.known() == graph_found - 1);
}
