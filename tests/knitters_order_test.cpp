// Playback and pattern: the rows of a run are made in the order in which its pieces are written, with as many yarns and holders.
#include "knit/run/knitters_order.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "knit/import/obj.h"
#include "knit/limbs/limb_plan.h"
#include "knit/model/stitch_size.h"
#include "knit/order/limb_order.h"
#include "knit/run/timeline.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

Parameters parameters_for(const Input& input, TimingKind timing, double width_percent) {
  Parameters parameters = default_parameters(input.bounds);
  give_width(parameters, width_percent / 100.0 * input.bounds.diagonal());
  parameters.timing.kind = timing;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  return resolved(parameters, input);
}

std::vector<TubeId> tubes_of_rows(const Fabric& fabric) {
  std::vector<TubeId> tubes;
  for (const auto& row : fabric.rows()) {
    if (tubes.empty() || tubes.back() != row->tube) tubes.push_back(row->tube);
  }
  return tubes;
}

std::vector<TubeId> tubes_of_pieces(const LimbPlan& plan) {
  std::vector<TubeId> tubes;
  for (const LimbPiece& piece : plan.pieces) tubes.push_back(piece.tube);
  return tubes;
}

// What the steps say that waits while a tube with rows is taken up.
std::int32_t most_told_to_wait(const Timeline& timeline) {
  std::int32_t most = 0;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    const auto* taken = get_if<TubeTaken>(timeline.step(i));
    if (taken != nullptr && taken->rows > 0) most = std::max(most, taken->held);
  }
  return most;
}

const TubesPlanned* planning_of(const Timeline& timeline) {
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    if (const auto* planned = get_if<TubesPlanned>(timeline.step(i))) return planned;
  }
  return nullptr;
}

std::shared_ptr<const Input> example_named(const char* name) {
  auto mesh = read_obj_file(std::filesystem::path(KNIT_ASSETS_DIR) / name / "mesh.obj");
  REQUIRE(std::holds_alternative<Mesh>(mesh));
  return make_input(std::get<Mesh>(std::move(mesh)));
}

// Whether it branches.
bool check_order(const std::shared_ptr<const Input>& input, const Parameters& parameters) {
  INFO("timing " << static_cast<int>(parameters.timing.kind) << ", w " << parameters.stitch.width);
  Timeline timeline(input, parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.stop() == nullptr);
  const State& state = timeline.furthest();
  if (!has_limbs(state)) return false;
  const TubePlan& plan = *state.tubes;
  const LimbPlan pieces = plan_limbs(state);
  const std::vector<TubeId> made = tubes_of_rows(state.fabric);
  CHECK(tubes_of_pieces(pieces) == made);
  CHECK(std::is_sorted(made.begin(), made.end()));  // letters rise
  CHECK(pieces.yarns == plan.yarns);
  CHECK(pieces.held_most == plan.held_most);
  CHECK(most_told_to_wait(timeline) == plan.held_most);
  const TubesPlanned* told = planning_of(timeline);
  REQUIRE(told != nullptr);
  CHECK(told->yarns == pieces.yarns);
  CHECK(told->held == pieces.held_most);
  CHECK(told->tried >= 2);
  // None that is found from here costs less.
  CHECK(pieces.cost <= cheapest_order(LimbTubes(state.fabric, &plan)).cost + 1e-9);
  return true;
}

}  // namespace

TEST_CASE("knitter's order: rows of the examples are made as their pieces are written") {
  constexpr std::array examples{"octopus", "starfish",     "mug",           "y", "trousers", "cup",
                                "torus",   "double-torus", "chain-of-three"};
  int branching = 0;
  for (const char* example : examples) {
    INFO(example);
    const auto input = example_named(example);
    for (const TimingKind timing : {TimingKind::linear, TimingKind::geodesic})
      branching += check_order(input, parameters_for(*input, timing, 4.0)) ? 1 : 0;
  }
  CHECK(branching >= 17);
}

