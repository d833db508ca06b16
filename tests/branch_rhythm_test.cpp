// Rhythms of pieces that branch: one for every tube, begun at its main, the same for twins; in words, and read back.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "app/files/pattern_json.h"
#include "app/files/pattern_page.h"
#include "app/reader/pattern_json_reader.h"
#include "knit/mesh/branching_shapes.h"
#include "knit/pattern/limb_groups.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/written_pattern.h"
#include "knit/reader/limbs_reader.h"
#include "knit/rhythm/few_rounds.h"
#include "knit/rhythm/live_rhythm.h"
#include "knit/rhythm/rhythm_plan.h"
#include "knit/rhythm/segment_search.h"
#include "tests/support/belly.h"
#include "tests/support/limb_hands.h"
#include "tests/support/promises.h"
#include "tests/support/scrub.h"

using namespace knit;
using namespace test_support;

namespace {

Parameters branching_in_rhythm(double width) {
  Parameters p = small_parameters();
  give_width(p, width);
  p.timing.kind = TimingKind::arc_length;
  p.rows.source = RowSource::contours;
  p.stitches.placement = PlacementPolicy::nearest;
  p.rhythm.counts = CountPlanning::rhythm;
  return p;
}

Timeline knitted_in_rhythm(const Mesh& shape, double width) {
  Timeline timeline(make_input(shape), branching_in_rhythm(width));
  timeline.extend_to_end();
  REQUIRE(timeline.furthest().finished());
  return timeline;
}

const TubeRhythm* rhythm_made(const State& state, TubeId tube) {
  for (const auto& rhythm : state.rhythms) {
    if (rhythm->tube == tube) return &*rhythm;
  }
  return nullptr;
}

// Rows whose count and the one below are of the plan are repeats; a first row may lead from the live stitches to the plan.
void check_rows_as_planned(const State& state) {
  std::size_t shaping = 0;
  for (const auto& row : state.fabric.rows()) {
    const TubeRhythm* rhythm = rhythm_made(state, row->tube);
    REQUIRE(rhythm != nullptr);
    if (rhythm->none != NoRhythm::no) continue;
    REQUIRE(rhythm->has(row->level));
    CHECK(size_of(*row) == rhythm->count(row->level));
    CHECK(size_of(*row) % rhythm->plan.sections == 0);
    if (row->on.empty() || !rhythm->has(row->level - 1)) continue;
    const Join* join = state.fabric.join_into(row->id);
    REQUIRE(join != nullptr);
    CHECK(join->rule == Rule::repeat);
    shaping += join->change() != 0 ? 1 : 0;
  }
  CHECK(shaping >= 6);
}

// From the marker on, in the words of the pattern.
void check_limbs_are_repeats(const State& state) {
  const LimbPlan plan = plan_limbs(state);
  std::size_t shaping = 0;
  for (const LimbPiece& piece : plan.pieces) {
    if (!piece.is_cast_on()) continue;
    const TubeRhythm* rhythm = rhythm_made(state, piece.tube);
    REQUIRE(rhythm != nullptr);
    for (std::size_t i = 0; i < piece.starts.size(); ++i)
      CHECK(piece.starts[i] % (rhythm->count(static_cast<std::int32_t>(i)) / rhythm->plan.sections) == 0);
    for (const RoundLine& line : round_lines(rounds_of(piece), {})) {
      if (line.words == "Knit") continue;
      ++shaping;
      INFO(line.words);
      CHECK(line.words.front() == '[');
      CHECK(line.words.ends_with(" times"));
      CHECK(std::count(line.words.begin(), line.words.end(), '[') == 1);
    }
  }
  CHECK(shaping >= 2);
}

void check_is_read_back(const State& state) {
  const LimbPlan plan = plan_limbs(state);
  const ReadLimbs worked = PlanHands(plan).run();
  CHECK(AgainstFabric(plan, worked, state).differs().empty());
  const app::JsonPattern json = app::read_pattern_json(app::pattern_json(plan));
  const auto* read = std::get_if<ReadLimbs>(&json);
  REQUIRE(read != nullptr);
  CHECK(read->mistakes.empty());
  CHECK(same_graph(*read, worked));
  const WrittenPattern pattern = write_pattern(plan, {22.0, 32.0}, {}, "shape");
  for (const std::string& text : {pattern_as_text(pattern), pattern_as_markdown(pattern),
                                  app::pattern_html(pattern, app::PiecesArt{})}) {
    const ReadLimbs told = read_limbs(text);
    CHECK(told.mistakes.empty());
    CHECK(same_graph(told, worked));
  }
}

// Trousers whose waist bulges forward, so that front and back are not alike above the join.
Mesh trousers_with_belly() {
  Mesh mesh = trousers(0.12);
  double low = mesh.positions.front().y, high = low;
  for (const glm::dvec3& p : mesh.positions) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  const double from = low + 0.45 * (high - low);
  for (glm::dvec3& p : mesh.positions) {
    if (p.y <= from) continue;
    const double wave = std::sin(std::numbers::pi * (p.y - from) / (high - from));
    p.z += 0.5 * wave * wave;
  }
  return mesh;
}

}  // namespace

