#include "tests/benchmark/frames.h"
#include "app/actions/navigate.h"

#include <glad/gl.h>

#include "app/render/headless_gl.h"
#include "app/script/command_line.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "tests/benchmark/cost.h"

namespace benchmark {

namespace {

using Json = nlohmann::ordered_json;

struct Shown {
  const char* name;
  app::Session session;
  std::unique_ptr<app::FrameDrawer>
      drawer;  // its own, as each window has one: what it keeps is of one session
  std::vector<Cost> costs;
};

Shown shown_at(const char* name, const std::filesystem::path& assets, const app::At& at, bool times) {
  Shown shown{name, {}, std::make_unique<app::FrameDrawer>(assets), {}};
  shown.session.program->assets = assets;
  app::apply(shown.session, app::OpenExample{"thesis-sphere"});
  app::go_to(shown.session, app::At(app::AtEnd{}));
  app::go_to(shown.session, at);
  app::apply(shown.session, app::SetLayer{app::Layer::times, times});
  app::apply(shown.session, app::SetLayer{app::Layer::isolines, times});
  return shown;
}

Json measure(const std::filesystem::path& assets, int samples) {
  std::vector<Shown> all;
  all.push_back(shown_at("bare", assets, app::At(std::size_t{0}), false));
  all.push_back(shown_at("timed", assets, app::At(knit::Place{knit::Stage::cast_on, 1, 0}), true));
  all.push_back(shown_at("half_picked", assets, app::At(knit::Place{knit::Stage::rows, 32, 20}), true));
  all.push_back(shown_at("finished", assets, app::At(app::AtEnd{}), true));
  app::FrameShape shape = shape_of(1280, 720);
  shape.samples = samples;
  constexpr int turns = 40;
  for (int i = 0; i < turns + 3; ++i) {
    for (Shown& shown : all) {
      const Cost cost = cost_of([&] {
        shown.drawer->draw(shown.session, shape, {});
        glFinish();
      });
      if (i >= 3) shown.costs.push_back(cost);
    }
  }
  Json json;
  for (const Shown& shown : all) {
    json[shown.name] = {{"wall_ms", summary_of(shown.costs, &Cost::wall_ms)},
                        {"thread_ms", summary_of(shown.costs, &Cost::thread_ms)},
                        {"all_ms", summary_of(shown.costs, &Cost::all_ms)}};
  }
  json["over_bare"] =
      median_of(all.back().costs, &Cost::wall_ms) / median_of(all.front().costs, &Cost::wall_ms);
  json["over_bare_processor"] =
      median_of(all.back().costs, &Cost::all_ms) / median_of(all.front().costs, &Cost::all_ms);
  return json;
}

}  // namespace

Json measure_frames(const std::filesystem::path& assets) {
  auto opened = app::HeadlessGl::open();
  if (const auto* error = std::get_if<std::string>(&opened)) return {{"drawing_left_out", *error}};
  Json json;
  json["renderer"] = std::get<app::HeadlessGl>(opened).renderer();
  json["one_sample"] = measure(assets, 1);
  json["four_samples"] = measure(assets, 4);
  return json;
}

}  // namespace benchmark
