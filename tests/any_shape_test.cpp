// Shapes that branch, bend and have handles, from the first step to the last: every promise, and how well they are knitted.
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include "knit/import/obj.h"
#include "knit/limbs/limb_plan.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/measures.h"
#include "knit/quality/quality.h"
#include "knit/run/timeline.h"
#include "tests/support/catch.h"
#include "tests/support/promises.h"

using namespace knit;

#ifdef KNIT_SHARED_MESHES
namespace {

struct Case {
  const char* mesh;
  TimingKind timing;
  double width_percent;  // of the bounding box's diagonal
  std::int32_t genus, openings;
  // As worked out apart from this program, within 4 %: heights are measured otherwise here, and a count near a half may go
  // either way.
  std::int32_t rows, stitches;
  double wale_cv;  // at most: what was measured there, and a twentieth
};

constexpr TimingKind linear = TimingKind::linear, geodesic = TimingKind::geodesic;
constexpr std::array cases{Case{"bunny", linear, 4, 0, 5, 39, 783, 0.352},
                           Case{"bunny", geodesic, 4, 0, 5, 41, 817, 0.384},
                           Case{"bunny", linear, 2, 0, 10, 84, 3082, 0.327},
                           Case{"bunny", geodesic, 2, 0, 5, 79, 3133, 0.489},
                           Case{"spot", linear, 4, 0, 7, 44, 749, 0.361},
                           Case{"spot", geodesic, 4, 0, 7, 39, 750, 0.2415},  // 735 stitches there
                           Case{"spot", geodesic, 2, 0, 9, 77, 2981, 0.302},
                           Case{"teddy", linear, 4, 0, 6, 42, 756, 0.207},
                           Case{"teddy", geodesic, 2, 0, 6, 92, 2960, 0.168},
                           Case{"y", geodesic, 4, 0, 3, 39, 503, 0.102},
                           Case{"trousers", linear, 2, 0, 3, 91, 3085, 0.074},
                           Case{"starfish", linear, 4, 0, 5, 40, 448, 0.242},
                           Case{"starfish", geodesic, 2, 0, 5, 92, 1790, 0.140},
                           Case{"octopus", linear, 4, 0, 10, 79, 650, 0.208},
                           Case{"octopus", geodesic, 4, 0, 9, 82, 703, 0.132},
                           Case{"mug", linear, 4, 1, 2, 56, 1476, 0.164},
                           Case{"mug", geodesic, 4, 1, 3, 54, 1524, 0.197},
                           Case{"double-torus", linear, 4, 2, 2, 55, 733, 0.161},
                           Case{"chain3", linear, 2, 3, 2, 110, 2319, 0.178},
                           Case{"simple-torus", linear, 4, 1, 2, 40, 907, 0.175},
                           Case{"simple-torus", geodesic, 2, 1, 2, 84, 3618, 0.138},
                           Case{"cup", linear, 4, 0, 2, 32, 1017, 0.150},
                           Case{"trousers", linear, 4, 0, 3, 45, 772, 0.0714},
                           Case{"octopus", geodesic, 2, 0, 9, 156, 2630, 0.147},
                           Case{"mug", geodesic, 2, 1, 3, 110, 6152, 0.137},
                           Case{"double-torus", geodesic, 4, 2, 2, 56, 717, 0.1428},
                           Case{"table", geodesic, 4, 0, 5, 71, 1164, 0.287}};

std::shared_ptr<const Input> mesh_named(const std::filesystem::path& file) {
  auto read = read_obj_file(file);
  REQUIRE(std::holds_alternative<Mesh>(read));
  return make_input(std::get<Mesh>(std::move(read)));
}

// Rows are made as the pieces are written, with as many yarns and holders.
void check_order(const State& state) {
  if (!has_limbs(state)) return;
  const LimbPlan pieces = plan_limbs(state);
  RowId row = 0;
  bool same = true;
  for (const LimbPiece& piece : pieces.pieces) {
    for (const RowId of_piece : piece.rows) same = same && of_piece == ++row;
  }
  CHECK(same);
  CHECK(pieces.yarns == state.tubes->yarns);
  CHECK(pieces.held_most == state.tubes->held_most);
}

void check_case(const Case& wanted, const std::filesystem::path& folder) {
  INFO(wanted.mesh << ", timing " << static_cast<int>(wanted.timing) << ", w " << wanted.width_percent
                   << " %");
  const auto input = mesh_named(folder / (std::string(wanted.mesh) + ".obj"));
  Parameters parameters = default_parameters(input->bounds);
  give_width(parameters, wanted.width_percent / 100.0 * input->bounds.diagonal());
  parameters.timing.kind = wanted.timing;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters = resolved(parameters, *input);
  Timeline timeline(input, parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.stop() == nullptr);
  const State& state = timeline.furthest();
  CHECK(test_support::broken_promise(state) == "");
  check_order(state);
  CHECK(genus_of(*state.tubes) == wanted.genus);
  CHECK(euler_characteristic(state) == 2 - 2 * wanted.genus - wanted.openings);
  CHECK(state.fabric.row_count() == Approx(wanted.rows).epsilon(0.04));
  CHECK(static_cast<double>(state.fabric.stitch_count()) == Approx(wanted.stitches).epsilon(0.04));
  const Quality quality = measure_quality(*input, state, parameters.stitch.width, parameters.stitch.height);
  CHECK(quality.wale.cv <= wanted.wale_cv);
  double mean = 0.0;
  for (const RowFit& row : quality.rows) mean += row.course_cv;
  CHECK(mean / static_cast<double>(quality.rows.size()) <= 0.06);
}

}  // namespace

TEST_CASE("any shape: meshes by others are knitted from end to end, as well as elsewhere") {
  const std::filesystem::path folder = KNIT_SHARED_MESHES;
  if (!std::filesystem::exists(folder / "bunny.obj")) return;  // not part of the sources
  for (const Case& wanted : cases) check_case(wanted, folder);
}
#endif
