// The view turns to what happens behind the surface: smoothly, not while a person turns it, and only where it is chosen.
#include "app/facing/step_place.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "tests/support/desk.h"

using namespace desk;

namespace {

double facing(const Camera& camera, const StepPlace& place) {
  return glm::dot(place.outward, glm::normalize(camera.eye() - place.at));
}

// The desk's run at a vertex that is measured on the far side, seen from there.
void stand_behind(Desk& desk) {
  desk.open();
  desk.act({SeekPlace{{knit::Stage::rows, 4, 3}}});
  REQUIRE(step_place(desk.session));
  const StepPlace place = *step_place(desk.session);
  Camera& camera = desk.session.view->gaze.camera;
  camera.yaw = std::atan2(-place.outward.x, -place.outward.z);
  camera.pitch = 0.1;
  REQUIRE(facing(camera, place) < 0.0);
  desk.settle();
}

}  // namespace

TEST_CASE("a step about one place has it, with the surface's normal") {
  Session session;
  CHECK_FALSE(step_place(session));
  Desk desk;
  desk.open();
  const knit::Timeline& timeline = desk.session.document->timeline;
  desk.act({ToFirst{}});
  CHECK_FALSE(step_place(desk.session));
  std::size_t places = 0;
  for (std::size_t position = 1; position <= timeline.known(); position += 7) {
    desk.act({SeekTo{position}});
    const auto place = step_place(desk.session);
    if (!place) continue;
    ++places;
    CHECK(glm::length(place->outward) == Approx(1.0));
    // Of a ball about the middle.
    const glm::dvec3 out = glm::normalize(place->at - timeline.input().bounds.centre());
    CHECK(glm::dot(out, place->outward) > 0.8);
  }
  CHECK(places > 20);
}

TEST_CASE("the camera turns until the place is in sight, by small turns, and not a bit where it is") {
  const StepPlace place{{0, 0, 1}, {0, 0, 1}};
  Camera camera;
  camera.pitch = 0.2;
  for (const double yaw : {3.1415926, 3.65, -2.0, 2.2}) {
    camera.yaw = yaw;
    Camera now = camera;
    int frames = 0;
    for (; turned_to(now, place, 1.0 / 60.0) != now; ++frames) {
      REQUIRE(frames < 300);
      const Camera next = turned_to(now, place, 1.0 / 60.0);
      CHECK(std::abs(next.yaw - now.yaw) < 0.08);
      CHECK(next.distance == now.distance);
      CHECK(next.target == now.target);
      now = next;
    }
    CHECK(frames > 20);
    CHECK(facing(now, place) > 0.3);
  }
  camera.yaw = 0.5;
  CHECK(turned_to(camera, place, 1.0) == camera);
}

TEST_CASE("what set the view has its way until the run goes on and then it turns, where that is chosen") {
  Desk desk;
  stand_behind(desk);
  CHECK(desk.frame().empty());
  desk.act({StepBy{}});
  CHECK(desk.frame().empty());  // not chosen
  desk.act({SetFollowing{true}});
  const StepPlace place = *step_place(desk.session);
  int turns = 0;
  for (; turns < 300; ++turns) {
    const Actions wishes = desk.frame();
    if (wishes.empty()) break;
    CHECK(only<TurnToStep>(wishes).seconds <= 0.05);
    desk.act(wishes);
  }
  CHECK(turns > 20);
  CHECK(facing(desk.session.view->gaze.camera, place) > 0.2);
}

TEST_CASE("it never turns while a person drags, nor after that before the next step") {
  Desk desk;
  stand_behind(desk);
  desk.act({SetFollowing{true}, StepBy{}});
  const MouseMove middle = desk.over("view");
  CHECK(count_of<TurnToStep>(desk.frames({middle, MouseClick{MouseButton::Left, true}})) <= 1);
  for (int i = 1; i < 5; ++i) {
    const Actions dragged = desk.frame({MouseMove{middle.x + 2.0f * static_cast<float>(i), middle.y}});
    CHECK(count_of<TurnToStep>(dragged) == 0);
    desk.act(dragged);
  }
  desk.frame({MouseClick{MouseButton::Left, false}});
  for (int i = 0; i < 5; ++i) CHECK(count_of<TurnToStep>(desk.frame()) == 0);
  desk.act({StepBy{}});
  CHECK(count_of<TurnToStep>(desk.frame()) == 1);
}

TEST_CASE("played fast the view stays, and without motion it is there at once") {
  Desk desk;
  stand_behind(desk);
  desk.act({SetFollowing{true}, StepBy{}, SetPlaying{true, 1}, SetSpeed{300.0}});
  CHECK(count_of<TurnToStep>(desk.frame()) == 0);
  desk.act({SetSpeed{20.0}});
  const Actions turn = desk.frame();
  CHECK(count_of<TurnToStep>(turn) == 1);
  desk.act(turn);
  desk.act({SetPlaying{false, 1}, SetMotion{false}});
  for (int i = 0; i < 4; ++i) desk.act(desk.frame());
  CHECK(desk.frame().empty());
  CHECK(facing(desk.session.view->gaze.camera, *step_place(desk.session)) > 0.2);
}

TEST_CASE("in a lesson the view follows, until a person says otherwise and left, it is as before") {
  Desk desk;
  desk.session.program->assets = KNIT_ASSETS_DIR;
  desk.act({StartLesson{"picking-a-row"}});
  REQUIRE(desk.session.learning->lesson);
  CHECK(desk.session.view->following);
  desk.act({SetFollowing{false}, TurnLesson{0}});
  CHECK_FALSE(desk.session.view->following);
  desk.act({LeaveLesson{}});
  CHECK_FALSE(desk.session.view->following);
}