TEST_CASE(
    "a body on live stitches has its halves shaped apart and begins with the stitches that it is dealt") {
  const Timeline timeline = knitted_in_rhythm(trousers_with_belly(), 0.08);
  const State& state = timeline.furthest();
  CHECK(broken_promise(state).empty());
  std::size_t apart = 0, shaping = 0;
  for (const auto& rhythm : state.rhythms) {
    if (rhythm->plan.fronts.empty()) continue;
    ++apart;
    REQUIRE(rhythm->mirror);
    for (const auto& row : state.fabric.rows()) {
      if (row->tube != rhythm->tube) continue;
      CHECK(std::abs(rhythm->mirror->height(row->stitches.front().position)) < 1e-9);
      CHECK(size_of(*row) == rhythm->count(row->level));
      if (row->level == 0) {
        REQUIRE_FALSE(row->on.empty());
        // The loop was turned: its first stitch is at the back, right below that of the row.
        const glm::dvec3& begin = row->stitches.front().position;
        for (const Stitch& live : state.fabric.stitches_of(row->on))
          CHECK(glm::distance(state.fabric.position(row->on.at(0)), begin) <=
                glm::distance(live.position, begin) + 1e-9);
        if (rhythm->from < 0) {
          CHECK(rhythm->plan.counts.front() == row->on.size());
          CHECK(rhythm->front(-1) % 2 == 0);
        } else {
          CHECK(std::abs(rhythm->plan.counts.front() - row->on.size()) <= 1);
        }
      }
      if (!rhythm->has(row->level - 1)) continue;
      const Join* join = state.fabric.join_into(row->id);
      REQUIRE(join != nullptr);
      CHECK(join->rule == Rule::repeat);
      CHECK(join->mains.size() == 4);
      shaping += join->change() != 0 ? 1 : 0;
    }
    CHECK(rhythm->plan.front_off < 8.0);
    CHECK(rhythm->plan.back_off < 8.0);
  }
  CHECK(apart == 1);
  CHECK(shaping >= 4);
  check_is_read_back(state);
}

