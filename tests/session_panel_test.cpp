// Undo and redo by hand, the rescue banner, opening sessions, and the help with all its keys.
#include <fstream>

#include "app/panels/dialogs/file_dialogs.h"
#include "app/session/document.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

namespace {

bool inside(const Box& inner, const Box& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.right() <= outer.right() + 0.5f &&
         inner.bottom() <= outer.bottom() + 0.5f;
}

}  // namespace

TEST_CASE("a drag of a knob is one entry to undo, two drags are two") {
  Desk desk;
  desk.open();
  const Knobs before = knobs_of(desk.session.document->timeline);
  for (int drag = 1; drag <= 2; ++drag) {
    // Apart, so that the second is no double click.
    const MouseMove at = desk.over("knob/epsilon", drag == 1 ? 0.3f : 0.6f);
    desk.act(desk.frame({at}));
    desk.act(desk.frame({MouseClick{MouseButton::Left, true}}));
    std::size_t tunes = 0;
    for (int i = 1; i <= 6; ++i) {
      const Actions wishes = desk.frame({MouseMove{at.x + 6.0f * static_cast<float>(i), at.y}});
      tunes += count_of<Tune>(wishes);
      desk.act(wishes);
    }
    CHECK(tunes > 2);
    CHECK(desk.session.document->changes.open);
    desk.act(desk.frame({MouseClick{MouseButton::Left, false}}));
    desk.act(desk.frame({}));
    CHECK_FALSE(desk.session.document->changes.open);
    CHECK(desk.session.document->changes.undo.size() == static_cast<std::size_t>(drag));
  }
  desk.act(desk.click("undo"));
  desk.act(desk.click("undo"));
  CHECK(knobs_of(desk.session.document->timeline) == before);
  desk.act(desk.press({Key::Y, {.ctrl = true}, 0}));
  CHECK(desk.session.document->changes.undo.size() == 1);
}

TEST_CASE("a click on a choice is an entry of its own, also twice on the same knob") {
  Desk desk;
  desk.open();
  desk.act(desk.click("knob/last-anchor", 0.9f));
  desk.act(desk.click("knob/last-anchor", 0.1f));
  CHECK(desk.session.document->changes.undo.size() == 2);
  CHECK_FALSE(desk.session.document->changes.open);
}

TEST_CASE("the buttons over the knobs: grey while there is nothing to undo, copy and paste") {
  Desk desk;
  desk.open();
  for (const char* name : {"undo", "redo", "copy", "paste"})
    CHECK(inside(desk.ui.controls.at(name), desk.layout.parameters));
  CHECK(desk.click("undo").empty());
  CHECK(desk.click("redo").empty());
  only<CopyParameters>(desk.click("copy"));
  desk.act(desk.click("knob/last-anchor", 0.9f));
  only<Undo>(desk.click("undo"));
}

TEST_CASE("a session from before a crash is offered over the view") {
  Desk desk(1280, 720);
  desk.open();
  CHECK(desk.ui.controls.count("rescue/open") == 0);
  desk.session.program->rescued = Rescued{"/nowhere/session-1-1.json", "thesis-sphere, row 14"};
  desk.settle();
  CHECK(inside(desk.ui.controls.at("rescue/open"), desk.layout.view));
  CHECK(inside(desk.ui.controls.at("rescue/forget"), desk.layout.view));
  only<TakeRescued>(desk.click("rescue/open"));
  only<DropRescued>(desk.click("rescue/forget"));
}

TEST_CASE("the open dialog shows sessions and opens them as such") {
  const test_support::Folder folder;
  test_support::write_text(folder.path() / "saved.json", "{\"knit-mesh-session\": 1}");
  Desk desk;
  desk.open();
  desk.ui.own<OpenDialog>().folder = folder.path();
  desk.session.view->dialogs.open_dialog_open = true;
  desk.settle();
  CHECK(desk.ui.controls.count("open/saved.json") == 1);
  desk.type("saved.json");
  CHECK(count_of<OpenSession>(desk.press({Key::Enter, {}, 0})) == 1);
}

TEST_CASE("the help shows every key at 1280 x 720, without scrolling") {
  Desk desk(1280, 720);
  desk.open();
  desk.session.view->dialogs.help_open = true;
  desk.settle();
  CHECK(desk.ui.controls.at("help").y >= desk.layout.menu.bottom());
  for (const CommandInfo& info : command_table()) {
    const std::string name = "help/" + words_of(info);
    INFO(name);
    REQUIRE(desk.ui.controls.count(name) == 1);
    CHECK(inside(desk.ui.controls.at(name), desk.ui.controls.at("help")));
  }
}
