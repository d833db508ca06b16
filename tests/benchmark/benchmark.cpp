// What the pipeline costs, as ratios measured in one run: JSON on standard output.
//
//   build/dev/benchmark [MESH.obj]      (without a mesh: the thesis sphere)
//   build/dev/benchmark --travel        (changed parameters to pictures, scrubbing a million steps)
//   build/dev/benchmark --sweep         (only 200 values of epsilon on the thesis sphere, against single runs)
//   build/dev/benchmark --sizes         (timings and contour rows on spheres up to a million triangles: minutes)
//
// Times of single runs on a shared machine mean little; each figure is a median, and stages are set against
// parsing the same file with tinyobjloader in the same run, parse and run in turn.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include <tiny_obj_loader.h>

#include "app/core/load.h"
#include "app/render/memory.h"
#include "knit/timeline.h"
#include "tests/benchmark/frames.h"
#include "tests/benchmark/sizes.h"
#include "tests/benchmark/sweeps.h"
#include "tests/benchmark/travel.h"

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace

double benchmark::parse_once(const std::string& text) {
  std::istringstream in(text);
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning;
  std::string error;
  const auto start = Clock::now();
  tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &in);
  return milliseconds_since(start);
}

namespace {

using benchmark::parse_once;

struct StageTimes {
  std::array<double, knit::machine_stages.size()> milliseconds{};
  double total = 0.0;
};

StageTimes run_once(const app::Loaded& loaded) {
  StageTimes times;
  const auto start = Clock::now();
  knit::Timeline timeline(loaded.input, loaded.parameters);
  timeline.extend_to_end();
  times.total = milliseconds_since(start);
  return times;
}

// Stage by stage with the bare machine, so that the clock is read only where a stage ends.
StageTimes run_by_stage(const app::Loaded& loaded) {
  StageTimes times;
  knit::State state;
  const auto start = Clock::now();
  auto stage_start = start;
  while (!state.finished()) {
    const knit::Stage stage = state.stage();
    if (knit::is_stop(knit::advance(*loaded.input, loaded.parameters, state))) break;
    if (state.stage() == stage) continue;
    const auto i = static_cast<std::size_t>(stage) - static_cast<std::size_t>(knit::Stage::timing);
    times.milliseconds.at(i) = milliseconds_since(stage_start);
    stage_start = Clock::now();
  }
  times.total = milliseconds_since(start);
  return times;
}

Json against_parsing(const app::Loaded& loaded, const std::string& text, int rounds) {
  std::vector<double> parse;
  std::vector<double> run;
  std::vector<double> ratio;
  std::array<std::vector<double>, knit::machine_stages.size()> stages;
  for (int i = 0; i < rounds; ++i) {
    parse.push_back(parse_once(text));
    run.push_back(run_once(loaded).total);
    ratio.push_back(run.back() / parse.back());
    const StageTimes by_stage = run_by_stage(loaded);
    for (std::size_t s = 0; s < stages.size(); ++s) stages[s].push_back(by_stage.milliseconds[s]);
  }
  Json json;
  json["parse_ms"] = quantile(parse, 0.5);
  json["run_ms"] = quantile(run, 0.5);
  json["run_over_parse"] = {
      {"median", quantile(ratio, 0.5)}, {"p10", quantile(ratio, 0.1)}, {"p90", quantile(ratio, 0.9)}};
  for (std::size_t s = 0; s < stages.size(); ++s) {
    json["stage_ms"][std::string(knit::name_of(knit::machine_stages[s]))] = quantile(stages[s], 0.5);
  }
  return json;
}

Json seeks(const app::Loaded& loaded) {
  knit::Timeline timeline(loaded.input, loaded.parameters);
  timeline.extend_to_end();
  std::mt19937_64 random(1);
  std::vector<double> times;
  for (int i = 0; i < 5000; ++i) {
    const std::size_t position = random() % (timeline.known() + 1);
    const auto start = Clock::now();
    timeline.seek(position);
    times.push_back(milliseconds_since(start));
  }
  return {{"steps", timeline.known()},
          {"median_ms", quantile(times, 0.5)},
          {"p99_ms", quantile(times, 0.99)},
          {"max_ms", quantile(times, 1.0)},
          {"keyframes", timeline.keyframe_count()},
          {"keyframe_bytes", timeline.keyframe_bytes()}};
}

// From a changed epsilon to the finished run, shown at its end.
Json tuning(const app::Loaded& loaded) {
  knit::Timeline timeline(loaded.input, loaded.parameters);
  timeline.extend_to_end();
  timeline.seek(timeline.known());
  std::vector<double> times;
  for (int i = 0; i < 100; ++i) {
    knit::Parameters tuned = loaded.parameters;
    tuned.epsilon *= 0.7 + 0.004 * i;
    const auto start = Clock::now();
    timeline.tune(tuned);
    timeline.extend_to_end();
    times.push_back(milliseconds_since(start));
  }
  return {{"median_ms", quantile(times, 0.5)}, {"p99_ms", quantile(times, 0.99)}};
}

Json copies(const app::Loaded& loaded) {
  knit::Timeline timeline(loaded.input, loaded.parameters);
  timeline.extend_to_end();
  std::size_t largest = 0;
  for (std::size_t position = 0; position <= timeline.known(); position += 97) {
    timeline.seek(position);
    largest = std::max(largest, knit::copy_bytes(timeline.state()));
  }
  const std::size_t rows = timeline.furthest().rows.size();
  const std::size_t finished = knit::copy_bytes(timeline.furthest());
  return {{"state_bytes", sizeof(knit::State)},
          {"finished_copy_bytes", finished},
          {"pointers_a_row",
           rows == 0 ? 0.0 : double(finished - sizeof(knit::State)) / double(rows) / sizeof(void*)},
          {"largest_copy_bytes", largest},
          {"step_bytes", sizeof(knit::Step)}};
}

}  // namespace

