// Short rows in the tubes of shapes that branch: which rows a tube keeps, what its chart lies between, and whether they pay.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "knit/import/obj.h"
#include "knit/mesh/branching_shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/measures.h"
#include "knit/run/kept_trial.h"
#include "knit/run/machine.h"
#include "knit/run/short_rows_due.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

struct Piece {
  std::shared_ptr<const Input> input;
  Parameters parameters;
  State state;
};

Piece piece_of(Mesh mesh, TimingKind kind, double width_percent) {
  Piece piece{make_input(std::move(mesh)), {}, {}};
  Parameters& parameters = piece.parameters;
  parameters = default_parameters(piece.input->bounds);
  const double width = width_percent / 100.0 * piece.input->bounds.diagonal();
  give_width(parameters, width);
  give_height(parameters, 0.72 * width);
  parameters.timing.kind = kind;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters.settle.settling = Settling::on;
  parameters.short_rows.rows = ShortRows::automatic;
  parameters = resolved(parameters, *piece.input);
  return piece;
}

void run_to(Piece& piece, Stage stage) {
  while (piece.state.stage() < stage)
    REQUIRE_FALSE(is_stop(advance(*piece.input, piece.parameters, piece.state)));
}

// How far a curve is from another at most, by points.
double farthest(const Ring& from, const Ring& to) {
  double far = 0.0;
  for (const glm::dvec3& point : from.points)
    far = std::max(far, glm::distance(point, point_at(to, nearest_arc(to, point))));
  return far;
}

std::int32_t pairs_in(const Fabric& fabric) {
  return static_cast<std::int32_t>(std::count_if(fabric.rows().begin(), fabric.rows().end(),
                                                 [](const auto& row) { return is_short(*row); })) /
         2;
}

}  // namespace

TEST_CASE("kept rows: charts lie between the rows that are kept beside events") {
  Piece piece = piece_of(letter_y(0.08), TimingKind::linear, 3.0);
  run_to(piece, Stage::cast_on);
  const State& state = piece.state;
  const TubePlan& plan = *state.tubes;
  const std::vector<double> field = field_of(*piece.input, *state.graph);
  const double hair = 0.05 * plan.stitch_width;
  std::size_t charts = 0;
  for (const std::int32_t beside : {0, 2}) {
    for (TubeId id = 0; id < static_cast<TubeId>(plan.tubes.size()); ++id) {
      if (!can_be_charted(plan, id, beside)) continue;
      const Tube& tube = plan.tube(id);
      const KeptRows kept = rows_kept(plan, id, beside);
      CHECK(kept.low == (plan.event(tube.bottom).kind == EventKind::cast_on ? 0 : beside));
      CHECK(kept.high == (plan.event(tube.top).kind == EventKind::bind_off ? 0 : beside));
      const ChartAt at{
          *piece.input, field, plan, id, kept, piece.parameters.stitch, piece.parameters.short_rows, false};
      std::optional<PlannedPairs> pairs;
      while (!advance_planning(at, pairs).done) {
      }
      if (!pairs->chart) continue;
      ++charts;
      CHECK(pairs->chart->residual < greatest_residual);
      const auto low = static_cast<std::size_t>(kept.low),
                 high = static_cast<std::size_t>(tube.rows() - 1 - kept.high);
      CHECK(farthest(ring_at(*pairs->chart, 0.0, 0.0), *tube.curves[low]) < hair);
      CHECK(farthest(ring_at(*pairs->chart, pairs->chart->last_level(), 0.0), *tube.curves[high]) < hair);
      // The chart's rounds are about as many as the rows whose place they take.
      CHECK(std::abs(pairs->rounds.gaps() - (tube.rows() - 1 - kept.high - kept.low)) <= 2);
    }
  }
  CHECK(charts >= 5);
}

TEST_CASE("kept rows: a tube of few rows is not charted") {
  Piece piece = piece_of(letter_y(0.08), TimingKind::linear, 12.0);
  run_to(piece, Stage::cast_on);
  const TubePlan& plan = *piece.state.tubes;
  bool few = false;
  for (TubeId id = 0; id < static_cast<TubeId>(plan.tubes.size()); ++id) few |= !can_be_charted(plan, id, 2);
  CHECK(few);
}

