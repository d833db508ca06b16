// Dragging, closing and opening panels, the look's menus, and the empty state: each act gives its one wish.
#include <array>

#include "app/session/preferences.h"
#include "app/session/program.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

namespace {

using namespace desk;

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

bool inside(const Box& a, const Box& b) {
  return a.x >= b.x && a.y >= b.y && a.right() <= b.right() && a.bottom() <= b.bottom();
}

// As the loop does before each frame.
void lay_out(Desk& desk) {
  const Box window = desk.layout.window;
  desk.layout = layout_of(window.width, window.height, desk.layout.scale, layout_wish(desk.session));
  desk.settle();
}

// From the middle of a splitter, so many units, without letting go.
Actions drag(Desk& desk, const std::string& splitter, float x, float y) {
  const MouseMove from = desk.over(splitter);
  Actions wishes = desk.frames({from, MouseClick{MouseButton::Left, true}});
  CHECK(wishes.empty());
  return desk.frames({MouseMove{from.x + x, from.y + y}});
}

}  // namespace

TEST_CASE("dragging a splitter makes its panel as large as the pointer says, and the view gives way") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  desk.open();
  const Layout before = desk.layout;
  struct Drag {
    const char* name;
    Split split;
    float x, y;
  };
  for (const Drag& d : {Drag{"split/left", Split::left, 40, 0}, Drag{"split/right", Split::right, -30, 0},
                        Drag{"split/bottom", Split::bottom, 0, -50}}) {
    INFO(d.name);
    const Actions wishes = drag(desk, d.name, d.x, d.y);
    CHECK(only<SetSplit>(wishes).split == d.split);
    desk.act(wishes);
    lay_out(desk);
    CHECK(desk.frame().empty());  // it is there
    CHECK(desk.frames({MouseClick{MouseButton::Left, false}, MouseLeave{}}).empty());
  }
  CHECK(desk.layout.parameters.width == before.parameters.width + 40);
  CHECK(desk.layout.explanation.width == before.explanation.width + 30);
  CHECK(desk.layout.timeline.height == before.timeline.height + 50);
  CHECK(desk.layout.view.width == before.view.width - 70);
  CHECK(desk.ui.controls.at("view") == desk.layout.view);
}

TEST_CASE("a drag stops where the view has its third, at every scale, and a double click undoes it") {
  for (const float scale : {1.0f, 2.0f}) {
    Desk desk(1280 * scale, 720 * scale, scale);
    desk.open();
    const float right = desk.layout.explanation.width;
    desk.act(drag(desk, "split/left", 1200 * scale, 0));
    desk.frames({MouseClick{MouseButton::Left, false}, MouseLeave{}});
    lay_out(desk);
    CHECK(desk.layout.view.width >= desk.layout.window.width / 3 - 1);
    CHECK(desk.layout.explanation.width == right);
    desk.act(drag(desk, "split/left", -1200 * scale, 0));
    desk.frames({MouseClick{MouseButton::Left, false}, MouseLeave{}});
    lay_out(desk);
    CHECK(desk.layout.parameters.width == 264 * scale);
    desk.frames({desk.over("split/left")});
    const Actions twice =
        desk.frames({MouseClick{MouseButton::Left, true}, MouseClick{MouseButton::Left, false},
                     MouseClick{MouseButton::Left, true}, MouseClick{MouseButton::Left, false}});
    CHECK(only<SetSplit>(twice).size == 0.0);
  }
}

TEST_CASE("a splitter can be gripped over both its panels, and turns nothing in the view") {
  Desk desk(1280, 720);
  desk.open();
  const float border = desk.layout.parameters.right();
  for (const float x : {border - 2, border + 2}) {
    desk.frames({MouseMove{x, 300}, MouseClick{MouseButton::Left, true}});
    const Actions wishes = desk.frames({MouseMove{x + 20, 310}});
    CHECK(count_of<Orbit>(wishes) == 0);
    CHECK(only<SetSplit>(wishes).size == desk.layout.parameters.width + 20);
    desk.frames({MouseClick{MouseButton::Left, false}, MouseLeave{}});
  }
}

