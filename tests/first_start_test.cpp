// The first start in a window: a line that says what this is, the first lesson one click away, and gone once one knows.
#include "app/actions/hosting.h"
#include "app/session/jobs.h"
#include "app/session/program.h"
#include "tests/support/desk.h"

using namespace desk;

namespace {

bool says_what_this_is(Desk& desk) {
  desk.settle();
  return desk.ui.controls.count("first-start/lesson") == 1;
}

}  // namespace

TEST_CASE("first start: a line offers the first lesson until it is put away, and to nobody who knows",
          "[first-start]") {
  Desk desk;
  desk.open();
  CHECK_FALSE(says_what_this_is(desk));  // no window: a picture has none
  set_beside(desk.session, true);
  REQUIRE(says_what_this_is(desk));
  CHECK(only<StartLesson>(desk.click("first-start/lesson")).key == "what-it-does");
  desk.session.program->preferences.lessons["what-it-does"] = {};
  CHECK_FALSE(says_what_this_is(desk));
  desk.session.program->preferences.lessons.clear();
  desk.session.program->preferences.recent = {"example:egg", "example:cone"};
  CHECK_FALSE(says_what_this_is(desk));
  desk.session.program->preferences.recent.clear();
  REQUIRE(says_what_this_is(desk));
  CHECK(desk.click("first-start/away").empty());
  CHECK_FALSE(says_what_this_is(desk));
}