TEST_CASE(
    "knitter's order: it is looked for among the stitches that are worked, whatever places and begins them") {
  const auto mug = example_named("mug"), starfish = example_named("starfish");
  Parameters by_sections = parameters_for(*mug, TimingKind::geodesic, 4.0);
  by_sections.stitches.placement = PlacementPolicy::thesis;
  CHECK(check_order(mug, by_sections));
  Parameters on_a_side = parameters_for(*starfish, TimingKind::linear, 4.0);
  on_a_side.rows.round_start = RoundStart::direction;
  CHECK(check_order(starfish, on_a_side));
  Parameters all = parameters_for(*starfish, TimingKind::linear, 4.0);
  all.stitches.placement = PlacementPolicy::even;
  all.rows.round_start = RoundStart::direction;
  all.rows.cast_on = 9;
  CHECK(check_order(starfish, all));
  // Nobody said which placement.
  Parameters by_itself = parameters_for(*starfish, TimingKind::linear, 4.0);
  by_itself.stitches.placement = PlacementPolicy::by_itself;
  CHECK(check_order(starfish, by_itself));
}

TEST_CASE("knitter's order: a placement turned anew finds it again, one that is turned midway leaves it") {
  const auto input = example_named("mug");
  const Parameters before = parameters_for(*input, TimingKind::geodesic, 4.0);
  Parameters after = before;
  after.stitches.placement = PlacementPolicy::thesis;
  Timeline first(input, before), second(input, after);
  first.extend_to_end();
  second.extend_to_end();
  const Shared<TubePlan> planned = first.furthest().tubes;
  REQUIRE(planned);
  REQUIRE(*planned != *second.furthest().tubes);
  Timeline midway = first;
  midway.seek(midway.position_of({Stage::stitches, 40, 0}));
  midway.edit_from_here(after);
  midway.extend_to_end();
  CHECK(*midway.furthest().tubes == *planned);
  first.tune(after);
  first.extend_to_end();
  CHECK(first.furthest() == second.furthest());
  const State& state = second.furthest();
  const UnorderedTubes at{*input, *state.timing, *state.graph, after.stitch, after.rows, after.stitches};
  const TubePlan unordered = plan_tubes(*state.graph, {after.stitch.width, after.stitch.height, 1});
  CHECK(in_knitters_order(at, unordered) == *state.tubes);
}

TEST_CASE("knitter's order: tubes without rows come right before the first that needs them") {
  // 0 and 1 meet in 2, which has no row; that and 3 meet in 4.
  TubePlan plan;
  plan.tubes.resize(5);
  plan.events = {{EventKind::cast_on}, {EventKind::cast_on}, {EventKind::cast_on},
                 {EventKind::join},    {EventKind::join},    {EventKind::bind_off}};
  const auto join = [&](std::size_t tube, std::int32_t bottom, std::int32_t top) {
    plan.tubes[tube].bottom = bottom;
    plan.tubes[tube].top = top;
    plan.tubes[tube].twins = {static_cast<TubeId>(tube)};
    plan.events[static_cast<std::size_t>(bottom)].above.push_back(static_cast<TubeId>(tube));
    plan.events[static_cast<std::size_t>(top)].below.push_back(static_cast<TubeId>(tube));
  };
  join(0, 0, 3);
  join(1, 1, 3);
  join(2, 3, 4);
  join(3, 2, 4);
  join(4, 4, 5);
  for (const std::size_t tube : {0U, 1U, 3U, 4U}) plan.tubes[tube].curves.resize(2);
  const std::vector<TubeId> order = with_rowless(plan, {1, 3, 0, 4});
  CHECK(order == std::vector<TubeId>{1, 3, 0, 2, 4});
  CHECK_THROWS(with_rowless(plan, {1, 4, 3, 0}));  // 4 before what it stands on
  CHECK_THROWS(with_rowless(plan, {1, 3, 0}));     // 4 is left out

  const TubePlan numbered = renumbered(plan, {order, 2, 3, false});
  CHECK(numbered.order == std::vector<TubeId>{0, 1, 2, 4, 3});
  CHECK(numbered.events[3].below == std::vector<TubeId>{2, 0});
  CHECK(numbered.tube(4).rows() == 0);
  CHECK(numbered.tube(0).bottom == 1);
  CHECK(numbered.tube(0).twins == std::vector<TubeId>{0});
  CHECK(numbered.yarns == 3);
}
