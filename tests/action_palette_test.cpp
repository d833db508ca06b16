// The palette of all actions by keyboard and mouse, and the ways that lead there.
#include "app/panels/dialogs/action_palette.h"
#include "app/entries/action_entries.h"
#include "app/panels/dialogs/file_dialogs.h"
#include "app/session/document.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

namespace {

constexpr Chord palette_key{Key::P, {.ctrl = true}, 0};
constexpr Chord enter{Key::Enter, {}, 0};
constexpr Chord escape{Key::Escape, {}, 0};
constexpr Chord down{Key::Down, {}, 0};
constexpr Chord up{Key::Up, {}, 0};

struct PaletteDesk : Desk {
  explicit PaletteDesk(float width = 1280, float height = 720) : Desk(width, height) {
    session.program->assets = KNIT_ASSETS_DIR;
    open();
    show();
  }
  void show() {
    act(press(palette_key));
    REQUIRE(session.view->dialogs.action_palette_open);
    settle();
  }
  // What Enter wishes beside closing the palette.
  Actions done() {
    // As in the window: what a frame wishes is done before the next one.
    Actions wishes;
    for (const bool pressed : {true, false}) {
      for (Action& wish : frame({KeyPress{Key::Enter, pressed, {}}})) {
        app::apply(session, wish);
        wishes.push_back(std::move(wish));
      }
    }
    CHECK(count_of<ShowActionPalette>(wishes) == 1);
    wishes.erase(std::remove_if(wishes.begin(), wishes.end(),
                                [](const Action& a) { return a.is<ShowActionPalette>(); }),
                 wishes.end());
    CHECK_FALSE(session.view->dialogs.action_palette_open);
    settle();
    return wishes;
  }
  [[nodiscard]] bool lists(const std::string& words) const {
    return ui.controls.count("action/" + words) == 1;
  }
};

}  // namespace