TEST_CASE("every panel has a cross, and a button in the menu bar opens it again") {
  struct Closing {
    Panel panel;
    const char* key;
    const char* inhabitant;
  };
  for (const Closing& c :
       {Closing{Panel::parameters, "parameters", "mode"}, Closing{Panel::side, "side", "side/step"},
        Closing{Panel::timeline, "timeline", "play"}}) {
    Desk desk(1280, 720);
    desk.open();
    CHECK(desk.ui.controls.count(c.inhabitant) == 1);
    const Actions closing = desk.click(std::string("close/") + c.key);
    CHECK(only<ShowPanel>(closing).panel == c.panel);
    CHECK_FALSE(only<ShowPanel>(closing).open);
    const float view = desk.layout.view.width * desk.layout.view.height;
    desk.act(closing);
    lay_out(desk);
    CHECK(desk.ui.controls.count(c.inhabitant) == 0);
    CHECK(desk.layout.view.width * desk.layout.view.height > view);
    CHECK(desk.ui.controls.at("view") == desk.layout.view);
    const Actions opening = desk.click(std::string("toggle/") + c.key);
    CHECK(only<ShowPanel>(opening).open);
    desk.act(opening);
    lay_out(desk);
    CHECK(desk.ui.controls.count(c.inhabitant) == 1);
  }
}

TEST_CASE("one key puts all panels away and brings them back, others change size and theme") {
  Desk desk(1280, 720);
  desk.open();
  const Chord f9{Key::F9, {}, 0};
  desk.act(desk.press(f9));
  lay_out(desk);
  CHECK(desk.layout.view.width == 1280.0f);
  CHECK(desk.layout.view.bottom() == 720.0f);
  desk.act(desk.press(f9));
  CHECK(desk.session.program->preferences == Preferences{});
  desk.act(desk.press({Key::F8, {}, 0}));
  CHECK(desk.session.program->preferences.theme == ThemeKind::light);
  const Mods ctrl{.ctrl = true};
  desk.act(desk.press({Key::Equal, ctrl, 0}));
  CHECK(desk.session.program->preferences.scale > 1.0);
  for (int i = 0; i < 20; ++i) desk.act(desk.press({Key::Equal, {.shift = true, .ctrl = true}, 0}));
  CHECK(desk.session.program->preferences.scale == largest_scale);
  CHECK(desk.press({Key::Equal, ctrl, 0}).empty());
  for (int i = 0; i < 20; ++i) desk.act(desk.press({Key::Minus, ctrl, 0}));
  CHECK(desk.session.program->preferences.scale == smallest_scale);
  desk.act(desk.press({Key::Digit0, ctrl, 0}));
  CHECK(desk.session.program->preferences.scale == 1.0);
}

TEST_CASE("the crosses stand clear of their neighbours, in the narrowest panels too") {
  for (const float scale : {1.0f, 1.5f, 2.0f}) {
    for (const bool narrow : {false, true}) {
      Desk desk(1280 * scale, 720 * scale, scale, KNIT_ASSETS_DIR "/fonts");
      desk.open();
      if (narrow) desk.session.program->preferences.splits = {1.0, 1.0, 1.0};
      lay_out(desk);
      const auto& at = desk.ui.controls;
      for (const char* tool : {"undo", "redo", "copy", "paste"})
        CHECK_FALSE(overlap(at.at("close/parameters"), at.at(tool)));
      for (const std::string_view key : side_keys) {
        const std::string tab = "side/" + std::string(key);
        CHECK_FALSE(overlap(at.at("close/side"), at.at(tab)));
        CHECK(inside(at.at(tab), desk.layout.explanation));
      }
      CHECK(inside(at.at("close/parameters"), desk.layout.parameters));
      CHECK(inside(at.at("close/side"), desk.layout.explanation));
      CHECK(inside(at.at("close/timeline"), desk.layout.timeline));
      for (const char* toggle : {"toggle/parameters", "toggle/timeline", "toggle/side"})
        CHECK(inside(at.at(toggle), desk.layout.menu));
    }
  }
}

