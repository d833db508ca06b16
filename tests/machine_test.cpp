// The machine's steps: every kind is met, places rise, stops leave the state alone, and edits in odd places
// are survived.
#include "knit/run/machine.h"

#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <set>

#include "knit/insight/narrate.h"
#include "knit/insight/step_fields.h"
#include "knit/model/bug.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/measures.h"
#include "tests/support/bent_ellipsoid.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;
using test_support::small_parameters;
using test_support::small_sphere;

namespace {

Timeline run(std::shared_ptr<const Input> input, const Parameters& parameters) {
  Timeline timeline(std::move(input), parameters);
  timeline.extend_to_end();
  return timeline;
}

}  // namespace

TEST_CASE("places rise from step to step, and every stage is met in order") {
  const Timeline timeline = run(small_sphere(), small_parameters());
  REQUIRE(timeline.stop() == nullptr);
  std::set<Stage> stages;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    if (i > 0) CHECK(timeline.step(i - 1).place < timeline.step(i).place);
    stages.insert(timeline.step(i).place.stage);
  }
  CHECK(stages.size() + 3 == machine_stages.size());  // rings make no tubes, and stay on the mesh
}

TEST_CASE("every kind of step is met, and each has a sentence, a name and numbers") {
  std::map<std::string, std::string> sentences;
  const auto collect = [&](const Timeline& timeline, const Parameters& parameters) {
    for (const Step& step : timeline.steps()) {
      sentences.emplace(kind_name(step), narrate(step, parameters));
      CHECK_FALSE(fields_of(step).empty());
    }
    if (timeline.stop() != nullptr)
      sentences.emplace(kind_name(*timeline.stop()), narrate(*timeline.stop(), parameters));
  };
  collect(run(small_sphere(), small_parameters()), small_parameters());
  Parameters rough = small_parameters();
  give_epsilon(rough, 0.01);
  rough.rows.cast_on = 3;
  collect(run(small_sphere(), rough), rough);
  Parameters strict = rough;
  strict.rows.on_stall = OnStall::stop;
  collect(run(small_sphere(), strict), strict);
  Parameters contours = small_parameters();
  contours.timing.kind = TimingKind::arc_length;
  contours.rows.source = RowSource::contours;
  contours.stitches.placement = PlacementPolicy::nearest;
  contours.settle.settling = Settling::on;
  contours.relax.relaxing = Relaxing::on;
  collect(run(small_sphere(), contours), contours);
  contours.settle.settling = Settling::off;
  contours.relax.relaxing = Relaxing::off;
  Parameters rhythm = contours;
  rhythm.rhythm.counts = CountPlanning::rhythm;
  collect(run(small_sphere(), rhythm), rhythm);
  contours.timing.kind = TimingKind::geodesic;
  collect(run(small_sphere(), contours), contours);
  Parameters chosen = small_parameters();
  chosen.timing.kind = TimingKind::by_itself;
  chosen.rows.source = RowSource::by_itself;
  chosen.stitches.placement = PlacementPolicy::by_itself;
  collect(run(small_sphere(), chosen), chosen);
  // Standing, a torus parts and meets again; of stitches as wide as its arms they are left out.
  contours.timing = {};
  contours.timing.axis.kind = AxisKind::x;
  const auto standing = make_input(torus(48, 24, 1.0, 0.4));
  collect(run(standing, contours), contours);
  Parameters wide = contours;
  give_width(wide, 1.2);
  collect(run(standing, wide), wide);
  Timeline edited = run(small_sphere(), contours);
  edited.seek(edited.position_of({Stage::rows, 4, 0}));
  Parameters lower = contours;
  give_height(lower, 0.1);
  edited.edit_from_here(lower);
  edited.extend_to_end();
  collect(edited, lower);
  const auto bent = test_support::bent_ellipsoid(1.8);
  const Parameters with_short_rows = test_support::parameters_of(*bent, ShortRows::automatic);
  collect(run(bent, with_short_rows), with_short_rows);
  const Step dropped{{Stage::rows, 7, 3}, PairDropped{3, 9, DropReason{}}};
  sentences.emplace(kind_name(dropped), narrate(dropped, with_short_rows));
  CHECK_FALSE(fields_of(dropped).empty());
  CHECK(sentences.size() == event_count);
  for (const auto& [kind, sentence] : sentences) {
    CAPTURE(kind, sentence);
    CHECK(sentence.size() > 20);
    CHECK(sentence.back() == '.');
  }
}

