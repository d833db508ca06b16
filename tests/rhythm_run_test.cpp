// Rhythms in whole runs: counts, placement, words, steps, and the rewind contract.
#include <algorithm>
#include <set>

#include "knit/insight/narrate.h"
#include "knit/mesh/branching_shapes.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/rounds.h"
#include "knit/rhythm/rhythm_plan.h"
#include "tests/support/belly.h"
#include "tests/support/promises.h"
#include "tests/support/scrub.h"

using namespace knit;
using namespace test_support;

namespace {

Parameters in_rhythm() {
  Parameters p = small_parameters();
  p.timing.kind = TimingKind::arc_length;
  p.rows.source = RowSource::contours;
  p.stitches.placement = PlacementPolicy::nearest;
  p.rhythm.counts = CountPlanning::rhythm;
  return p;
}

Timeline whole_run(const Parameters& parameters) {
  Timeline timeline(small_sphere(), parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.furthest().finished());
  return timeline;
}

std::vector<std::int32_t> counts_made(const State& state) {
  std::vector<std::int32_t> counts;
  for (const auto& row : state.fabric.rows()) counts.push_back(size_of(*row));
  return counts;
}

template <class Kind>
std::vector<Kind> all_steps(const Timeline& timeline) {
  std::vector<Kind> found;
  for (const Step& step : timeline.steps()) {
    if (const auto* what = knit::get_if<Kind>(step)) found.push_back(*what);
  }
  return found;
}

}  // namespace

TEST_CASE("the rows of a run have the counts of the plan, and every shaping round is one repeat") {
  for (const RhythmStyle style :
       {RhythmStyle::pairs, RhythmStyle::lines, RhythmStyle::centre, RhythmStyle::stagger}) {
    Parameters p = in_rhythm();
    p.rhythm.style = style;
    const Timeline timeline = whole_run(p);
    const State& state = timeline.furthest();
    REQUIRE(state.rhythms.size() == 1);
    const RhythmPlan& plan = state.rhythms.front()->plan;
    CHECK(counts_made(state) == plan.counts);
    std::size_t shaping = 0;
    for (const RoundLine& line : round_lines(rounds_of(state), {})) {
      INFO(line.words);
      if (line.words == "Knit") continue;
      ++shaping;
      CHECK(line.words.front() == '[');
      CHECK(line.words.ends_with("] " + std::to_string(plan.sections) + " times"));
    }
    CHECK(shaping > 3);
  }
}

TEST_CASE("a rhythm is one step before the first row, and each count says whether it changes or rests") {
  const Timeline timeline = whole_run(in_rhythm());
  const auto planned = all_steps<RhythmPlanned>(timeline);
  REQUIRE(planned.size() == 1);
  const RhythmPlan& plan = timeline.furthest().rhythms.front()->plan;
  CHECK(planned.front().none == NoRhythm::no);
  CHECK(planned.front().sections == plan.sections);
  CHECK(planned.front().rounds + 1 == static_cast<int>(plan.counts.size()));
  const auto counts = all_steps<CountChosen>(timeline);
  REQUIRE(counts.size() == plan.counts.size());
  for (std::size_t row = 0; row < counts.size(); ++row) {
    const bool changes = row == 0 || plan.counts[row] != plan.counts[row - 1];
    CHECK(counts[row].reason == (changes ? CountReason::rhythm_change : CountReason::rhythm_rest));
  }
}

TEST_CASE("the first count that a person asks for is kept in a rhythm, or there is none and it is said") {
  Parameters p = in_rhythm();
  p.rows.cast_on = 12;
  CHECK(counts_made(whole_run(p).furthest()).front() == 12);
  p.rows.cast_on = 11;
  const Timeline timeline = whole_run(p);
  CHECK(counts_made(timeline.furthest()).front() == 11);
  const auto planned = all_steps<RhythmPlanned>(timeline);
  REQUIRE(planned.size() == 1);
  CHECK(planned.front().none == NoRhythm::fits_none);
  CHECK(planned.front().unusual(p));
}

TEST_CASE("a run in rhythm rewinds, and tuned it is a fresh one") {
  Timeline timeline = whole_run(in_rhythm());
  const std::vector<std::uint64_t> hashes = hashes_forward(timeline);
  check_backward(timeline, hashes);
  check_at_random(timeline, hashes, 50);
  for (const RhythmStyle style : {RhythmStyle::lines, RhythmStyle::stagger}) {
    Parameters p = in_rhythm();
    p.rhythm.style = style;
    timeline.seek(timeline.position_of({Stage::rows, 6, 3}));
    timeline.tune(p);
    check_equals_fresh(timeline, p);
  }
}