TEST_CASE("the row of play buttons fits its window: words go first, then the speed slider") {
  struct Fit {
    float width, height, scale;
    bool speed, unit, ways;
  };
  for (const Fit& fit : {Fit{1280, 720, 1, true, true, true}, Fit{1280, 720, 1.25f, true, true, true},
                         Fit{1280, 720, 1.5f, true, true, true}, Fit{1280, 720, 2, false, true, true},
                         Fit{1280, 720, 2.5f, false, true, false}, Fit{640, 400, 1, false, true, true},
                         Fit{3840, 2160, 2, true, true, true}}) {
    INFO(fit.width << " by " << fit.scale);
    Desk desk(fit.width, fit.height, fit.scale, KNIT_ASSETS_DIR "/fonts");
    desk.open();
    const auto& at = desk.ui.controls;
    CHECK((at.count("speed") == 1) == fit.speed);
    CHECK((at.count("unit") == 1) == fit.unit);
    CHECK((at.count("loop") == 1) == fit.ways);
    std::vector<std::string> there;
    for (const char* name : {"first", "back", "play", "forward", "last", "unit", "speed", "slow-motion",
                             "loop", "position", "close/timeline"}) {
      if (at.count(name) == 1) there.emplace_back(name);
    }
    CHECK(there.size() >= 7);
    for (std::size_t i = 0; i < there.size(); ++i) {
      INFO(there[i]);
      CHECK(at.at(there[i]).x >= desk.layout.timeline.x);
      CHECK(at.at(there[i]).right() <= desk.layout.timeline.right());
      for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(overlap(at.at(there[i]), at.at(there[j])));
    }
  }
}

TEST_CASE("the recent files are in the File menu") {
  Desk desk(1280, 720);
  desk.open();
  desk.session.program->preferences.recent = {"/tmp/a.obj", "example:vase", "/tmp/s.json"};
  CHECK(desk.click("menu/file").empty());
  CHECK(desk.click("menu/Open recent").empty());
  desk.settle();
  CHECK(only<OpenExample>(desk.click("recent/1")).name == "vase");
  CHECK(desk.click("menu/file").empty());
  CHECK(desk.click("menu/Open recent").empty());
  desk.settle();
  only<ForgetRecent>(desk.click("recent/forget"));
}

TEST_CASE("the View menu has panels, theme, size, motion and a way back") {
  struct Choice {
    const char* menu;
    const char* item;
    bool (*asked)(const Action&);
  };
  for (const Choice& c :
       {Choice{"menu/Panels", "menu/Explanation",
               [](const Action& a) {
                 return a.get<ShowPanel>().panel == Panel::side && !a.get<ShowPanel>().open;
               }},
        Choice{"menu/Panels", "menu/Reset the layout", [](const Action& a) { return a.is<ResetLayout>(); }},
        Choice{"menu/Theme", "menu/Light",
               [](const Action& a) { return a.get<SetTheme>().theme == ThemeKind::light; }},
        Choice{"menu/Size", "menu/Projector",
               [](const Action& a) { return a.get<SetScale>().scale == projector_scale; }},
        Choice{"menu/Motion", nullptr, [](const Action& a) { return !a.get<SetMotion>().on; }}}) {
    INFO(c.menu);
    Desk desk(1280, 720);
    desk.open();
    CHECK(desk.click("menu/view").empty());
    desk.settle();
    Actions wishes = desk.click(c.menu);
    desk.settle();
    if (c.item != nullptr) wishes = desk.click(c.item);
    REQUIRE(wishes.size() == 1);
    CHECK(c.asked(wishes[0]));
  }
}

TEST_CASE("with nothing open the view says what to do") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  desk.session.program->assets = KNIT_ASSETS_DIR;
  desk.session.program->preferences.recent = {"/tmp/a.obj", "example:vase"};
  desk.settle();
  for (const auto& [name, box] : desk.ui.controls) {
    INFO(name);
    if (name.rfind("welcome/", 0) == 0) CHECK(inside(box, desk.layout.view));
  }
  CHECK(only<ShowOpenDialog>(desk.click("welcome/open")).open);
  CHECK(only<StartLesson>(desk.click("welcome/lesson")).key == "what-it-does");
  CHECK(only<OpenExample>(desk.click("welcome/thesis-sphere")).name == "thesis-sphere");
  CHECK(only<OpenFile>(desk.click("welcome/recent/0")).path == "/tmp/a.obj");
  CHECK(only<OpenExample>(desk.click("welcome/recent/1")).name == "vase");
}
