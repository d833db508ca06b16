// From the run to words with limbs and back: what the reader knits is what the plan's hands knit, and that is the fabric.
#include <algorithm>
#include <random>

#include "app/files/pattern_json.h"
#include "app/files/pattern_knitspeak.h"
#include "app/files/pattern_page.h"
#include "app/reader/pattern_json_reader.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/order/limb_order.h"
#include "knit/pattern/limb_needle.h"
#include "knit/pattern/written_pattern.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/limb_hands.h"
#include "tests/support/random_fabric.h"
#include "tests/support/repeated.h"
#include "tests/support/ringed_fabric.h"

using namespace knit;

namespace {

void check_reads_back(const std::string& text, const ReadLimbs& wanted) {
  const ReadLimbs read = read_limbs(text);
  if (!read.mistakes.empty()) {
    CAPTURE(text, read.mistakes.front().sentence);
    FAIL_CHECK("the reader finds a mistake");
    return;
  }
  CHECK(test_support::same_graph(read, wanted));
  CHECK(read.rounds_read == wanted.rounds_read);
  CHECK(read.cast_on == wanted.cast_on);
}

// What lies on each needle, as the deals say, is what the hands have there.
void check_needles(const LimbPlan& plan, const ReadLimbs& worked) {
  const std::vector<PieceNeedle> needles = needles_of(plan);
  for (std::size_t i = 0; i < needles.size(); ++i) {
    if (plan.pieces[i].is_cast_on()) continue;
    std::vector<std::int32_t> live;
    for (const NeedleStitch& stitch : needles[i].begin) {
      const auto at = static_cast<std::size_t>(stitch.stitch);
      const bool loops = plan.pieces[i].deals.back().kind == LimbDealKind::loops;
      if (stitch.gap > 0) {
        live.push_back(worked.gaps.at(static_cast<std::size_t>(stitch.gap) - 1).at(at));
      } else {
        const ReadLimb& from = worked.limbs.at(static_cast<std::size_t>(stitch.piece));
        live.push_back((loops ? from.rows.front() : from.rows.back()).at(at));
      }
    }
    CHECK(live == worked.limbs[i].live);
  }
}

// What the reader of JSON knits is what the hands knit; nothing is lost on the way.
void check_json(const LimbPlan& plan, const ReadLimbs& wanted) {
  const std::string text = app::pattern_json(plan);
  const app::JsonPattern json = app::read_pattern_json(text);
  const auto* read = std::get_if<ReadLimbs>(&json);
  REQUIRE(read != nullptr);
  if (!read->mistakes.empty()) {
    CAPTURE(text, read->mistakes.front().sentence);
    FAIL_CHECK("the reader of JSON finds a mistake");
    return;
  }
  CHECK(test_support::same_graph(*read, wanted));
  CHECK(read->rounds_read == wanted.rounds_read);
  CHECK(read->cast_on == wanted.cast_on);
}

std::vector<TubeId> tubes_of(const LimbPlan& plan) {
  std::vector<TubeId> tubes;
  for (const LimbPiece& piece : plan.pieces) tubes.push_back(piece.tube);
  return tubes;
}

LimbTubes limb_tubes_of(const State& state) { return {state.fabric, state.tubes.pointer().get()}; }

// The cheapest order, whatever the fabric's is.
std::vector<TubeId> cheapest_tubes(const State& state) {
  const OrderedLimbs limbs = cheapest_order(limb_tubes_of(state));
  CHECK(limbs.runs.held_most == limbs.layout.plan.held_most);  // known before markers are
  return tubes_of(limbs.layout.plan);
}

ReadLimbs check_plan(const LimbPlan& plan, const State& state) {
  const ReadLimbs worked = test_support::PlanHands(plan).run();
  CHECK(test_support::AgainstFabric(plan, worked, state).differs() == "");
  check_needles(plan, worked);
  return worked;
}

void check_round_trip(const State& state, bool all_forms) {
  REQUIRE(has_limbs(state));
  REQUIRE(limbs_are_known(state));
  check_plan(plan_limbs(state),
             state);  // in the rows' order, which of a fabric of no shape need not be the cheapest
  const std::vector<TubeId> cheapest = cheapest_tubes(state);
  for (const bool alike : {false, true}) {
    LimbOptions limbs;
    limbs.twins_alike = alike;
    limbs.order = cheapest;
    const LimbPlan plan = plan_limbs(state, limbs);
    const ReadLimbs worked = check_plan(plan, state);
    check_json(plan, worked);
    for (const bool dressed : {false, true}) {
      if (dressed && !all_forms) continue;
      PatternOptions options;
      options.stars = options.markers = dressed;
      if (dressed) options.piece_names = {{"A", "Tail"}, {"C", "Foot"}};
      const WrittenPattern pattern = write_pattern(plan, {22.0, 32.0}, options, "shape");
      check_reads_back(pattern_as_text(pattern), worked);
      if (!all_forms) continue;
      check_reads_back(pattern_as_markdown(pattern), worked);
      check_reads_back(app::pattern_html(pattern, app::PiecesArt{}), worked);
      check_reads_back(app::pattern_knitspeak(plan, options), worked);
    }
  }
}

State run_of(const Mesh& mesh, double width_share, TimingKind timing = TimingKind::linear) {
  const auto input = make_input(mesh);
  Parameters parameters = default_parameters(input->bounds);
  give_width(parameters, width_share * input->bounds.diagonal());
  parameters.timing.kind = timing;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters = resolved(parameters, *input);
  parameters.timing.axis.kind = AxisKind::y;
  Timeline run(input, parameters);
  run.extend_to_end();
  return run.complete() ? run.furthest() : State{};
}

// Turned so that `up` points along y.
Mesh turned_up(Mesh mesh, const glm::dvec3& up) {
  const glm::dvec3 aside = glm::normalize(std::abs(up.x) < 0.8 ? glm::cross(up, {1.0, 0.0, 0.0})
                                                               : glm::cross(up, {0.0, 0.0, 1.0}));
  const glm::dvec3 third = glm::cross(aside, up);
  for (glm::dvec3& p : mesh.positions) p = {glm::dot(p, aside), glm::dot(p, up), glm::dot(p, third)};
  return mesh;
}

// An order of the tubes with rows in which each comes after those that it stands on.
std::vector<TubeId> any_order(const State& state, unsigned seed) {
  std::vector<TubeId> left, order;
  for (const auto& row : state.fabric.rows()) {
    if (left.empty() || left.back() != row->tube) left.push_back(row->tube);
  }
  std::mt19937 random(seed);
  for (int tries = 0; tries < 400 && !left.empty(); ++tries) {
    const std::size_t at = random() % left.size();
    order.push_back(left[at]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return order;
}

}  // namespace

TEST_CASE("limbs round trip: bodies that branch come back from their words, stitch by stitch") {
  const Mesh ring = torus(32, 16, 1.0, 0.4);
  const Mesh arch = test_support::arch();
  for (const double width : {0.035, 0.06}) {
    CAPTURE(width);
    check_round_trip(run_of(turned_up(ring, {1.0, 0.0, 0.0}), width), true);
    check_round_trip(run_of(turned_up(ring, {0.0, 1.0, 0.0}), width), true);
    check_round_trip(run_of(arch, width), true);
    check_round_trip(run_of(turned_up(arch, {0.0, -1.0, 0.0}), width), true);
    check_round_trip(run_of(turned_up(arch, {0.0, -1.0, 0.0}), width, TimingKind::geodesic), true);
  }
}

TEST_CASE("limbs round trip: bodies turned by chance") {
  std::int32_t with_limbs = 0;
  for (const glm::dvec3& up : test_support::random_axes(6, 5)) {
    CAPTURE(up.x, up.y, up.z);
    for (const Mesh& body : {torus(32, 16, 1.0, 0.4), test_support::arch()}) {
      const State state = run_of(turned_up(body, up), 0.05);
      if (!has_limbs(state)) continue;
      ++with_limbs;
      check_round_trip(state, false);
    }
  }
  CHECK(with_limbs >= 6);
}

TEST_CASE("limbs round trip: fabrics of no shape") {
  for (unsigned seed = 0; seed < test_support::repeated(200U); ++seed) {
    CAPTURE(seed);
    const State state = test_support::RandomFabric(seed).run(3 + static_cast<int>(seed % 9));
    if (has_limbs(state)) check_round_trip(state, false);
  }
}

namespace {

struct RingsMet {
  int cast_on = 0, grafted = 0;
  int of_one_loop = 0;  // grafted: the two parts of a loop that was divided
  int steep = 0;        // cast on: one has more than twice the other's stitches
  void add(const State& state) {
    const auto& deals = state.fabric.deals();
    for (const auto& deal : deals) {
      if (deal->kind == DealKind::ring_cast_on) {
        const auto [less, more] = std::minmax({deal->taken[0].size(), deal->taken[1].size()});
        ++cast_on;
        steep += more > 2 * less ? 1 : 0;
      }
      if (deal->kind != DealKind::ring_bind_off) continue;
      ++grafted;
      of_one_loop += std::any_of(deals.begin(), deals.end(), [&](const auto& split) {
        return split->kind == DealKind::split &&
               std::is_permutation(split->to.begin(), split->to.end(), deal->from.begin(), deal->from.end());
      });
    }
  }
};

// Tubes with rows by chance, each after those that it stands on.
std::vector<TubeId> standing_order(const State& state, unsigned seed) {
  const LimbTubes tubes = limb_tubes_of(state);
  std::vector<std::int32_t> left, done;
  for (std::int32_t tube = 0; tube < tubes.count(); ++tube) {
    if (tubes.tube(tube).has_rows()) left.push_back(tube);
  }
  std::mt19937 random(seed);
  std::vector<TubeId> order;
  while (!left.empty()) {
    std::vector<std::int32_t> can;
    for (const std::int32_t tube : left) {
      const std::vector<std::int32_t> below = tubes_below(tubes, tube);
      const bool stands = std::all_of(below.begin(), below.end(), [&](std::int32_t other) {
        return std::find(done.begin(), done.end(), other) != done.end();
      });
      if (stands) can.push_back(tube);
    }
    REQUIRE_FALSE(can.empty());
    done.push_back(can[random() % can.size()]);
    order.push_back(tubes.tube(done.back()).id);
    left.erase(std::find(left.begin(), left.end(), done.back()));
  }
  return order;
}

}  // namespace

TEST_CASE("limbs round trip: fabrics of no shape with rings") {
  RingsMet rings;
  for (unsigned seed = 0; seed < test_support::repeated(200U); ++seed) {
    CAPTURE(seed);
    const State bare = test_support::RandomFabric(seed).run(1 + static_cast<int>(seed % 8));
    State state = test_support::RingedFabric(seed).of(bare);
    if (!has_limbs(state)) continue;
    state.work = Finished{};
    check_round_trip(state, false);
    for (unsigned tries = 0; tries < 6; ++tries)
      CHECK(cost_of_order(state, standing_order(state, seed + tries)).has_value());
    rings.add(state);
  }
  if (!test_support::whole()) return;
  CHECK(rings.cast_on > 50);
  CHECK(rings.grafted > 50);
  CHECK(rings.of_one_loop > 5);
  CHECK(rings.steep > 5);
}

TEST_CASE("limbs round trip: rims that are bound off together are the same graph") {
  LimbOptions three;
  three.three_needle = true;
  int together = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    State state = test_support::RingedFabric(seed).of(
        test_support::RandomFabric(seed).run(1 + static_cast<int>(seed % 5)));
    if (!has_limbs(state)) continue;
    state.work = Finished{};
    const LimbPlan plan = plan_limbs(state, three);
    const auto seams = std::count_if(plan.pieces.begin(), plan.pieces.end(),
                                     [](const LimbPiece& piece) { return piece.end.three_needle; });
    if (seams == 0) continue;
    together += static_cast<int>(seams);
    const WrittenPattern words = write_pattern(plan, {22.0, 32.0}, {}, "shape");
    const ReadLimbs hands = check_plan(plan, state);
    check_reads_back(pattern_as_text(words), hands);
    check_reads_back(pattern_as_markdown(words), hands);
    check_reads_back(app::pattern_html(words, app::PiecesArt{}), hands);
    check_reads_back(app::pattern_knitspeak(plan, {}), hands);
    CHECK(app::pattern_json(plan).find("\"by\":\"three-needle\"") != std::string::npos);
    check_json(plan, hands);
    CHECK(pattern_as_text(words).find("Three-needle bind off with ") != std::string::npos);
  }
  CHECK(together > 5);
}

TEST_CASE("limbs round trip: two rounds, cast on together, bound off or grafted to each other") {
  std::int32_t rings = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    State bare;
    for (const TubeId tube : {0, 1}) {
      Row row;
      row.tube = tube;
      row.id = bare.fabric.next_row();
      row.stitches.resize(3 + (seed * (static_cast<unsigned>(tube) + 3)) % 8);
      bare.fabric.add(std::move(row));
    }
    CHECK_FALSE(limbs_are_known(bare));
    State state = test_support::RingedFabric(seed).of(bare);
    if (state.fabric.deals().empty()) continue;
    ++rings;
    state.work = Finished{};
    check_round_trip(state, true);
  }
  CHECK(rings > 10);
}

TEST_CASE("limbs round trip: any order that can be worked, and no other") {
  std::int32_t worked = 0, refused = 0;
  for (unsigned seed = 0; seed < test_support::repeated(300U); ++seed) {
    CAPTURE(seed);
    const State state = test_support::RandomFabric(seed).run(4);
    if (!has_limbs(state)) continue;
    LimbOptions options;
    options.order = any_order(state, seed);
    const auto cost = cost_of_order(state, options.order);
    const LimbPlan plan = plan_limbs(state, options);
    const ReadLimbs hands = check_plan(plan, state);
    check_reads_back(pattern_as_text(write_pattern(plan, {22.0, 32.0}, {}, "shape")), hands);
    const std::vector<TubeId> made = tubes_of(plan);
    (cost ? worked : refused) += 1;
    CHECK((made == options.order) >= cost.has_value());
    if (cost) CHECK(plan.cost == cost->cost);
    if (cost) CHECK(cheapest_order(limb_tubes_of(state)).cost <= cost->cost);
  }
  if (test_support::whole()) CHECK(worked > 10);
  if (test_support::whole()) CHECK(refused > 10);
}
