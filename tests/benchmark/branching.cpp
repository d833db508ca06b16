#include "tests/benchmark/branching.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <thread>

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

// What the window's own thread does in a frame, without drawing.
struct Frames {
  std::vector<Cost> act, described, panels;
  std::chrono::steady_clock::time_point due = std::chrono::steady_clock::now();

  void begin(Desk& desk) {
    act.push_back(cost_of([&] { desk.act(app::PassTime{1.0 / 60.0}); }));
    described.push_back(cost_of([&] { desk.describe(); }));
    panels.push_back(cost_of([&] { desk.panels(); }));
  }
  // Sixty a second.
  void wait() {
    due += std::chrono::microseconds(16667);
    std::this_thread::sleep_until(due);
  }
  [[nodiscard]] Json json() const {
    return {{"own_ms", sums_of({act, described, panels}, &Cost::thread_ms)},
            {"act_ms", summary_of(act, &Cost::thread_ms)},
            {"describe_ms", summary_of(described, &Cost::thread_ms)},
            {"panels_ms", summary_of(panels, &Cost::thread_ms)}};
  }
};

// As a hand drags a knob in a window, sixty frames a second there and back; and how many frames ago the knob stood where
// the picture shows it. `set`: the parameters for a factor from 0.9 to 1.1.
using Knob = std::function<void(knit::Parameters& parameters, double factor)>;
Json measure_dragging(Desk& desk, const Knob& set) {
  const knit::Parameters first = desk.session.document->timeline.parameters();
  Frames frames;
  std::vector<double> behind;
  std::vector<knit::Parameters> wished{first};
  constexpr int dragged = 240;
  for (int i = 0; i < dragged; ++i) {
    const knit::Timeline& timeline = desk.session.document->timeline;
    frames.begin(desk);
    const auto shown = std::find(wished.rbegin(), wished.rend(), timeline.base_parameters());
    behind.push_back(static_cast<double>(shown - wished.rbegin()));
    knit::Parameters tuned = first;
    set(tuned, 1.0 + 0.1 * std::sin(0.05 * i));
    const Cost tuning = cost_of([&] { desk.act(app::Tune{tuned, true}); });
    frames.act.back().thread_ms += tuning.thread_ms;
    wished.push_back(timeline.parameters());
    frames.wait();
  }
  desk.act(app::Tune{first, true});
  desk.finish();
  Json json = frames.json();
  json["frames_behind"] = {
      {"median", quantile(behind, 0.5)}, {"p99", quantile(behind, 0.99)}, {"max", quantile(behind, 1.0)}};
  return json;
}

// What follows when the knob is let go: frames until the run is complete, in which stitches settle.
Json measure_settling(Desk& desk) {
  knit::Parameters tuned = desk.session.document->timeline.parameters();
  knit::give_width(tuned, 1.05 * tuned.stitch.width);
  desk.act(app::Tune{tuned, true});
  Frames frames;
  while (!desk.session.document->timeline.complete()) {
    frames.begin(desk);
    frames.wait();
  }
  const knit::State& end = desk.session.document->timeline.furthest();
  Json json = frames.json();
  json["frames"] = frames.act.size();
  json["stitches"] = end.fabric.stitch_count();
  return json;
}

Json measure_knobs(const fs::path& assets, const fs::path& file) {
  Desk desk(assets);
  desk.session.jobs->beside = false;
  desk.act(app::OpenFile{file});
  desk.session.jobs->beside = true;
  const knit::Timeline& timeline = desk.session.document->timeline;
  desk.act(app::Tune{branching(timeline.parameters(), timeline.input(), knit::TimingKind::linear)});
  desk.finish();
  Json json;
  json["third_of_a_frame_ms"] = 1000.0 / 60.0 / 3.0;
  json["stitch_width"] = measure_dragging(
      desk, [](knit::Parameters& p, double factor) { knit::give_width(p, factor * p.stitch.width); });
  json["settling"] = measure_settling(desk);
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
