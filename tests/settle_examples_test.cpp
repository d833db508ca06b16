// Settling over all examples, and over meshes by others where they lie: only positions change, twins stay alike, and what
// sticks out stays covered.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "app/files/load.h"
#include "app/session/action.h"
#include "knit/import/check.h"
#include "knit/import/obj.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/closeness.h"
#include "knit/run/timeline.h"
#include "tests/stress/settling.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"

using namespace knit;

namespace {

State run_of(const std::shared_ptr<const Input>& input, Parameters parameters, Settling settling) {
  parameters.settle.settling = settling;
  Timeline timeline(input, resolved(parameters, *input));
  timeline.extend_to_end();
  return timeline.furthest();
}

double diagonal_share(const Input& input, const State& state) {
  const auto closeness = measure_closeness(input, state);
  return closeness ? closeness->mesh_to_knit.max / input.bounds.diagonal() : 0.0;
}

// Of the wales between rows of one tube, over all that are there.
double wale_mean(const State& state, TubeId tube) {
  double sum = 0.0;
  std::size_t count = 0;
  const std::vector<glm::dvec3> path = knitting_path(state.fabric);
  for (const auto& strip : state.fabric.strips()) {
    if (state.fabric.row(strip->to).tube != tube) continue;
    for (const auto& [lower, upper] : strip->column_edges) sum += glm::distance(path[lower], path[upper]);
    count += strip->column_edges.size();
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

// By how much wales of tubes that are alike differ in the mean, at most.
double twins_apart(const State& state) {
  double apart = 0.0;
  if (!state.tubes) return apart;
  for (std::size_t tube = 0; tube < state.tubes->tubes.size(); ++tube) {
    const double own = wale_mean(state, static_cast<TubeId>(tube));
    for (const TubeId twin : state.tubes->tubes[tube].twins) {
      const double other = wale_mean(state, twin);
      if (own > 0.0 && other > 0.0) apart = std::max(apart, std::abs(own - other) / own);
    }
  }
  return apart;
}

// `uncovered`: by how much of the diagonal the mesh's farthest place may come to lie farther from the knit mesh.
void check_settling(const std::shared_ptr<const Input>& input, const Parameters& parameters,
                    double uncovered) {
  const State unsettled = run_of(input, parameters, Settling::off);
  const State settled = run_of(input, parameters, Settling::on);
  REQUIRE(unsettled.finished());
  REQUIRE(settled.finished());
  CHECK(test_support::broken_settling(*input, settled, unsettled) == std::string());
  CHECK(diagonal_share(*input, settled) <= diagonal_share(*input, unsettled) + uncovered);
  CHECK(twins_apart(settled) <= std::max(0.05, twins_apart(unsettled)));
}

}  // namespace

TEST_CASE("settle examples: only positions change") {
  std::size_t number = 0;
  for (const std::string& name : app::list_examples(KNIT_ASSETS_DIR)) {
    if (!test_support::is_tried(number++)) continue;
    CAPTURE(name);
    auto loaded = app::load_example(KNIT_ASSETS_DIR, name);
    REQUIRE(std::holds_alternative<app::Loaded>(loaded));
    const auto& example = std::get<app::Loaded>(loaded);
    check_settling(example.input, example.parameters, 0.02);
  }
}

#ifdef KNIT_SHARED_MESHES
TEST_CASE("settle examples: only positions change on meshes by others") {
  const std::filesystem::path folder = KNIT_SHARED_MESHES;
  if (!std::filesystem::exists(folder)) return;  // not part of the sources
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".obj") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::size_t number = 0;
  for (const std::filesystem::path& file : files) {
    if (!test_support::is_tried(number++)) continue;
    CAPTURE(file.filename().string());
    auto read = read_obj_file(file);
    if (!std::holds_alternative<Mesh>(read) || !check(std::get<Mesh>(read)).fit()) continue;
    const auto input = make_input(std::get<Mesh>(std::move(read)));
    Parameters parameters = default_parameters(input->bounds);
    give_width(parameters, 0.04 * input->bounds.diagonal());
    parameters.timing.kind = TimingKind::by_itself;
    parameters.rows.source = RowSource::contours;
    parameters.stitches.placement = PlacementPolicy::nearest;
    check_settling(input, parameters, 0.025);
  }
}
#endif
