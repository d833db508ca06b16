#include "tests/benchmark/travel.h"

#include <vector>

#include "app/render/headless_gl.h"
#include "app/session/document.h"
#include "app/window/frame.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "tests/benchmark/cost.h"
#include "tests/benchmark/desk.h"

namespace benchmark {

using Json = nlohmann::ordered_json;

Json measure_tuning_to_picture(const std::filesystem::path& assets) {
  Json json;
  json["third_of_a_frame_ms"] = 1000.0 / 60.0 / 3.0;
  app::Session finished;
  {
    Desk desk(assets);
    desk.act(app::OpenExample{"thesis-sphere"});
    desk.finish();
    std::vector<Cost> change;
    std::vector<Cost> described;
    std::vector<Cost> panels;
    const knit::Parameters first = desk.session.document->timeline.parameters();
    for (int i = 0; i < 200; ++i) {
      knit::Parameters tuned = first;
      knit::give_epsilon(tuned, tuned.epsilon() * (0.7 + 0.002 * i));
      change.push_back(cost_of([&] {
        desk.act(app::Tune{tuned, true});
        desk.act(app::PassTime{1.0 / 60.0});
      }));
      described.push_back(cost_of([&] { desk.describe(); }));
      panels.push_back(cost_of([&] { desk.panels(); }));
    }
    json["change_ms"] = summary_of(change, &Cost::thread_ms);
    json["describe_ms"] = summary_of(described, &Cost::thread_ms);
    json["panels_ms"] = summary_of(panels, &Cost::thread_ms);
    json["change_to_picture_ms"] = sums_of({change, described, panels}, &Cost::thread_ms);
    finished = desk.session;
  }
  auto opened = app::HeadlessGl::open();
  if (const auto* error = std::get_if<std::string>(&opened)) {
    json["drawing_left_out"] = *error;
    return json;
  }
  // The same with drawing, and with what the driver does in this thread; the first frames make its programs.
  app::FrameDrawer drawer(assets);
  const knit::Parameters first = finished.document->timeline.parameters();
  constexpr int unmeasured = 10;
  std::vector<Cost> drawn;
  for (int i = 0; i < 100 + unmeasured; ++i) {
    knit::Parameters tuned = first;
    knit::give_epsilon(tuned, tuned.epsilon() * (0.8 + 0.002 * i));
    const Cost cost = cost_of([&] {
      app::apply(finished, app::Tune{tuned, true});
      app::apply(finished, app::PassTime{1.0 / 60.0});
      drawer.draw(finished, shape_of(1280, 720), {});
    });
    if (i >= unmeasured) drawn.push_back(cost);
  }
  json["with_drawing_by_this_driver_ms"] = summary_of(drawn, &Cost::thread_ms);
  return json;
}

namespace {

app::Session scrub_without_drawing(Json& json, const std::filesystem::path& assets) {
  Desk desk(assets);
  desk.act(app::OpenExample{"sphere"});
  knit::Parameters fine = desk.session.document->timeline.parameters();
  fine.rows.source = knit::RowSource::contours;
  fine.stitches.placement = knit::PlacementPolicy::even;
  knit::give_width(fine, 0.0055);
  knit::give_height(fine, 0.0055);
  desk.act(app::Tune{fine});
  std::vector<Cost> slices;
  while (!desk.session.document->timeline.complete()) {
    slices.push_back(cost_of([&] {
      desk.act(app::PassTime{0.0});
      desk.frame();
    }));
  }
  desk.finish();
  const std::size_t steps = desk.session.document->timeline.known();
  constexpr std::size_t frames = 400;
  std::vector<Cost> seeks;
  std::vector<Cost> described;
  std::vector<Cost> panels;
  for (std::size_t i = 0; i <= frames; ++i) {
    // There and back in ever other places, as a hand does that cannot make up its mind.
    const std::size_t position = steps * (i % 2 == 0 ? i : frames - i) / frames;
    seeks.push_back(cost_of([&] {
      desk.act(app::SeekTo{position});
      desk.act(app::PassTime{1.0 / 60.0});
    }));
    described.push_back(cost_of([&] { desk.describe(); }));
    panels.push_back(cost_of([&] { desk.panels(); }));
  }
  const knit::Timeline& timeline = desk.session.document->timeline;
  json["steps"] = steps;
  json["working_out_frame_ms"] = summary_of(slices, &Cost::wall_ms);
  json["seek_ms"] = summary_of(seeks, &Cost::wall_ms);
  json["describe_ms"] = summary_of(described, &Cost::wall_ms);
  json["panels_ms"] = summary_of(panels, &Cost::wall_ms);
  json["frame_ms"] = sums_of({seeks, described, panels}, &Cost::wall_ms);
  json["step_bytes"] = sizeof(knit::Step);
  json["keyframe_bytes"] = timeline.keyframe_bytes();
  json["keyframe_budget_bytes"] = knit::Timeline::default_budget_bytes;
  return desk.session;
}

// The same frames as a window draws them, by whatever OpenGL there is.
void add_drawn_scrubbing(Json& json, app::Session session, const std::filesystem::path& assets) {
  auto opened = app::HeadlessGl::open();
  if (const auto* error = std::get_if<std::string>(&opened)) {
    json["drawing_left_out"] = *error;
    return;
  }
  app::FrameDrawer drawer(assets);
  const std::size_t steps = session.document->timeline.known();
  const auto draw = [&] { drawer.draw(session, shape_of(1280, 720), {}); };
  // Whoever scrubs has seen the run being worked out: the driver has its programs by then.
  for (const std::size_t position : {std::size_t{0}, steps / 2, steps}) {
    app::apply(session, app::SeekTo{position});
    for (int i = 0; i < 3; ++i) draw();
  }
  constexpr std::size_t frames = 100;
  std::vector<Cost> drawn;
  for (std::size_t i = 0; i <= frames; ++i) {
    app::apply(session, app::SeekTo{steps * (i % 2 == 0 ? i : frames - i) / frames});
    drawn.push_back(cost_of(draw));
  }
  json["drawing_by_this_driver_ms"] = summary_of(drawn, &Cost::thread_ms);
}

}  // namespace

Json measure_long_scrubbing(const std::filesystem::path& assets) {
  Json json;
  app::Session finished = scrub_without_drawing(json, assets);
  add_drawn_scrubbing(json, std::move(finished), assets);
  return json;
}

}  // namespace benchmark
