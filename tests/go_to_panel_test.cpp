// Asking where to go, by keyboard and mouse, and the list of all actions that understands the same words.
#include "app/panels/dialogs/action_palette.h"

#include <algorithm>

#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

namespace {

constexpr Chord go_to_key{Key::G, {.ctrl = true}, 0};

struct GoToDesk : Desk {
  GoToDesk() : Desk(1280, 720) {
    session.program->assets = KNIT_ASSETS_DIR;
    open();
    act(press(go_to_key));
    REQUIRE(session.view->dialogs.go_to_open);
    settle();
  }
  [[nodiscard]] bool shows(const std::string& control) const { return ui.controls.count(control) == 1; }
  // What a key wishes, done as in the window before the next frame.
  Actions done(Key key) {
    Actions wishes;
    for (const bool pressed : {true, false}) {
      for (Action& wish : frame({KeyPress{key, pressed, {}}})) {
        app::apply(session, wish);
        wishes.push_back(std::move(wish));
      }
    }
    settle();
    return wishes;
  }
};

// Where the one wish to go leads, among others.
std::string gone(const Actions& wishes) {
  REQUIRE(count_of<GoTo>(wishes) == 1);
  const auto to = std::find_if(wishes.begin(), wishes.end(), [](const Action& a) { return a.is<GoTo>(); });
  return to->get<GoTo>().where;
}

}  // namespace

TEST_CASE("Ctrl+G asks where to go, says what is there as one types, and Enter goes") {
  GoToDesk desk;
  CHECK(desk.shows("go-to/form/1"));
  desk.type("Row 3");
  desk.settle();
  CHECK(desk.shows("go-to/there"));
  const Actions wishes = desk.done(Key::Enter);
  CHECK(gone(wishes) == "Row 3");
  CHECK_FALSE(desk.session.view->dialogs.go_to_open);
  CHECK(desk.session.document->timeline.state().fabric.row_count() == 3);
  CHECK(desk.session.document->place_note.rfind("Row 3 has ", 0) == 0);
}

TEST_CASE("what is no place is said, and Enter stays") {
  GoToDesk desk;
  desk.type("row 999");
  desk.settle();
  CHECK(desk.shows("go-to/trouble"));
  CHECK(count_of<GoTo>(desk.done(Key::Enter)) == 0);
  CHECK(desk.session.view->dialogs.go_to_open);
  desk.done(Key::Escape);
  CHECK_FALSE(desk.session.view->dialogs.go_to_open);
}

TEST_CASE("Tab completes, and a click takes a form") {
  GoToDesk desk;
  desk.type("wid");
  desk.settle();
  CHECK(desk.shows("go-to/foot"));
  desk.done(Key::Tab);
  CHECK(gone(desk.done(Key::Enter)) == "widest round");
  desk.act(desk.press(go_to_key));
  desk.settle();
  desk.act(desk.click("go-to/form/1"));
  desk.settle();
  CHECK(desk.shows("go-to/trouble") != desk.shows("go-to/there"));
}

TEST_CASE("the list of all actions goes to a place that is typed, before all else") {
  GoToDesk desk;
  desk.done(Key::Escape);
  desk.act(desk.press({Key::P, {.ctrl = true}, 0}));
  desk.settle();
  desk.type("stitch 2:1");
  desk.settle();
  CHECK(desk.shows("action/Go to: stitch 2:1"));
  const Actions wishes = desk.done(Key::Enter);
  CHECK(gone(wishes) == "stitch 2:1");
  CHECK(desk.session.document->travel.selected == knit::Element(knit::StitchElement{2, 0}));
}

TEST_CASE("the menu Why asks about what is shown") {
  Desk desk;
  desk.open();
  desk.settle();
  desk.act(desk.click("menu/why"));
  desk.settle();
  const Actions wishes = desk.click("menu/Why does this row have so many stitches?");
  CHECK(gone(wishes) == "why row");
}
