// What the program costs, as ratios measured in one run: JSON on standard output.
//
//   build/dev/benchmark [MESH.obj]      (without a mesh: the thesis sphere)
//   build/dev/benchmark --travel        (changed parameters to pictures, scrubbing a million steps)
//   build/dev/benchmark --tuning        (of these only the first)
//   build/dev/benchmark --sweep         (only 200 values of epsilon on the thesis sphere, against single runs)
//   build/dev/benchmark --frames        (whole frames, with drawing)
//   build/dev/benchmark --large [TRIANGLES]   (whether a large mesh leaves a window responsive; a million)
//   build/dev/benchmark --checking      (a megabyte of written pattern, and a key typed into a long one)
//   build/dev/benchmark --sizes         (timings and contour rows on spheres up to a million triangles: minutes)
//   build/dev/benchmark --branching [MESH.obj]  (a shape that branches; without a mesh: a bear of cubes)
//   build/dev/benchmark --short-rows [MESH.obj...]  (runs with short rows against runs without; a minute)
//   build/dev/benchmark --suite [MESH.obj]      (what docs/performance.md says: minutes; the mesh: one that branches)
//   build/dev/benchmark --soak SECONDS  (the program's life over and over; fails when memory grows)
//   build/dev/benchmark --table SUITE.json PAGE.md   (writes the suite's figures into the page)
//
// Times of single runs on a shared machine mean little; each figure is a median, and stages are set against
// parsing the same file with tinyobjloader in the same run, parse and run in turn.

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "app/files/load.h"
#include "app/render/memory.h"
#include "knit/run/timeline.h"
#include "tests/benchmark/ball_file.h"
#include "tests/benchmark/branching.h"
#include "tests/benchmark/checking.h"
#include "tests/benchmark/frames.h"
#include "tests/benchmark/large.h"
#include "tests/benchmark/pipeline.h"
#include "tests/benchmark/short_rows.h"
#include "tests/benchmark/sizes.h"
#include "tests/benchmark/soak.h"
#include "tests/benchmark/suite.h"
#include "tests/benchmark/sweeps.h"
#include "tests/benchmark/table.h"
#include "tests/benchmark/travel.h"

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

Json measure_travel(const fs::path& assets) {
  Json json;
  json["tune_to_picture"] = benchmark::measure_tuning_to_picture(assets);
  json["scrub"] = benchmark::measure_long_scrubbing(assets);
  return json;
}

Json measure_mesh(const app::Loaded& loaded, const std::string& text) {
  const std::size_t triangles = loaded.input->mesh.triangles.size();
  Json json;
  json["mesh"] = {{"name", loaded.input->mesh.name},
                  {"vertices", loaded.input->mesh.positions.size()},
                  {"triangles", triangles}};
  json["pipeline"] = benchmark::measure_against_parsing(loaded, text, triangles > 200000 ? 5 : 51);
  knit::Timeline timeline(loaded.input, loaded.parameters);
  timeline.extend_to_end();
  json["seek"] = benchmark::measure_seeks(timeline);
  json["history"] = benchmark::measure_history(timeline);
  json["tune"] = benchmark::measure_tuning(loaded);
  json["copy"] = benchmark::measure_copies(loaded);
  json["sweep"] = benchmark::measure_sweep(loaded);
  return json;
}

// None: it is no such option.
std::optional<Json> measure_asked(std::string_view option, int count, char** words, const fs::path& assets) {
  if (option == "--sizes") return benchmark::measure_sizes();
  if (option == "--checking") return benchmark::measure_checking(assets);
  if (option == "--travel") return measure_travel(assets);
  if (option == "--tuning") return benchmark::measure_tuning_to_picture(assets);
  if (option == "--large")
    return benchmark::measure_large(assets, count > 2 ? std::stoul(words[2]) : 1000000);
  if (option == "--frames") return benchmark::measure_frames(assets);
  if (option == "--short-rows") return benchmark::measure_short_rows(assets, {words + 2, words + count});
  const fs::path mesh = count > 2 ? words[2] : "";
  if (option == "--branching") return benchmark::measure_branching(assets, mesh);
  if (option == "--suite") return benchmark::measure_suite(assets, mesh);
  return std::nullopt;
}

int say(const std::string& error) {
  std::fprintf(stderr, "benchmark: %s\n", error.c_str());
  return 2;
}

int run(int argc, char** argv) {
  const std::string_view option = argc > 1 ? argv[1] : "";
  const fs::path assets = fs::absolute(argv[0]).parent_path() / "assets";
  if (option == "--table") {
    if (argc < 4) return say("--table needs a suite's JSON and a page; give both.");
    const auto error = benchmark::write_table(argv[2], argv[3]);
    return error ? say(*error) : 0;
  }
  if (option == "--soak") return benchmark::soak(assets, argc > 2 ? std::stod(argv[2]) : 3600.0) ? 0 : 1;
  if (const auto json = measure_asked(option, argc, argv, assets)) {
    std::printf("%s\n", json->dump(2).c_str());
    return 0;
  }
  const bool own = !option.empty() && option != "--sweep";
  const fs::path path = own ? fs::path(option) : assets / "thesis-sphere" / "mesh.obj";
  const auto result = own ? app::load_file(path) : app::load_example(assets, "thesis-sphere");
  if (const auto* error = std::get_if<std::string>(&result)) return say(*error);
  const auto& loaded = std::get<app::Loaded>(result);
  const Json json = option == "--sweep" ? benchmark::measure_sweep(loaded)
                                        : measure_mesh(loaded, benchmark::read_text(path));
  std::printf("%s\n", json.dump(2).c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  app::keep_freed_memory();  // as knit-mesh does
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    return say(error.what());
  }
}