TEST_CASE("sentences say what a person needs, with the numbers") {
  const Parameters p = test_support::thesis_parameters();
  const Step near{{Stage::rows, 7, 3}, CandidateMeasured{800, 812, 4, 5, 3, Verdict::too_near, 0.0483}};
  CHECK(narrate(near, p) ==
        "Row 7: vertex 812 is 0.0483 from stitch 3 (vertex 800): too near, the band begins at 0.05.");
  const Step stall{{Stage::rows, 7, 130}, Stopped{StopReason::stall, {}, 7, 3, 0, 800, 0.21, 0.1}};
  CHECK(narrate(stall, p) ==
        "Row 7: nothing within [0.05, 0.15] of stitch 3 (vertex 800); nearest 0.21. Widen epsilon, change "
        "the stitch "
        "width, or continue on a stall.");
}

TEST_CASE("a stop leaves the state as it was, and comes again") {
  Parameters strict = small_parameters();
  give_epsilon(strict, 0.01);
  strict.rows.on_stall = OnStall::stop;
  const auto input = small_sphere();
  Timeline timeline = run(input, strict);
  REQUIRE(timeline.stop() != nullptr);
  const auto& stopped = *knit::get_if<Stopped>(*timeline.stop());
  CHECK(stopped.reason == StopReason::stall);
  CHECK(stopped.time == timeline.furthest().timing->levels.times[static_cast<std::size_t>(stopped.level)]);
  State state = timeline.furthest();
  const std::uint64_t before = hash_of(state);
  const Step again = advance(*input, strict, state);
  CHECK(again == *timeline.stop());
  CHECK(hash_of(state) == before);
  CHECK(timeline.furthest().fabric.rows().size() >= 1);
}

TEST_CASE("a stall is logged each time it is bridged") {
  Parameters rough = small_parameters();
  give_epsilon(rough, 0.01);
  const Timeline timeline = run(small_sphere(), rough);
  REQUIRE(timeline.stop() == nullptr);
  std::size_t too_far = 0;
  std::size_t missed = 0;
  std::size_t at_ends = 0;  // of rings: too far was the first stitch, not a candidate
  for (const Step& step : timeline.steps()) {
    const auto* measured = knit::get_if<CandidateMeasured>(step);
    too_far += measured != nullptr && measured->verdict == Verdict::too_far ? 1U : 0U;
    if (!knit::is<BandMissed>(step)) continue;
    ++missed;
    at_ends += knit::is<CandidateMeasured>(*(&step - 1)) &&
                       knit::get_if<CandidateMeasured>(*(&step - 1))->verdict != Verdict::too_far
                   ? 1U
                   : 0U;
    CHECK(is_unusual(step, rough));
  }
  CHECK(missed > 0);
  CHECK(missed == too_far + at_ends);
}

TEST_CASE(
    "no row more than doubles or halves, where that is forbidden to repair, the run stops and names the "
    "row") {
  Parameters narrow = small_parameters();
  narrow.rows.cast_on = 3;
  const Timeline repaired = run(small_sphere(), narrow);
  REQUIRE(repaired.stop() == nullptr);
  const std::vector<int> sizes = test_support::row_sizes(repaired.furthest());
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    CHECK(sizes[i] <= 2 * sizes[i - 1]);
    CHECK(2 * sizes[i] >= sizes[i - 1]);
  }
  narrow.rows.resample = Resample::off;
  const Timeline stopped = run(small_sphere(), narrow);
  REQUIRE(stopped.stop() != nullptr);
  CHECK(narrate(*stopped.stop(), narrow).find("Row 2: ") == 0);
  CHECK(narrate(*stopped.stop(), narrow).find("cannot follow 3") != std::string::npos);
}