int main(int argc, char** argv) {
  app::keep_freed_memory();  // as knit-mesh does
  if (argc > 1 && std::string_view(argv[1]) == "--sizes") {
    std::printf("%s\n", benchmark::measure_sizes().dump(2).c_str());
    return 0;
  }
  const std::filesystem::path assets = std::filesystem::absolute(argv[0]).parent_path() / "assets";
  if (argc > 1 && std::string_view(argv[1]) == "--travel") {
    Json json;
    json["tune_to_picture"] = benchmark::measure_tuning_to_picture(assets);
    json["scrub"] = benchmark::measure_long_scrubbing(assets);
    std::printf("%s\n", json.dump(2).c_str());
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--frames") {
    std::printf("%s\n", benchmark::measure_frames(assets).dump(2).c_str());
    return 0;
  }
  const bool only_sweep = argc > 1 && std::string_view(argv[1]) == "--sweep";
  const bool own = argc > 1 && !only_sweep;
  const std::filesystem::path path =
      own ? std::filesystem::path(argv[1]) : assets / "thesis-sphere" / "mesh.obj";
  const auto result = own ? app::load_file(path) : app::load_example(assets, "thesis-sphere");
  if (const auto* error = std::get_if<std::string>(&result)) {
    std::fprintf(stderr, "benchmark: %s\n", error->c_str());
    return 2;
  }
  const auto& loaded = std::get<app::Loaded>(result);
  const std::size_t triangles = loaded.input->mesh.triangles.size();
  if (only_sweep) {
    std::printf("%s\n", benchmark::measure_sweep(loaded).dump(2).c_str());
    return 0;
  }
  Json json;
  json["mesh"] = {{"name", loaded.input->mesh.name},
                  {"vertices", loaded.input->mesh.positions.size()},
                  {"triangles", triangles}};
  json["pipeline"] = against_parsing(loaded, read_file(path), triangles > 200000 ? 5 : 51);
  json["seek"] = seeks(loaded);
  json["tune"] = tuning(loaded);
  json["copy"] = copies(loaded);
  json["sweep"] = benchmark::measure_sweep(loaded);
  std::printf("%s\n", json.dump(2).c_str());
  return 0;
}