TEST_CASE("halves on live stitches begin with their number if it is even and one beside it if it is odd") {
  const HalfIdeals ideals = belly_ideals();
  HalfIdeals upper;  // from the widest row on
  const auto widest = std::max_element(ideals.front.begin(), ideals.front.end()) - ideals.front.begin();
  upper.front.assign(ideals.front.begin() + widest, ideals.front.end());
  upper.back.assign(ideals.back.begin() + widest, ideals.back.end());
  const RhythmSettings settings{CountPlanning::rhythm};
  const auto first = static_cast<std::int32_t>(upper.front.front() + upper.back.front());
  for (std::int32_t live = first - 2; live <= first + 2; ++live) {
    INFO("on " << live);
    const auto plan = plan_halves_on(upper, settings, {live, false});
    REQUIRE(plan);
    CHECK(plan->plan.counts.size() == upper.front.size() + (plan->from < 0 ? 1 : 0));
    CHECK(std::abs(plan->plan.counts.front() - live) == live % 2);
    const auto shared = plan_halves_on(upper, settings, {live, true});
    REQUIRE(shared);
    CHECK(shared->from == 0);
  }
}

TEST_CASE("a piece that branches has a rhythm in every tube, limbs begin at a main, and all is read back") {
  // Of the trousers the first round after the join is a repeat already.
  for (const auto& [shape, width] : {std::pair{trousers(0.12), 0.1}, std::pair{letter_y(0.12), 0.12}}) {
    const Timeline timeline = knitted_in_rhythm(shape, width);
    const State& state = timeline.furthest();
    REQUIRE(has_limbs(state));
    CHECK(broken_promise(state).empty());
    check_rows_as_planned(state);
    check_limbs_are_repeats(state);
    check_is_read_back(state);
  }
}

TEST_CASE("twins have one plan, and their rounds are the same from the second on") {
  // A split gives one of them 21 stitches and the other 19.
  const Timeline timeline = knitted_in_rhythm(letter_y(0.12), 0.09);
  const State& state = timeline.furthest();
  const LimbPlan plan = plan_limbs(state);
  std::size_t twins = 0;
  for (std::int32_t i = 0; i < plan.count(); ++i) {
    for (std::int32_t j = 0; j < i; ++j) {
      if (!are_twins(plan, i, j)) continue;
      ++twins;
      const LimbPiece &one = plan.piece(j), &other = plan.piece(i);
      CHECK(rhythm_made(state, one.tube)->plan == rhythm_made(state, other.tube)->plan);
      CHECK(alike_from(one, other) > 0);
      CHECK(alike_from(one, other) <= first_round_of(other) + 1);
    }
  }
  CHECK(twins == 1);
}

TEST_CASE("what is asked for the cast on of one twin is the other one's too") {
  Parameters p = branching_in_rhythm(0.12);
  p.rows.cast_on = 10;
  Timeline timeline(make_input(trousers(0.12)), p);
  timeline.extend_to_end();
  const State& state = timeline.furthest();
  REQUIRE(state.finished());
  REQUIRE(state.rhythms.size() == 3);
  CHECK(state.rhythms[0]->plan.counts.front() == 10);
  CHECK(state.rhythms[1]->plan == state.rhythms[0]->plan);
}

TEST_CASE("live stitches that are whole sections begin the plan, others are led to it in one round") {
  const std::vector<double> ideals{32.4, 32.0, 31.0, 29.0, 27.0, 25.0, 22.0, 19.0, 16.0, 12.0, 8.0};
  const RhythmSettings settings{CountPlanning::rhythm};
  const auto whole = plan_rhythm_on(ideals, settings, {32, false});
  REQUIRE(whole);
  CHECK(whole->plan.counts.front() == 32);
  CHECK(whole->plan.counts.size() == ideals.size() + (whole->from < 0 ? 1 : 0));
  for (const std::int32_t live : {31, 37, 43, 61}) {
    const auto led = plan_rhythm_on(ideals, settings, {live, false});
    REQUIRE(led);
    CHECK(led->from == 0);
    CHECK(led->plan.counts.size() == ideals.size());
    CHECK(led->plan.counts.front() % led->plan.sections == 0);
    CHECK(may_begin_on(led->plan, live));
  }
  const auto shared = plan_rhythm_on(ideals, settings, {32, true});
  REQUIRE(shared);
  CHECK(shared->from == 0);
}