TEST_CASE("kept rows: a stitch that is changed after the first row leaves later tubes their short rows") {
  Piece piece = piece_of(letter_y(0.08), TimingKind::linear, 3.0);
  run_to(piece, Stage::cast_on);
  State& state = piece.state;
  state.short_rows.kept = 1;
  state.short_rows.chosen_for = to_choose_for(piece.parameters);
  while (state.fabric.row_count() < 3) advance(*piece.input, piece.parameters, state);
  const std::size_t before = state.short_rows.tubes.size();
  give_width(piece.parameters, 0.97 * piece.parameters.stitch.width);
  piece.parameters = resolved(piece.parameters, *piece.input);
  run_to(piece, Stage::settle);
  CHECK(state.short_rows.kept == 1);
  CHECK(state.short_rows.tubes.size() > before);
  for (std::size_t i = before; i < state.short_rows.tubes.size(); ++i)
    CHECK(state.short_rows.tubes[i]->stitch_width == piece.parameters.stitch.width);
}

TEST_CASE("kept rows: of equal ways the first is taken") {
  const std::vector<KeptTry> tries{
      {no_short_rows, 0, 100, 0.0F, 0.05F}, {0, 3, 104, 0.0F, 0.04F}, {1, 2, 103, 0.0F, 0.04F}};
  CHECK(best_of(tries).kept == 0);
}

TEST_CASE("kept rows: a way is never taken that leaves wales less even or a longer one") {
  const KeptTry without{no_short_rows, 0, 100, 0.060F, 0.05F, 1.30F};
  const KeptTry uneven{0, 3, 104, 0.066F, 0.03F, 1.20F}, longer{1, 3, 104, 0.050F, 0.03F, 1.35F};
  const KeptTry better{2, 3, 104, 0.060F, 0.04F, 1.30F}, stops{0, 0, 0, 0.0F, INFINITY};
  CHECK(best_of(std::vector{without, uneven, longer}).kept == no_short_rows);
  CHECK(best_of(std::vector{without, uneven, longer, better}).kept == 2);
  // Below what is seen, length does not count.
  const KeptTry even{no_short_rows, 0, 100, 0.060F, 0.05F, 1.10F}, seen{0, 2, 104, 0.040F, 0.03F, 1.21F};
  const KeptTry unseen{0, 2, 104, 0.040F, 0.03F, 1.19F};
  CHECK(best_of(std::vector{even, seen}).kept == no_short_rows);
  CHECK(best_of(std::vector{even, unseen}).kept == 0);
  CHECK(best_of(std::vector{without, stops}).kept == no_short_rows);
  CHECK(best_of(std::vector{KeptTry{no_short_rows, 0, 0, 0.0F, INFINITY}, uneven}).kept == 0);
}

#ifdef KNIT_SHARED_MESHES
TEST_CASE("kept rows: a shape that branches gets short rows where it settles better with them") {
  const std::filesystem::path folder = KNIT_SHARED_MESHES;
  if (!std::filesystem::exists(folder / "spot.obj")) return;  // not part of the sources
  Piece piece = piece_of(std::get<Mesh>(read_obj_file(folder / "spot.obj")), TimingKind::linear, 4.0);
  run_to(piece, Stage::pattern);
  const State& state = piece.state;
  REQUIRE(state.short_rows.tries.size() == 4);
  const KeptTry& best = best_of(state.short_rows.tries);
  REQUIRE(state.short_rows.kept);
  CHECK(*state.short_rows.kept == best.kept);
  CHECK(best.kept != no_short_rows);
  CHECK(best.sum < 0.8 * state.short_rows.tries.front().sum);
  CHECK(pairs_in(state.fabric) == best.pairs);
  CHECK(static_cast<std::int32_t>(state.fabric.stitch_count()) == best.stitches);
  CHECK(wale_figures(state).cv < 0.09);
  Piece plain = piece;
  plain.state = {};
  plain.parameters.short_rows.rows = ShortRows::off;
  run_to(plain, Stage::pattern);
  CHECK(euler_characteristic(state) == euler_characteristic(plain.state));
  CHECK(wale_figures(state).cv < wale_figures(plain.state).cv - 0.01);
}
#endif
