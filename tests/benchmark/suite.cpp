#include "tests/benchmark/suite.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <thread>

#include "knit/import/obj.h"
#include "knit/model/stitch_size.h"
#include "tests/benchmark/ball_file.h"
#include "tests/benchmark/branching.h"
#include "tests/benchmark/checking.h"
#include "tests/benchmark/cost.h"
#include "tests/benchmark/large.h"
#include "tests/benchmark/pipeline.h"
#include "tests/benchmark/travel.h"

namespace benchmark {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

void say(const char* words) { std::fprintf(stderr, "benchmark: %s ...\n", words); }

app::Loaded with_contours(app::Loaded loaded) {
  loaded.parameters.rows.source = knit::RowSource::contours;
  loaded.parameters.stitches.placement = knit::PlacementPolicy::nearest;
  return loaded;
}

Json measure_thesis_sphere(const fs::path& assets) {
  say("the thesis sphere against parsing");
  const auto loaded = std::get<app::Loaded>(app::load_example(assets, "thesis-sphere"));
  const std::string text = read_text(assets / "thesis-sphere" / "mesh.obj");
  Json json = measure_against_parsing(loaded, text, 101);
  json["triangles"] = loaded.input->mesh.triangles.size();
  return json;
}

Json measure_million() {
  say("a million triangles against parsing");
  const BallFile file(1000000);
  const app::Loaded loaded = with_contours(std::get<app::Loaded>(app::load_file(file.path)));
  Json json = measure_against_parsing(loaded, read_text(file.path), 7);
  json["triangles"] = loaded.input->mesh.triangles.size();
  return json;
}

Json measure_million_steps(const fs::path& assets) {
  say("a run of a million steps");
  const app::Loaded loaded = long_run(assets);
  knit::Timeline timeline(loaded.input, loaded.parameters);
  timeline.extend_to_end();
  return {{"seek", measure_seeks(timeline)}, {"history", measure_history(timeline)}};
}

// By least squares: how the logarithm of the cost grows with that of the size.
double slope_of(const std::vector<double>& sizes, const std::vector<double>& costs) {
  double x_sum = 0.0, y_sum = 0.0, xx_sum = 0.0, xy_sum = 0.0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double x = std::log(sizes[i]);
    const double y = std::log(costs[i]);
    x_sum += x;
    y_sum += y;
    xx_sum += x * x;
    xy_sum += x * y;
  }
  const auto n = static_cast<double>(sizes.size());
  return (n * xy_sum - x_sum * y_sum) / (n * xx_sum - x_sum * x_sum);
}

struct Grown {
  double open_ms, run_ms;
};

// Processor time of one thread: others on the machine count less.
Grown grown_once(const std::string& text) {
  std::istringstream in(text);
  app::Loaded loaded;
  const Cost open = cost_of([&] {
    auto mesh = std::make_shared<const knit::Mesh>(std::get<knit::Mesh>(knit::read_obj(in, "ball")));
    loaded = std::get<app::Loaded>(
        app::load_again(mesh, knit::default_parameters(knit::bounds_of(mesh->positions))));
  });
  loaded = with_contours(std::move(loaded));
  const Cost run = cost_of([&] {
    knit::Timeline timeline(loaded.input, loaded.parameters);
    timeline.extend_to_end();
  });
  return {open.thread_ms, run.thread_ms};
}

Json measure_growth() {
  say("growth with size");
  constexpr std::array<std::size_t, 5> asked{10000, 31623, 100000, 316228, 1000000};
  constexpr int turns = 5;
  std::array<std::string, asked.size()> texts;
  std::vector<double> sizes;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const knit::Mesh mesh = ball(asked[i]);
    std::ostringstream text;
    knit::write_obj(text, mesh, "");
    texts[i] = text.str();
    sizes.push_back(static_cast<double>(mesh.triangles.size()));
  }
  std::array<std::vector<double>, asked.size()> open, run;
  for (int turn = 0; turn < turns; ++turn) {
    for (std::size_t i = 0; i < asked.size(); ++i) {
      // What is quick is measured oftener, so that all take their time at about the same moment.
      for (int again = 0; again < (i < 2 ? 5 : 1); ++again) {
        const Grown grown = grown_once(texts[i]);
        open[i].push_back(grown.open_ms);
        run[i].push_back(grown.run_ms);
      }
    }
  }
  Json json;
  std::vector<double> open_ms, run_ms;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    open_ms.push_back(quantile(open[i], 0.5));
    run_ms.push_back(quantile(run[i], 0.5));
    json["sizes"].push_back({{"triangles", static_cast<std::size_t>(sizes[i])},
                             {"open_ms", open_ms.back()},
                             {"run_ms", run_ms.back()}});
  }
  json["open_slope"] = slope_of(sizes, open_ms);
  json["run_slope"] = slope_of(sizes, run_ms);
  return json;
}

}  // namespace

Json measure_suite(const fs::path& assets, const fs::path& branching) {
  Json json;
  json["threads"] = std::thread::hardware_concurrency();
  json["thesis_sphere"] = measure_thesis_sphere(assets);
  json["million_triangles"] = measure_million();
  json["million_steps"] = measure_million_steps(assets);
  say("a shape that branches");
  json["branching"] = measure_branching(assets, branching);
  json["growth"] = measure_growth();
  say("checking a written pattern");
  json["checking"] = measure_checking(assets);
  say("from a changed parameter to the picture");
  json["tune_to_picture"] = measure_tuning_to_picture(assets);
  say("scrubbing a million steps");
  json["scrub"] = measure_long_scrubbing(assets);
  say("a million triangles in a window");
  json["window_1m"] = measure_large(assets, 1000000);
  say("five million triangles in a window");
  json["window_5m"] = measure_large(assets, 5000000);
  return json;
}

}  // namespace benchmark