TEST_CASE(
    "faces look outward, and the knit mesh is a tube: each edge in at most two faces, two boundary loops") {
  const Timeline timeline = run(small_sphere(), small_parameters());
  const State& state = timeline.furthest();
  const KnittingPath path(state.fabric);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
  for (const auto& strip : state.fabric.strips()) {
    for (const Face& face : strip->faces) {
      glm::dvec3 normal(0.0);
      glm::dvec3 centre(0.0);
      const glm::dvec3 first = path.position(face.corners[0]);
      for (std::int32_t i = 0; i < face.corner_count; ++i) {
        const std::uint32_t a = face.corners[static_cast<std::size_t>(i)];
        const std::uint32_t b = face.corners[static_cast<std::size_t>((i + 1) % face.corner_count)];
        ++directed[{a, b}];
        centre += path.position(a) / double(face.corner_count);
        normal += glm::cross(path.position(a) - first, path.position(b) - first);
      }
      CHECK(glm::dot(normal, centre) > 0.0);  // the sphere's centre is the origin
    }
  }
  std::size_t boundary = 0;
  for (const auto& [edge, times] : directed) {
    CHECK(times == 1);  // once in this direction: manifold and consistently oriented
    boundary += directed.count({edge.second, edge.first}) == 0 ? 1U : 0U;
  }
  CHECK(boundary ==
        state.fabric.rows().front()->stitches.size() + state.fabric.rows().back()->stitches.size());
}

TEST_CASE("parameters edited at any step give a run that ends or says why") {
  std::mt19937 random(11);
  Timeline timeline(small_sphere(), small_parameters());
  timeline.extend_to_end();
  for (int edit = 0; edit < 60; ++edit) {
    timeline.seek(random() % (timeline.known() + 1));
    Parameters p = timeline.parameters();
    p.rows.cast_on = 3 + static_cast<int>(random() % 20);
    give_epsilon(p, 0.01 + 0.2 * static_cast<double>(random() % 100) / 100);
    p.rows.close = static_cast<Closing>(random() % 3);
    p.rows.on_stall = static_cast<OnStall>(random() % 4 == 0 ? 1 : 0);
    p.stitches.placement = static_cast<PlacementPolicy>(random() % placement_names.size());
    timeline.edit_from_here(p);
    timeline.extend_to_end();
    CHECK((timeline.stop() != nullptr || timeline.furthest().finished()));
  }
}

TEST_CASE("a step after the last is a bug that is caught") {
  Timeline timeline = run(small_sphere(), small_parameters());
  State state = timeline.furthest();
  CHECK(state.finished());
  CHECK_THROWS_AS(advance(timeline.input(), small_parameters(), state), Bug);
  timeline.seek(timeline.known());
  CHECK_FALSE(timeline.forward());
}

TEST_CASE("one row alone is no piece: the run stops and says so") {
  const Timeline timeline = run(make_input(sphere(24, 2)), small_parameters());
  REQUIRE(timeline.stop() != nullptr);
  CHECK(knit::get_if<Stopped>(*timeline.stop())->reason == StopReason::no_row_levels);
  CHECK(narrate(*timeline.stop(), small_parameters()).find("one row is no piece") != std::string::npos);
  CHECK(timeline.furthest().fabric.empty());
}

TEST_CASE("written lines add up: each consumes what the one before made") {
  const Timeline timeline = run(test_support::thesis_sphere(), test_support::thesis_parameters());
  const State& state = timeline.furthest();
  REQUIRE(state.lines.size() == state.fabric.rows().size() + 1);
  for (std::size_t i = 0; i < state.fabric.rows().size(); ++i) {
    CHECK(state.lines[i]->produced == static_cast<std::int32_t>(state.fabric.rows()[i]->stitches.size()));
    CHECK(state.lines[i + 1]->consumed == state.lines[i]->produced);
  }
  CHECK(state.lines.back()->produced == 0);
}

TEST_CASE("every reason to stop has its own sentence and its own word") {
  const Parameters p = small_parameters();
  std::set<std::string> sentences, words;
  std::size_t reasons = 0;
  for (const StopReason reason : {StopReason::no_extent, StopReason::no_row_levels, StopReason::not_a_ring,
                                  StopReason::splits, StopReason::stall, StopReason::changes_too_much,
                                  StopReason::too_many_tubes, StopReason::too_fine, StopReason::open_edge}) {
    ++reasons;
    const bool of_tubes = reason == StopReason::too_many_tubes || reason == StopReason::too_fine;
    const Step stop{of_tubes ? Place{Stage::tubes, 0, 1} : Place{Stage::rows, 7, 1},
                    Stopped{reason, CriticalKind::saddle, 7, 3, 2, 12, 0.5, 0.25}};
    const std::string sentence = narrate(stop, p);
    CAPTURE(sentence);
    CHECK(sentence.size() > 40);
    CHECK(sentence.back() == '.');
    sentences.insert(sentence);
    for (const StepField& field : fields_of(stop)) {
      if (field.name == "reason") words.insert(std::get<std::string>(field.value));
    }
  }
  CHECK(sentences.size() == reasons);
  CHECK(words.size() == reasons);
}
