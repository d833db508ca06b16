#include "tests/benchmark/branching.h"

#include <array>
#include <functional>
#include <optional>

#include "knit/model/stitch_size.h"
#include "tests/benchmark/ball_file.h"
#include "tests/benchmark/cost.h"
#include "tests/benchmark/desk.h"
#include "tests/benchmark/pipeline.h"
#include "tests/stress/cubes.h"

namespace benchmark {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;
using Cell = test_support::CubeGrid::Cell;

// About as large as the meshes that people have of such bears, along y.
knit::Mesh bear() {
  struct Part {
    Cell low, high;
  };
  constexpr std::array parts{Part{{2, 2, 0}, {4, 4, 2}},  // the body
                             Part{{2, 5, 0}, {4, 6, 2}},  // the head
                             Part{{2, 7, 1}, {2, 7, 1}}, Part{{4, 7, 1}, {4, 7, 1}},
                             Part{{0, 4, 1}, {1, 4, 1}}, Part{{5, 4, 1}, {6, 4, 1}},
                             Part{{2, 0, 1}, {2, 1, 1}}, Part{{4, 0, 1}, {4, 1, 1}}};
  test_support::CubeGrid grid({7, 8, 3});
  for (const auto& [low, high] : parts)
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int z = low[2]; z <= high[2]; ++z) grid.fill({x, y, z});
  grid.make_solid();
  knit::Mesh mesh = grid.surface(6);
  test_support::round_off(mesh, 12);
  mesh.name = "bear";
  return mesh;
}

knit::Parameters branching(knit::Parameters parameters, const knit::Input& input, knit::TimingKind timing) {
  parameters.timing.kind = timing;
  parameters.timing.axis = {knit::AxisKind::y, {0.0, 1.0, 0.0}};
  parameters.rows.source = knit::RowSource::contours;
  parameters.stitches.placement = knit::PlacementPolicy::nearest;
  knit::give_width(parameters, 0.02 * input.bounds.diagonal());
  return knit::resolved(parameters, input);
}

app::Loaded with_timing(app::Loaded loaded, knit::TimingKind timing) {
  loaded.parameters = branching(loaded.parameters, *loaded.input, timing);
  return loaded;
}

// All other stages beside the one that solves.
double rest_over_solve(const Json& stage_ms) {
  const std::string solve(knit::name_of(knit::Stage::timing));
  double rest = 0.0;
  for (const auto& [name, ms] : stage_ms.items()) rest += name == solve ? 0.0 : ms.get<double>();
  return rest / stage_ms[solve].get<double>();
}

// As a hand drags a knob: a little further each frame, until the run is whole again and shown. Milliseconds of the program's
// own thread, without drawing. `set`: the parameters for a factor from 0.9 to 1.1.
using Knob = std::function<void(knit::Parameters& parameters, double factor)>;
Json measure_dragging(Desk& desk, const Knob& set) {
  const knit::Parameters first = desk.session.document->timeline.parameters();
  std::vector<Cost> frame, rest, described, panels;
  constexpr int frames = 60;
  for (int i = 0; i <= frames; ++i) {
    knit::Parameters tuned = first;
    set(tuned, 0.9 + 0.2 * i / frames);
    frame.push_back(cost_of([&] {
      desk.act(app::Tune{tuned, true});
      desk.act(app::PassTime{1.0 / 60.0});
    }));
    rest.push_back(cost_of([&] {
      while (!desk.session.document->timeline.complete()) desk.act(app::PassTime{1.0 / 60.0});
    }));
    described.push_back(cost_of([&] { desk.describe(); }));
    panels.push_back(cost_of([&] { desk.panels(); }));
  }
  desk.act(app::Tune{first, true});
  desk.finish();
  return {{"first_frame_ms", summary_of(frame, &Cost::thread_ms)},
          {"describe_ms", summary_of(described, &Cost::thread_ms)},
          {"panels_ms", summary_of(panels, &Cost::thread_ms)},
          {"change_to_picture_ms", sums_of({frame, rest, described, panels}, &Cost::thread_ms)}};
}

Json measure_knobs(const fs::path& assets, const fs::path& file) {
  Desk desk(assets);
  desk.session.jobs->beside = false;
  desk.act(app::OpenFile{file});
  const knit::Timeline& timeline = desk.session.document->timeline;
  desk.act(app::Tune{branching(timeline.parameters(), timeline.input(), knit::TimingKind::linear)});
  desk.finish();
  Json json;
  json["stitch_width"] = measure_dragging(
      desk, [](knit::Parameters& p, double factor) { knit::give_width(p, factor * p.stitch.width); });
  json["epsilon"] = measure_dragging(
      desk, [](knit::Parameters& p, double factor) { knit::give_epsilon(p, factor * p.epsilon()); });
  return json;
}

}  // namespace

Json measure_branching(const fs::path& assets, const fs::path& mesh) {
  std::optional<MeshFile> made;
  if (mesh.empty()) made.emplace("bear", bear());
  const fs::path file = mesh.empty() ? made->path : mesh;
  auto read = app::load_file(file);
  if (const auto* error = std::get_if<std::string>(&read)) return {{"left_out", *error}};
  const auto& loaded = std::get<app::Loaded>(read);
  const std::string text = read_text(file);
  const app::Loaded linear = with_timing(loaded, knit::TimingKind::linear);
  Json json;
  json["mesh"] = mesh.empty() ? "bear" : mesh.stem().string();
  json["triangles"] = loaded.input->mesh.triangles.size();
  json["linear"] = measure_against_parsing(linear, text, 31);
  json["geodesic"] = measure_against_parsing(with_timing(loaded, knit::TimingKind::geodesic), text, 31);
  json["geodesic"]["rest_over_solve"] = rest_over_solve(json["geodesic"]["stage_ms"]);
  knit::Timeline timeline(linear.input, linear.parameters);
  timeline.extend_to_end();
  if (timeline.furthest().tubes) json["tubes"] = timeline.furthest().tubes->tubes.size();
  json["seek"] = measure_seeks(timeline);
  json["history"] = measure_history(timeline);
  json["drag"] = measure_knobs(assets, file);
  return json;
}

}  // namespace benchmark