TEST_CASE("edited on the way, what is knitted stays and the rest is planned anew from the count at hand") {
  for (const auto& [key, value] : {std::pair{"stitch-height", "0.18"}, std::pair{"stitch-width", "0.26"},
                                   std::pair{"rhythm-tolerance", "8"}}) {
    INFO(key);
    const Timeline plain = whole_run(in_rhythm());
    Timeline timeline = plain;
    timeline.seek(timeline.position_of({Stage::rows, 6, 0}));
    Parameters p = in_rhythm();
    REQUIRE_FALSE(set_value(*find_parameter(key), p, value));
    timeline.edit_from_here(p);
    timeline.extend_to_end();
    const State& state = timeline.furthest();
    REQUIRE(state.finished());
    REQUIRE(state.rhythms.size() == 2);
    const TubeRhythm& anew = *state.rhythms.back();
    CHECK(anew.from == 5);  // the row in the making keeps its count
    const std::vector<std::int32_t> counts = counts_made(state);
    const std::vector<std::int32_t> before = counts_made(plain.furthest());
    CHECK(std::equal(counts.begin(), counts.begin() + 6, before.begin()));
    REQUIRE(anew.none == NoRhythm::no);
    CHECK(std::equal(counts.begin() + 5, counts.end(), anew.plan.counts.begin(), anew.plan.counts.end()));
  }
}

TEST_CASE("the step of a rhythm says what it is and what it costs, never less than that") {
  const Parameters p = in_rhythm();
  RhythmPlanned step{0, 8, 4, 4, 18, 58, 31, RhythmStyle::pairs, NoRhythm::no, 3.07F, 2.0F, 5.0F, true};
  const auto told = [&] { return narrate({{Stage::cast_on, 1, 1}, step}, p); };
  CHECK(
      told() ==
      "Tube A is planned whole: 4 rhythms, 18 of 58 rounds shape, each by 8 at most in 4 equal sections; the "
      "circumference is never seen more than 3.1 % off.");
  step.within = false;
  step.local = 4.15F;
  CHECK(told().find("No rhythm stays within 3.5 %: this one is off by 4.2 % at row 31.") !=
        std::string::npos);
  step.shaping = 0;
  CHECK(told().find("is knitted plain, 58 rounds") != std::string::npos);
  step.none = NoRhythm::few_rows;
  CHECK(told().find("has no rhythm, as it is worked on live stitches") != std::string::npos);
}

TEST_CASE("a body with a belly is knitted from its back with its halves shaped apart and mirrored") {
  Parameters p = in_rhythm();
  give_width(p, 0.1);
  Timeline timeline(make_input(belly_mesh()), p);
  timeline.extend_to_end();
  const State& state = timeline.furthest();
  REQUIRE(state.finished());
  REQUIRE(state.rhythms.size() == 1);
  const TubeRhythm& rhythm = *state.rhythms.front();
  REQUIRE(rhythm.mirror);
  REQUIRE_FALSE(rhythm.plan.fronts.empty());
  CHECK(counts_made(state) == rhythm.plan.counts);
  const auto planned = all_steps<RhythmPlanned>(timeline);
  REQUIRE(planned.size() == 1);
  CHECK(planned.front().apart);
  CHECK(narrate({{Stage::cast_on, 1, 1}, planned.front()}, p).find("front and back halves differ") !=
        std::string::npos);
  std::size_t shaping = 0;
  for (const auto& row : state.fabric.rows()) {
    const glm::dvec3& begin = row->stitches.front().position;
    CHECK(std::abs(rhythm.mirror->height(begin)) < 1e-9);
    CHECK(glm::dot(begin - rhythm.mirror->point, rhythm.mirror->back) >
          glm::dot(row->stitches[row->stitches.size() / 2].position - rhythm.mirror->point,
                   rhythm.mirror->back));
    if (row->on.empty()) continue;
    const Join* join = state.fabric.join_into(row->id);
    REQUIRE(join != nullptr);
    CHECK(join->rule == Rule::repeat);
    CHECK(join->mains.size() == 4);
    shaping += join->change() != 0 ? 1 : 0;
  }
  CHECK(shaping > 6);
  CHECK(broken_promise(state).empty());
  const std::vector<std::uint64_t> hashes = hashes_forward(timeline);
  check_at_random(timeline, hashes, 20);
  timeline.seek(timeline.position_of({Stage::rows, 6, 0}));
  Parameters tighter = p;
  tighter.rhythm.tolerance = 2.0;
  timeline.edit_from_here(tighter);
  timeline.extend_to_end();
  REQUIRE(timeline.furthest().finished());
  REQUIRE(timeline.furthest().rhythms.size() == 2);
  CHECK_FALSE(timeline.furthest().rhythms.back()->plan.fronts.empty());
}
