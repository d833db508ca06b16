// From the run to words with limbs and back: what the reader knits is what the plan's hands knit, and that is the fabric.
#include <random>

#include "app/files/pattern_export.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/written_pattern.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/limb_hands.h"
#include "tests/support/random_fabric.h"

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

ReadLimbs check_plan(const LimbPlan& plan, const State& state) {
  const ReadLimbs worked = test_support::PlanHands(plan).run();
  CHECK(test_support::AgainstFabric(plan, worked, state).differs() == "");
  return worked;
}

void check_round_trip(const State& state, bool all_forms) {
  REQUIRE(has_limbs(state));
  REQUIRE(limbs_are_known(state));
  for (const bool alike : {false, true}) {
    LimbOptions limbs;
    limbs.twins_alike = alike;
    const LimbPlan plan = plan_limbs(state, limbs);
    const ReadLimbs worked = check_plan(plan, state);
    for (const bool dressed : {false, true}) {
      if (dressed && !all_forms) continue;
      PatternOptions options;
      options.stars = options.markers = dressed;
      if (dressed) options.piece_names = {{"A", "Tail"}, {"C", "Foot"}};
      const WrittenPattern pattern = write_pattern(plan, {22.0, 32.0}, options, "shape");
      check_reads_back(pattern_as_text(pattern), worked);
      if (!all_forms) continue;
      check_reads_back(pattern_as_markdown(pattern), worked);
      check_reads_back(app::pattern_html(pattern, {}), worked);
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
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    const State state = test_support::RandomFabric(seed).run(3 + static_cast<int>(seed % 9));
    if (has_limbs(state)) check_round_trip(state, false);
  }
}

TEST_CASE("limbs round trip: any order that can be worked, and no other") {
  std::int32_t worked = 0, refused = 0;
  for (unsigned seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    const State state = test_support::RandomFabric(seed).run(4);
    if (!has_limbs(state)) continue;
    LimbOptions options;
    options.order = any_order(state, seed);
    const auto cost = cost_of_order(state, options.order);
    const LimbPlan plan = plan_limbs(state, options);
    const ReadLimbs hands = check_plan(plan, state);
    check_reads_back(pattern_as_text(write_pattern(plan, {22.0, 32.0}, {}, "shape")), hands);
    std::vector<TubeId> made;
    for (const LimbPiece& piece : plan.pieces) made.push_back(piece.tube);
    (cost ? worked : refused) += 1;
    CHECK((made == options.order) >= cost.has_value());
    if (cost) CHECK(plan.cost == cost->cost);
    if (cost) CHECK(plan_limbs(state).cost <= cost->cost);
  }
  CHECK(worked > 10);
  CHECK(refused > 10);
}
