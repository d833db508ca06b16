#include "tests/benchmark/large.h"

#include <glad/gl.h>
#include <thread>

#include "app/actions/opening.h"
#include "app/describe/pick.h"
#include "app/render/headless_gl.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "tests/benchmark/ball_file.h"
#include "tests/benchmark/cost.h"
#include "tests/benchmark/desk.h"

namespace benchmark {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr double frame_s = 1.0 / 60.0;

struct FrameCosts {
  std::vector<Cost> act, describe, panels;
  void take(Desk& desk, const app::Action& action) {
    act.push_back(cost_of([&] {
      desk.act(action);
      desk.act(app::PassTime{frame_s});
    }));
    describe.push_back(cost_of([&] { desk.describe(); }));
    panels.push_back(cost_of([&] { desk.panels(); }));
  }
  [[nodiscard]] Json summary() const {
    return {{"frames", act.size()},
            {"act_ms", summary_of(act, &Cost::thread_ms)},
            {"describe_ms", summary_of(describe, &Cost::thread_ms)},
            {"panels_ms", summary_of(panels, &Cost::thread_ms)}};
  }
};

void wait_a_little() { std::this_thread::sleep_for(std::chrono::milliseconds(5)); }

Json opened(Desk& desk, const fs::path& path) {
  FrameCosts costs;
  costs.take(desk, app::OpenFile{path});
  while (desk.session.jobs->opening) {
    costs.take(desk, app::Orbit{0.01, 0.0});
    wait_a_little();
  }
  Json json = costs.summary();
  json["seconds"] = 1e-3 * desk.session.document->load_ms;
  return json;
}

Json worked_out(Desk& desk) {
  knit::Parameters contours = desk.session.document->timeline.parameters();
  contours.rows.source = knit::RowSource::contours;
  contours.stitches.placement = knit::PlacementPolicy::nearest;
  FrameCosts costs;
  costs.take(desk, app::Tune{contours});
  costs.take(desk, app::ToLast{});
  while (!desk.session.document->timeline.complete() || desk.session.jobs->run.measuring) {
    costs.take(desk, app::Orbit{0.01, 0.0});
    if (desk.session.jobs->run.long_step || desk.session.document->timeline.complete()) wait_a_little();
  }
  return costs.summary();
}

Json turned(Desk& desk) {
  FrameCosts costs;
  for (int i = 0; i < 100; ++i) costs.take(desk, app::Orbit{0.01, 0.005});
  return costs.summary();
}

Json scrubbed(Desk& desk) {
  FrameCosts costs;
  const std::size_t steps = desk.session.document->timeline.known();
  constexpr std::size_t frames = 200;
  for (std::size_t i = 0; i <= frames; ++i)
    costs.take(desk, app::SeekTo{steps * (i % 2 == 0 ? i : frames - i) / frames});
  return costs.summary();
}

Json clicked(Desk& desk) {
  std::vector<Cost> costs;
  for (int i = 0; i < 30; ++i) {
    const glm::dvec2 place(-0.3 + 0.02 * i, 0.3 - 0.015 * i);
    costs.push_back(cost_of([&] { (void)app::pick_thing(desk.session, place, {}); }));
  }
  return summary_of(costs, &Cost::thread_ms);
}

// From the wish to the frame after it, and until the worker has really ended.
Json cancelled(Desk& desk, const fs::path& path) {
  Json json;
  desk.act(app::OpenFile{path});
  for (int i = 0; i < 20; ++i) {
    wait_a_little();
    desk.act(app::PassTime{frame_s});
  }
  const auto opening = desk.session.jobs->opening;
  const Cost wish = cost_of([&] {
    desk.act(app::CancelWork{});
    desk.frame();
  });
  json["frame_ms"] = wish.thread_ms;
  const Cost end = cost_of([&] {
    while (opening && !opening->work.ready()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  json["worker_ended_after_ms"] = end.wall_ms;
  return json;
}

Json drawn(app::Session session, const fs::path& assets) {
  auto gl = app::HeadlessGl::open();
  if (const auto* error = std::get_if<std::string>(&gl)) return {{"left_out", *error}};
  session.jobs->beside = true;
  app::FrameDrawer drawer(assets);
  std::vector<Cost> costs;
  for (int i = 0; i < 8; ++i) {
    app::apply(session, app::Orbit{0.02, 0.0});
    costs.push_back(cost_of([&] {
      drawer.draw(session, shape_of(1280, 720), {});
      glFinish();
    }));
    while (i == 0 && drawer.busy()) drawer.draw(session, shape_of(1280, 720), {});
  }
  return {{"first_ms", costs.front().thread_ms}, {"frame_ms", summary_of(costs, &Cost::thread_ms)}};
}

}  // namespace

Json measure_large(const fs::path& assets, std::size_t triangles) {
  const BallFile ball(triangles);
  Desk desk(assets);
  desk.act(app::OpenExample{"thesis-sphere"});
  for (int i = 0; i < 5; ++i) desk.frame();
  Json json;
  json["opening"] = opened(desk, ball.path);
  json["triangles"] = desk.session.document->timeline.input().mesh.triangles.size();
  json["working_out"] = worked_out(desk);
  json["steps"] = desk.session.document->timeline.known();
  json["camera"] = turned(desk);
  json["scrubbing"] = scrubbed(desk);
  json["click_ms"] = clicked(desk);
  json["cancel"] = cancelled(desk, ball.path);
  json["drawing_by_this_driver"] = drawn(desk.session, assets);
  return json;
}

}  // namespace benchmark
