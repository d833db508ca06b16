// Figures of stitches placed and settled: how far they went, what turned over, what they slid off.
#include "knit/quality/ease.h"

#include <glm/geometric.hpp>

#include "knit/insight/problems.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/closeness.h"
#include "knit/quality/quality.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/tube.h"

using namespace knit;
using test_support::HandTube;

namespace {

HandTube upright() { return {{24, 24, 24, 24, 24, 24, 24}, 1.0, 0.5, 0.0}; }

// As if its stitches had settled where `move` takes them.
template <class Move>
State settled_to(const State& state, Move move) {
  State made = test_support::moved(state, move);
  made.placed = Shared(knitting_path(state.fabric));
  return made;
}

Timeline arch_run(Settling settling) {
  const auto input = make_input(test_support::arch());
  Parameters parameters = default_parameters(input->bounds);
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters.settle.settling = settling;
  give_width(parameters, 0.2);
  Timeline timeline(input, resolved(parameters, *input));
  timeline.extend_to_end();
  REQUIRE(timeline.furthest().finished());
  return timeline;
}

}  // namespace

TEST_CASE("ease: moves are measured from where stitches were placed, and none before anything settles") {
  const State state = test_support::tube_state(upright());
  CHECK_FALSE(measure_moves(state));
  CHECK_FALSE(move_of(state, {1, 0}));
  const State one = settled_to(state, [](const glm::dvec3& p) {
    return p.y > 2.9 && p.z < -0.99 ? p + glm::dvec3(0.0, 0.0, -0.25) : p;
  });
  const auto moves = measure_moves(one);
  REQUIRE(moves);
  CHECK(moves->most == Approx(0.25));
  CHECK(moves->mean == Approx(0.25 / (7.0 * 24.0)));
  CHECK(moves->of == StitchRef{7, 0});
  const auto move = move_of(one, {7, 0});
  REQUIRE(move);
  CHECK(move->from.z == Approx(-1.0));
  CHECK(move->to.z == Approx(-1.25));
  CHECK(placed_state(one).fabric == state.fabric);
  CHECK_FALSE(placed_state(one).placed);
  CHECK(placed_state(state).fabric == state.fabric);
}

TEST_CASE("ease: a face with its inside out is found, in a fabric that is inside out as well") {
  const State state = test_support::tube_state(upright());
  const auto input = make_input(test_support::cylinder(24, 1.0, 3.0, 3));
  CHECK(measure_turned(*input, state).faces == 0);
  // Two stitches of the fourth row change places: the faces beside them turn over.
  const auto fourth = [](const glm::dvec3& p) { return p.y > 1.4 && p.y < 1.6; };
  const State crossed = test_support::moved(
      state, [&](const glm::dvec3& p) { return fourth(p) && p.z < -0.99 ? glm::dvec3(0.6, p.y, -0.8) : p; });
  const TurnedFaces turned = measure_turned(*input, crossed);
  CHECK(turned.faces > 0);
  CHECK(turned.faces <= 6);
  CHECK(turned.at.row >= 3);
  CHECK(turned.at.row <= 4);
  const auto mirrored = [](const glm::dvec3& p) { return glm::dvec3(-p.x, p.y, p.z); };
  CHECK(measure_turned(*input, test_support::moved(crossed, mirrored)).faces == turned.faces);
  CHECK(measure_turned(*input, State{}).faces == 0);
}

TEST_CASE("ease: what stitches were placed on and left is told as slid off") {
  const State state = test_support::tube_state(upright());
  const auto input = make_input(test_support::mesh_of(state));
  const auto down = [](const glm::dvec3& p) { return glm::dvec3(p.x, 0.5 * p.y, p.z); };
  const double height = 0.25;
  const Uncovered slid = measure_uncovered(*input, settled_to(state, down), 0.26, height);
  REQUIRE(slid.places.size() == 1);
  CHECK(slid.share == Approx((1.5 - height) / 3.0).margin(0.02));
  CHECK(slid.places[0].kind == UncoveredKind::slid);
  // The same, but never placed there.
  const Uncovered never = measure_uncovered(*input, test_support::moved(state, down), 0.26, height);
  REQUIRE(never.places.size() == 1);
  CHECK(never.places[0].kind != UncoveredKind::slid);
  Coverage coverage;
  coverage.uncovered = slid;
  coverage.turned = {3, {12, 4}};
  Parameters parameters;
  parameters.settle.settling = Settling::on;
  const auto remarks = remarks_on(coverage, parameters);
  REQUIRE(remarks.size() == 2);
  CHECK(remarks[0].words.find(", which the stitches slid off. A greater weight of cover") !=
        std::string::npos);
  CHECK(remarks[1].words ==
        "3 faces lie turned over, the first at row 12. A greater weight of folds turns them back.");
  CHECK(remarks[1].at == StitchRef{12, 4});
}

TEST_CASE("ease: both figures of a run that settles, and its placed ones are those of a run that does not") {
  const Timeline settled = arch_run(Settling::by_itself), stays = arch_run(Settling::off);
  const State &end = settled.furthest(), &plain = stays.furthest();
  CHECK_FALSE(plain.placed);
  REQUIRE(end.placed);
  const StitchSize& stitch = settled.parameters().stitch;
  const auto quality = [&](const State& state) {
    return measure_quality(settled.input(), state, stitch.width, stitch.height);
  };
  const Quality placed = quality(placed_state(end)), before = quality(plain), after = quality(end);
  CHECK(placed.wale.cv == before.wale.cv);
  CHECK(placed.corner_off.mean == before.corner_off.mean);
  CHECK(after.wale.cv < 0.5 * placed.wale.cv);
  CHECK(after.wale.high < placed.wale.high);
  CHECK(after.corner_off.mean < placed.corner_off.mean);
  CHECK(after.corner_off.count == placed.corner_off.count);
  CHECK(measure_moves(end)->mean > 0.0);
  const auto close = measure_closeness(settled.input(), end, stitch.width, stitch.height);
  const auto without = measure_closeness(stays.input(), plain, stitch.width, stitch.height);
  REQUIRE(close);
  REQUIRE(close->placed);
  CHECK_FALSE(close->placed->placed);
  CHECK_FALSE(without->placed);
  CHECK(close->placed->knit_to_mesh.max == without->knit_to_mesh.max);
  CHECK(close->placed->coverage->uncovered.share == without->coverage->uncovered.share);
  CHECK(close->knit_to_mesh.max != without->knit_to_mesh.max);
}