TEST_CASE("a first round on live stitches is one repeat where a number of sections allows it") {
  CHECK(sections_to_begin(28, 24, true) == 2);
  CHECK(sections_to_begin(28, 24, false) == 4);
  CHECK(sections_to_begin(35, 30, true) == 5);
  CHECK(sections_to_begin(27, 24, true) == 3);
  CHECK(sections_to_begin(10, 9, true) == 1);
  CHECK(sections_to_begin(6, 12, false) == 6);
  CHECK(sections_to_begin(23, 16, true) == 0);
  CHECK(sections_to_begin(24, 24, true) == 0);
  CHECK(sections_to_begin(0, 8, true) == 0);
  RhythmPlan plan;
  plan.counts = {24};
  const auto score_on = [&](std::int32_t live) {
    return rhythm_score(plan, {0, 0, SegmentEnd::start, live});
  };
  CHECK(score_on(28) == score_on(24) + 1.0);
  CHECK(score_on(31) == score_on(24) + 4.0);
}

TEST_CASE("a plan on live stitches at most doubles and at least halves them") {
  const std::vector<double> ideals{40.0, 40.0, 40.0, 40.0, 40.0, 40.0};
  const RhythmSettings settings{CountPlanning::rhythm};
  for (const std::int32_t live : {13, 19, 95}) {
    const auto plan = plan_rhythm_on(ideals, settings, {live, true});
    REQUIRE(plan);
    INFO(live << " to " << plan->plan.counts.front());
    CHECK(may_begin_on(plan->plan, live));
  }
  RhythmPlan plan;
  plan.counts = {16};
  CHECK(may_begin_on(plan, 8));
  CHECK_FALSE(may_begin_on(plan, 7));
  CHECK(may_begin_on(plan, 32));
  CHECK_FALSE(may_begin_on(plan, 33));
  CHECK(may_begin_on(plan, 0));
}

TEST_CASE(
    "the one or two rounds of a tube on live stitches are one repeat each, and near to what they hold") {
  const auto counts_on = [](std::int32_t live, const std::vector<double>& ideals) {
    return plan_few_rounds(ideals, live, true).counts;
  };
  using Counts = std::vector<std::int32_t>;
  CHECK(counts_on(12, {6.9}) == Counts{6});
  CHECK(counts_on(12, {7.1}) == Counts{8});
  CHECK(counts_on(14, {8.4}) == Counts{7});
  CHECK(counts_on(13, {10.0, 6.0}) == Counts{12, 6});
  CHECK(counts_on(40, {41.0, 41.0}) == Counts{41, 41});  // one increase is a repeat
  CHECK(counts_on(20, {7.0}) == Counts{10});             // not below half
  CHECK(counts_on(3, {9.0, 14.0}) == Counts{6, 12});
  // No repeat comes near enough: the nearest.
  CHECK(counts_on(23, {16.1}) == Counts{16});
}

TEST_CASE("a limb of few rounds is worked as its counts say, each round one repeat") {
  const Timeline timeline = knitted_in_rhythm(starfish(0.12), 0.2);
  const State& state = timeline.furthest();
  std::size_t rounds = 0;
  for (const auto& row : state.fabric.rows()) {
    const TubeRhythm* rhythm = rhythm_made(state, row->tube);
    REQUIRE(rhythm != nullptr);
    if (rhythm->none != NoRhythm::few_rows) continue;
    ++rounds;
    REQUIRE(rhythm->has(row->level));
    CHECK(size_of(*row) == rhythm->count(row->level));
    const Join* join = state.fabric.join_into(row->id);
    REQUIRE(join != nullptr);
    CHECK(join->rule == Rule::repeat);
  }
  CHECK(rounds > 0);
}

TEST_CASE("a run in rhythm that branches rewinds") {
  Timeline timeline = knitted_in_rhythm(trousers(0.2), 0.12);
  const std::vector<std::uint64_t> hashes = hashes_forward(timeline);
  check_at_random(timeline, hashes, 20);
}
