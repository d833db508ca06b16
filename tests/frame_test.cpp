// What a frame draws again, and what it leaves as it was.
#include "app/window/frame.h"

#include "app/render/headless_gl.h"
#include "app/session/program.h"
#include "app/window/turn.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

TEST_CASE("what the last of the work beside brings is drawn until all has its size") {
  Pace pace;
  pace.frames_due = 0;
  pace.look_at(false);
  CHECK(pace.frames_due == 0);
  pace.look_at(true);
  CHECK(pace.frames_due == 0);
  pace.look_at(false);
  CHECK(pace.frames_due == frames_after_event);
  pace.frames_due = 0;
  pace.look_at(false);
  CHECK(pace.frames_due == 0);
}

TEST_CASE("the view is drawn again only where it shows something else, so that typing does not wait for it") {
  HeadlessGl gl = std::get<HeadlessGl>(HeadlessGl::open());
  Session session = test_support::finished_small_session();
  FrameDrawer drawer(session.program->assets);
  FrameShape shape{800, 600, 800, 600};
  for (int i = 0; i < 4; ++i) drawer.draw(session, shape, {});
  apply(session, ShowGoTo{});
  for (int i = 0; i < 4; ++i) drawer.draw(session, shape, {});
  const std::size_t views = drawer.views_drawn();
  const Image before = drawer.target().read();
  shape.samples = 1;  // while things move on a slow machine
  for (const char32_t letter : std::u32string(U"row 7")) drawer.draw(session, shape, {Text{letter}});
  CHECK(drawer.views_drawn() == views);
  shape.samples = 4;
  drawer.draw(session, shape, {});
  CHECK(drawer.views_drawn() == views);
  CHECK(drawer.target().read().rgba != before.rgba);  // what was typed is seen
  apply(session, Orbit{0.4, 0.0});
  drawer.draw(session, shape, {});
  CHECK(drawer.views_drawn() == views + 1);
  apply(session, StepBy{Unit::row, -1});
  drawer.draw(session, shape, {});
  CHECK(drawer.views_drawn() == views + 2);
  // A picture of something else in between is none of the view.
  drawer.finished(session, 200);
  drawer.draw(session, shape, {});
  CHECK(drawer.views_drawn() == views + 3);
}

TEST_CASE("a view that is kept looks as one that is drawn") {
  HeadlessGl gl = std::get<HeadlessGl>(HeadlessGl::open());
  Session session = test_support::finished_small_session();
  const FrameShape shape{640, 400, 640, 400};
  FrameDrawer drawer(session.program->assets);
  for (int i = 0; i < 5; ++i) drawer.draw(session, shape, {});
  const Image kept = drawer.target().read();
  drawer.finished(session, 100);
  drawer.draw(session, shape, {});
  CHECK(drawer.target().read().rgba == kept.rgba);
}
