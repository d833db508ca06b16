#include "tests/benchmark/pipeline.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <random>
#include <sstream>

#include <tiny_obj_loader.h>

#include "knit/model/stitch_size.h"
#include "knit/run/machine.h"

namespace benchmark {

namespace {

using Json = nlohmann::ordered_json;
// This thread's processor time: on a machine that others use, a long parse would be held up oftener than a short run.
struct Clock {
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  }
};

double milliseconds_since(double start) { return Clock::now() - start; }

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

}  // namespace

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

double parse_once(const std::string& text) {
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

Json measure_against_parsing(const app::Loaded& loaded, const std::string& text, int rounds) {
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
    const std::string name(knit::name_of(knit::machine_stages[s]));
    json["stage_ms"][name] = quantile(stages[s], 0.5);
    json["stage_over_parse"][name] = quantile(stages[s], 0.5) / quantile(parse, 0.5);
  }
  return json;
}

Json measure_seeks(knit::Timeline& timeline) {
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
          {"p90_ms", quantile(times, 0.9)},
          {"p99_ms", quantile(times, 0.99)},
          {"max_ms", quantile(times, 1.0)},
          {"keyframes", timeline.keyframe_count()},
          {"keyframe_bytes", timeline.keyframe_bytes()}};
}

// From a changed epsilon to the finished run, shown at its end.
Json measure_tuning(const app::Loaded& loaded) {
  knit::Timeline timeline(loaded.input, loaded.parameters);
  timeline.extend_to_end();
  timeline.seek(timeline.known());
  std::vector<double> times;
  for (int i = 0; i < 100; ++i) {
    knit::Parameters tuned = loaded.parameters;
    knit::give_epsilon(tuned, tuned.epsilon() * (0.7 + 0.004 * i));
    const auto start = Clock::now();
    timeline.tune(tuned);
    timeline.extend_to_end();
    times.push_back(milliseconds_since(start));
  }
  return {{"median_ms", quantile(times, 0.5)}, {"p99_ms", quantile(times, 0.99)}};
}

Json measure_copies(const app::Loaded& loaded) {
  knit::Timeline timeline(loaded.input, loaded.parameters);
  timeline.extend_to_end();
  std::size_t largest = 0;
  for (std::size_t position = 0; position <= timeline.known(); position += 97) {
    timeline.seek(position);
    largest = std::max(largest, knit::copy_bytes(timeline.state()));
  }
  const std::size_t rows = timeline.furthest().fabric.rows().size();
  const std::size_t finished = knit::copy_bytes(timeline.furthest());
  return {{"state_bytes", sizeof(knit::State)},
          {"finished_copy_bytes", finished},
          {"pointers_a_row",
           rows == 0 ? 0.0 : double(finished - sizeof(knit::State)) / double(rows) / sizeof(void*)},
          {"largest_copy_bytes", largest},
          {"step_bytes", sizeof(knit::Step)}};
}

Json measure_history(const knit::Timeline& timeline) {
  const double steps = static_cast<double>(timeline.known());
  const double bytes = static_cast<double>(sizeof(knit::Step));
  return {{"steps", timeline.known()},
          {"bytes_a_step", static_cast<double>(timeline.steps().size()) * bytes / steps},
          {"set_aside_bytes_a_step", static_cast<double>(timeline.steps().capacity()) * bytes / steps},
          {"keyframes", timeline.keyframe_count()},
          {"keyframe_bytes", timeline.keyframe_bytes()},
          {"keyframe_budget_bytes", knit::Timeline::default_budget_bytes}};
}

app::Loaded long_run(const std::filesystem::path& assets) {
  auto loaded = std::get<app::Loaded>(app::load_example(assets, "sphere"));
  loaded.parameters.rows.source = knit::RowSource::contours;
  loaded.parameters.stitches.placement = knit::PlacementPolicy::even;
  knit::give_width(loaded.parameters, 0.0055);
  knit::give_height(loaded.parameters, 0.0055);
  return loaded;
}

}  // namespace benchmark
