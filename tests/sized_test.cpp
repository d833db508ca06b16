// Edges and corners by their size: named, found, selected, and the view that turns to them.
#include "knit/insight/sized.h"

#include <glm/geometric.hpp>

#include "app/session/action.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

namespace {

app::Session small_ball() {
  app::Session session;
  session.document = app::Document({test_support::small_sphere(), test_support::small_parameters()});
  Timeline& timeline = session.document->timeline;
  timeline.extend_to_end();
  timeline.seek(timeline.known());
  app::apply(session, app::FrameAll{});
  return session;
}

// Cosine of the angle between the eye's direction and the way out from the middle to a point.
double facing(const app::Session& session, const glm::dvec3& at) {
  const app::Camera& camera = session.view->gaze.camera;
  const glm::dvec3 middle = session.document->timeline.input().bounds.centre();
  return glm::dot(glm::normalize(camera.eye() - camera.target), glm::normalize(at - middle));
}

}  // namespace

TEST_CASE("sizes are named and read back, and what is none is not taken") {
  CHECK(size_range_named("wale:1.5") == SizeRange{Measured::wale, 1.5});
  CHECK(size_range_named("course:0.5:1") == SizeRange{Measured::course, 0.5, 1.0});
  CHECK(words_of(*size_range_named("wale:1.5")) == "wale edges of 1.5 h and more");
  CHECK(words_of(*size_range_named("corner:80:100")) == "faces with corners of 80 to 100\xC2\xB0");
  for (const char* none :
       {"", "wale", "wale:", "wale:x", "wale:2:1", "wale:1:1", "rows:1", "wale:1:2:3", "wale:inf"})
    CHECK_FALSE(size_range_named(none));
}

TEST_CASE("every edge is of some size, once, and ranges share them out") {
  const app::Session session = small_ball();
  const Timeline& timeline = session.document->timeline;
  const State& state = timeline.state();
  const StitchSize& stitch = timeline.parameters().stitch;
  for (const Measured of : {Measured::course, Measured::wale}) {
    const std::size_t all = things_of_size(state, stitch, {of, 0.0}).size();
    const LengthFigures figures = of == Measured::course ? course_figures(state) : wale_figures(state);
    CHECK(all == figures.count);
    CHECK(things_of_size(state, stitch, {of, 0.0, 1.0}).size() +
              things_of_size(state, stitch, {of, 1.0}).size() ==
          all);
  }
  const FaceCounts faces = count_faces(state);
  CHECK(things_of_size(state, stitch, {Measured::corner, 0.0}).size() == faces.quads + faces.triangles);
  for (const SizedThing& thing : things_of_size(state, stitch, {Measured::corner, 0.0}))
    REQUIRE(exists(state, thing.thing));
}

TEST_CASE("looking at a thing selects it and turns the view to it and what faces the viewer already stays") {
  app::Session session = small_ball();
  const Timeline& timeline = session.document->timeline;
  const auto edges = things_of_size(timeline.state(), timeline.parameters().stitch, {Measured::wale, 0.0});
  std::size_t turned = 0;
  for (const SizedThing& edge : edges) {
    const glm::dvec3 at = 0.5 * (edge.points[0] + edge.points[1]);
    const double before = facing(session, at);
    const app::Camera camera = session.view->gaze.camera;
    app::apply(session, app::LookAt{edge.thing});
    CHECK(session.document->travel.selected == edge.thing);
    CHECK(facing(session, at) > 0.3);
    if (before > 0.5) CHECK(session.view->gaze.camera == camera);
    turned += session.view->gaze.camera == camera ? 0 : 1;
  }
  CHECK(turned > 2);
  CHECK(turned < edges.size() / 2);
  app::apply(session, app::Select{});
  app::apply(session, app::SelectSized{SizeRange{Measured::wale, 1.0}});
  CHECK(session.document->travel.sized);
  app::apply(session, app::Select{VertexElement{3}});
  CHECK_FALSE(session.document->travel.sized);
}

TEST_CASE("in a window the view flies to what is looked at, and a hand, or no wish for movement, ends that") {
  app::Session session = small_ball();
  session.jobs->beside = true;
  const Timeline& timeline = session.document->timeline;
  const auto edges = things_of_size(timeline.state(), timeline.parameters().stitch, {Measured::wale, 0.0});
  const app::Camera start = session.view->gaze.camera;
  const auto look_somewhere_else = [&] {
    for (const SizedThing& edge : edges) {
      app::apply(session, app::LookAt{edge.thing});
      if (session.jobs->flight || session.view->gaze.camera != start) return;
    }
  };
  look_somewhere_else();
  REQUIRE(session.jobs->flight);
  const app::Camera to = session.jobs->flight->to;
  CHECK(session.view->gaze.camera == start);
  app::apply(session, app::PassTime{0.1});
  const app::Camera between = session.view->gaze.camera;
  CHECK(between != start);
  CHECK(between != to);
  app::apply(session, app::PassTime{app::flight_s});
  CHECK(session.view->gaze.camera == to);
  CHECK_FALSE(session.jobs->flight);

  session.view->gaze.camera = start;
  look_somewhere_else();
  app::apply(session, app::Orbit{0.3, 0.0});
  const app::Camera held = session.view->gaze.camera;
  app::apply(session, app::PassTime{0.1});
  CHECK(session.view->gaze.camera == held);
  CHECK_FALSE(session.jobs->flight);

  session.view->gaze.camera = start;
  session.program->preferences.motion = false;
  look_somewhere_else();
  CHECK_FALSE(session.jobs->flight);
  CHECK(session.view->gaze.camera == to);
}

TEST_CASE("a flight turns the short way round") {
  app::Camera from, to;
  from.yaw = 6.0;
  to.yaw = 0.5;
  const app::Camera middle = app::camera_at({from, to, 0.5 * app::flight_s});
  CHECK(middle.yaw > 6.0);
  CHECK(app::camera_at({from, to, app::flight_s}) == to);
}
