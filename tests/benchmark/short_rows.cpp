#include "tests/benchmark/short_rows.h"

#include <array>
#include <string>

#include "app/files/load.h"
#include "app/session/presets.h"
#include "knit/model/stitch_size.h"
#include "knit/run/machine.h"
#include "tests/benchmark/cost.h"

namespace benchmark {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr int turns = 5;

double run_ms(const app::Loaded& loaded, knit::TimingKind timing, knit::ShortRows rows) {
  knit::Parameters parameters = app::with_preset(*app::find_preset("best-rows"), loaded.parameters);
  parameters.timing.kind = timing;
  parameters.short_rows.rows = rows;
  parameters = knit::resolved(parameters, *loaded.input);
  return cost_of([&] {
           knit::State state;
           while (!state.finished() && !knit::is_stop(knit::advance(*loaded.input, parameters, state))) {
           }
         })
      .thread_ms;
}

std::vector<fs::path> examples(const fs::path& assets) {
  std::vector<fs::path> meshes;
  for (const char* name : {"heel", "y", "trousers", "starfish", "octopus"})
    meshes.push_back(assets / name / "mesh.obj");
  return meshes;
}

std::string name_of(const fs::path& mesh) {
  return (mesh.stem() == "mesh" ? mesh.parent_path().filename() : mesh.stem()).string();
}

}  // namespace

Json measure_short_rows(const fs::path& assets, const std::vector<fs::path>& meshes) {
  Json json;
  double all_without = 0.0, all_with = 0.0;
  for (const fs::path& mesh : meshes.empty() ? examples(assets) : meshes) {
    const auto read = app::load_file(mesh);
    if (const auto* error = std::get_if<std::string>(&read)) {
      json["left_out"].push_back(*error);
      continue;
    }
    const auto& loaded = std::get<app::Loaded>(read);
    for (const knit::TimingKind timing : {knit::TimingKind::linear, knit::TimingKind::geodesic}) {
      std::vector<Cost> without, with;
      for (int i = 0; i < turns; ++i) {
        without.push_back({run_ms(loaded, timing, knit::ShortRows::off)});
        with.push_back({run_ms(loaded, timing, knit::ShortRows::automatic)});
      }
      const double off = median_of(without, &Cost::thread_ms), on = median_of(with, &Cost::thread_ms);
      all_without += off;
      all_with += on;
      json["runs"].push_back({{"mesh", name_of(mesh)},
                              {"timing", timing == knit::TimingKind::linear ? "linear" : "geodesic"},
                              {"without_ms", off},
                              {"with_ms", on},
                              {"ratio", on / off}});
    }
  }
  if (all_without > 0.0) json["ratio"] = all_with / all_without;
  return json;
}

}  // namespace benchmark
