#include "tests/benchmark/travel.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <vector>

#include "app/core/action.h"
#include "app/render/headless_gl.h"
#include "app/window/frame.h"
#include "knit/shapes.h"

namespace benchmark {

namespace {

using Json = nlohmann::ordered_json;

double clock_ms(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Cost {
  double thread_ms = 0.0, all_ms = 0.0, wall_ms = 0.0;
};

Cost cost_of(const std::function<void()>& work) {
  const double thread = clock_ms(CLOCK_THREAD_CPUTIME_ID);
  const double all = clock_ms(CLOCK_PROCESS_CPUTIME_ID);
  const double wall = clock_ms(CLOCK_MONOTONIC);
  work();
  return {clock_ms(CLOCK_THREAD_CPUTIME_ID) - thread, clock_ms(CLOCK_PROCESS_CPUTIME_ID) - all,
          clock_ms(CLOCK_MONOTONIC) - wall};
}

Json summary_of(const std::vector<Cost>& costs, double Cost::*part) {
  std::vector<double> values;
  values.reserve(costs.size());
  for (const Cost& cost : costs) values.push_back(cost.*part);
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * double(values.size() - 1))];
  };
  return {{"median", at(0.5)}, {"p99", at(0.99)}, {"max", values.back()}};
}

app::FrameShape shape_of(int width, int height) {
  app::FrameShape shape;
  shape.width = static_cast<float>(width);
  shape.height = static_cast<float>(height);
  shape.width_px = width;
  shape.height_px = height;
  shape.samples = 1;  // as the window does while things move on a slow machine
  return shape;
}

// As in the window: what changes is worked out in the next tick, then drawn.
struct Desk {
  app::Session session;
  app::FrameDrawer drawer;
  app::FrameShape shape = shape_of(1280, 720);

  explicit Desk(const std::filesystem::path& assets) : drawer(assets) {
    session.assets = assets;
    session.beside = true;
  }
  void act(const app::Action& action) { app::apply(session, action); }
  void draw() { drawer.draw(session, shape, {}); }
  void finish() {
    while (!session.timeline->complete()) act(app::PassTime{0.0});
    act(app::ToLast{});
    for (int i = 0; i < 3; ++i) draw();
  }
};

}  // namespace

Json measure_tuning_to_picture(const std::filesystem::path& assets) {
  auto opened = app::HeadlessGl::open();
  if (const auto* error = std::get_if<std::string>(&opened)) return {{"left_out", *error}};
  Desk desk(assets);
  desk.act(app::OpenExample{"thesis-sphere"});
  desk.finish();
  std::vector<Cost> change;
  std::vector<Cost> picture;
  const knit::Parameters first = desk.session.timeline->parameters();
  for (int i = 0; i < 200; ++i) {
    knit::Parameters tuned = first;
    tuned.epsilon *= 0.7 + 0.002 * i;
    change.push_back(cost_of([&] {
      desk.act(app::Tune{tuned});
      desk.act(app::PassTime{1.0 / 60.0});
    }));
    picture.push_back(cost_of([&] { desk.draw(); }));
  }
  std::vector<Cost> both;
  for (std::size_t i = 0; i < change.size(); ++i) {
    both.push_back({change[i].thread_ms + picture[i].thread_ms, change[i].all_ms + picture[i].all_ms,
                    change[i].wall_ms + picture[i].wall_ms});
  }
  Json json;
  json["third_of_a_frame_ms"] = 1000.0 / 60.0 / 3.0;
  json["change_ms"] = summary_of(change, &Cost::thread_ms);
  json["picture_ms"] = summary_of(picture, &Cost::thread_ms);
  json["change_to_picture_ms"] = summary_of(both, &Cost::thread_ms);
  json["with_software_rasteriser_ms"] = summary_of(both, &Cost::all_ms);
  return json;
}

Json measure_long_scrubbing(const std::filesystem::path& assets) {
  auto opened = app::HeadlessGl::open();
  if (const auto* error = std::get_if<std::string>(&opened)) return {{"left_out", *error}};
  Desk desk(assets);
  desk.act(app::OpenExample{"sphere"});
  knit::Parameters fine = desk.session.timeline->parameters();
  fine.rows = knit::RowSource::contours;
  fine.placement = knit::PlacementPolicy::even;
  fine.stitch_width = 0.0066;
  fine.stitch_height = 0.0066;
  desk.act(app::Tune{fine});
  std::vector<Cost> slices;
  while (!desk.session.timeline->complete()) {
    slices.push_back(cost_of([&] { desk.act(app::PassTime{0.0}); }));
  }
  desk.finish();
  const std::size_t steps = desk.session.timeline->known();
  constexpr int frames = 400;
  std::vector<Cost> seeks;
  std::vector<Cost> whole;
  for (int i = 0; i <= frames; ++i) {
    const std::size_t position = steps * static_cast<std::size_t>(i % 2 == 0 ? i : frames - i) / frames;
    Cost seek;
    whole.push_back(cost_of([&] {
      seek = cost_of([&] {
        desk.act(app::SeekTo{position});
        desk.act(app::PassTime{1.0 / 60.0});
      });
      desk.draw();
    }));
    seeks.push_back(seek);
  }
  const knit::Timeline& timeline = *desk.session.timeline;
  Json json;
  json["steps"] = steps;
  json["stitches_of_last_row"] = timeline.furthest().rows.back()->stitches.size();
  json["work_slice_ms"] = summary_of(slices, &Cost::wall_ms);
  json["seek_ms"] = summary_of(seeks, &Cost::wall_ms);
  json["frame_thread_ms"] = summary_of(whole, &Cost::thread_ms);
  json["step_bytes"] = sizeof(knit::Step);
  json["keyframe_bytes"] = timeline.keyframe_bytes();
  json["keyframe_budget_bytes"] = knit::Timeline::default_budget_bytes;
  return json;
}

}  // namespace benchmark