TEST_CASE("Ctrl+P opens the palette, and Ctrl+P, Escape or a click beside it closes it") {
  PaletteDesk desk;
  CHECK(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
  SECTION("Ctrl+P") { desk.act(desk.press(palette_key)); }
  SECTION("Escape") { desk.act(desk.press(escape)); }
  SECTION("a click") {
    desk.act(desk.frames({desk.over("play"), MouseClick{MouseButton::Left, true},
                          MouseClick{MouseButton::Left, false}, MouseLeave{}}));
  }
  SECTION("another hand") { desk.session.view->dialogs.action_palette_open = false; }
  desk.settle();
  CHECK_FALSE(desk.session.view->dialogs.action_palette_open);
  CHECK_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
  CHECK(desk.ui.controls.count("action-field") == 0);
  only<SetPlaying>(desk.press({Key::Space, {}, 0}));
}

TEST_CASE("the palette finds as one types, and Enter does the first") {
  PaletteDesk desk;
  desk.type("ex vase");
  desk.settle();
  CHECK(desk.lists("Open the example vase"));
  CHECK_FALSE(desk.lists("Play or pause"));
  const Actions done = desk.done();
  CHECK(only<OpenExample>(done).name == "vase");
  // The keys are the program's again.
  only<SetPlaying>(desk.press({Key::Space, {}, 0}));
}

TEST_CASE("arrow keys choose in the palette, and what was used lately is first") {
  PaletteDesk desk;
  desk.type("look from");
  CHECK(desk.press(down).empty());
  CHECK(desk.press(down).empty());
  CHECK(desk.press(up).empty());
  CHECK(desk.ui.own<ActionPaletteState>().chosen == 1);
  only<Orbit>(desk.done());
  REQUIRE(desk.ui.own<ActionPaletteState>().recent.size() == 1);
  const std::string used = desk.ui.own<ActionPaletteState>().recent[0];
  desk.show();
  CHECK(desk.press({Key::PageDown, {}, 0}).empty());
  CHECK(desk.press({Key::PageDown, {}, 0}).empty());
  CHECK(desk.ui.own<ActionPaletteState>().chosen == 22);
  desk.settle();
  CHECK_FALSE(desk.lists(used));
  for (int i = 0; i < 4; ++i) CHECK(desk.press({Key::PageUp, {}, 0}).empty());
  desk.settle();
  CHECK(desk.lists(used));
  only<Orbit>(desk.done());
  CHECK(desk.ui.own<ActionPaletteState>().recent.size() == 1);
}

TEST_CASE("the palette goes by the mouse") {
  PaletteDesk desk;
  desk.type("torus");
  desk.settle();
  const Actions wishes = desk.click("action/Open the example torus");
  CHECK(count_of<OpenExample>(wishes) == 1);
  CHECK(count_of<ShowActionPalette>(wishes) == 1);
}

TEST_CASE("an entry that asks turns the field into a prompt that says why something is refused") {
  PaletteDesk desk;
  desk.type("go to row");
  CHECK(desk.press(enter).empty());
  desk.settle();
  REQUIRE(desk.session.view->dialogs.action_palette_open);
  CHECK(desk.ui.controls.count("action-trouble") == 0);
  desk.type("x");
  desk.settle();
  CHECK(desk.ui.controls.count("action-trouble") == 1);
  CHECK(desk.press(enter).empty());
  SECTION("mended") {
    CHECK(desk.press({Key::Backspace, {}, 0}).empty());
    desk.type("2");
    desk.settle();
    CHECK(desk.ui.controls.count("action-trouble") == 0);
    CHECK(only<SeekPlace>(desk.done()).place.row == 2);
    CHECK(desk.ui.own<ActionPaletteState>().recent.front() == "Go to row...");
  }
  SECTION("Escape goes back to what was searched for, and then closes") {
    CHECK(desk.press(escape).empty());
    desk.settle();
    CHECK(desk.lists("Go to row..."));
    CHECK(std::string(desk.ui.own<ActionPaletteState>().field.data()) == "go to row");
    CHECK_FALSE(only<ShowActionPalette>(desk.press(escape)).open);
  }
  SECTION("the mesh goes away meanwhile") {
    desk.session.document.reset();
    desk.settle();
    CHECK(desk.ui.controls.count("action-foot") == 1);
    CHECK(desk.press(enter).empty());
  }
}

TEST_CASE("what cannot be done now is not done") {
  PaletteDesk desk;
  desk.type("undo");
  CHECK(desk.press(enter).empty());
  CHECK(desk.session.view->dialogs.action_palette_open);
  desk.session.document->changes.undo.emplace_back();
  desk.settle();
  only<Undo>(desk.done());
}

TEST_CASE("pasting asks the clipboard when it is chosen, and saving opens its dialog") {
  PaletteDesk desk;
  desk.type("paste");
  CHECK(only<PasteParameters>(desk.done()).text == desk.clipboard);
  desk.show();
  desk.type("save report card");
  CHECK(desk.done().empty());
  CHECK(desk.ui.own<SaveDialog>().wanted == find_export("card"));
  desk.settle();
  CHECK(desk.ui.controls.count("save/path") == 1);
}

TEST_CASE("the palette lies within the window at any size") {
  for (const auto& [width, height] :
       std::vector<std::pair<float, float>>{{1280, 720}, {1920, 1080}, {640, 480}}) {
    PaletteDesk desk(width, height);
    for (const char* name : {"action-field", "action-foot"}) {
      const Box box = desk.ui.controls.at(name);
      INFO(name << " at " << width);
      CHECK(box.x >= 0.0f);
      CHECK(box.right() <= width);
      CHECK(box.bottom() <= height);
    }
  }
}

TEST_CASE("the help leads on to all actions, the glossary and the lessons") {
  Desk desk(1280, 720);
  desk.open();
  desk.session.view->dialogs.help_open = true;
  desk.settle();
  const Box help = desk.ui.controls.at("help");
  for (const char* name : {"help-to/actions", "help-to/glossary", "help-to/lessons"})
    CHECK(desk.ui.controls.at(name).bottom() <= help.bottom());
  SECTION("all actions") {
    desk.act(desk.click("help-to/actions"));
    CHECK(desk.session.view->dialogs.action_palette_open);
  }
  SECTION("the glossary") {
    desk.act(desk.click("help-to/glossary"));
    CHECK(desk.session.view->dialogs.glossary_open);
  }
  SECTION("the lessons") {
    desk.act(desk.click("help-to/lessons"));
    desk.settle();
    CHECK(std::string(desk.ui.own<ActionPaletteState>().field.data()) == "lesson ");
  }
  CHECK_FALSE(desk.session.view->dialogs.help_open);
}
