// The checker of written patterns in its panel: typing, verdicts beside the lines, clicks that lead to a mistake.
#include "app/panels/checker/checker_panel.h"

#include <imgui.h>

#include "app/panels/checker/checker_parts.h"
#include "app/scene/contrast.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

namespace {

const std::string bad = "CO 6 sts.\nRnd 1: Knit. (7 sts)\nRnd 2: Knit. (6 sts)\nRnd 3: Knit. (5 sts)\n";

void show_checker(Desk& desk, const std::string& text) {
  desk.act({ShowChecker{}, SetCheckedText{text}});
  desk.layout = layout_of(1280, 720, 1, layout_wish(desk.session));
  desk.settle();
}

const Checker& checker_of(const Desk& desk) { return *desk.session.view->checker; }

Actions done(Desk& desk, std::initializer_list<InputEvent> events) {
  Actions all;
  for (const InputEvent& event : events) {
    Actions wishes = desk.frame({event});
    desk.act(wishes);
    for (Action& wish : wishes) all.push_back(std::move(wish));
  }
  return all;
}

void type(Desk& desk, const std::string& words) {
  for (const char c : words) done(desk, {Text{static_cast<char32_t>(c)}});
}

Actions press(Desk& desk, Key key, Mods mods = {}) {
  return done(desk,
              {KeyPress{key, true, mods}, KeyPress{key, false, mods}, KeyPress{Key::LeftShift, false, {}}});
}

Actions click(Desk& desk, const std::string& control, float across = 0.5f) {
  Actions all = done(desk, {desk.over(control, across), MouseClick{MouseButton::Left, true},
                            MouseClick{MouseButton::Left, false}});
  for (int i = 0; i < 4; ++i)
    for (Action& wish : done(desk, {MouseLeave{}})) all.push_back(std::move(wish));
  return all;
}

}  // namespace

TEST_CASE("F7 shows the checker with nothing open, in place of all about the mesh, and Esc puts it away") {
  Desk desk;
  desk.settle();
  desk.act({Action(only<ShowChecker>(desk.press({Key::F7, {}, 0})))});
  desk.layout = layout_of(1280, 720, 1, layout_wish(desk.session));
  desk.settle();
  for (const char* there : {"checker/text", "checker/view", "checker/summary", "checker/open", "menu/file"})
    CHECK(desk.ui.controls.count(there) == 1);
  for (const char* gone : {"play", "knob/epsilon", "view", "welcome/open"})
    CHECK(desk.ui.controls.count(gone) == 0);
  const Layout& layout = desk.layout;
  CHECK(layout.checker.right() == layout.view.x);
  CHECK(layout.view.right() == layout.window.right());
  desk.act(desk.press({Key::Escape, {}, 0}));
  CHECK_FALSE(desk.session.view->checking);
}

TEST_CASE("what is typed reaches the session letter by letter, and letters are no commands") {
  Desk desk;
  desk.open();
  show_checker(desk, "");
  click(desk, "checker/text");
  type(desk, "CO 6 sts.");
  press(desk, Key::Enter);
  type(desk, "Rnd 1: Knit. (6 sts)");
  CHECK(*checker_of(desk).text == "CO 6 sts.\nRnd 1: Knit. (6 sts)");
  CHECK(checker_of(desk).checked->verdict == CheckVerdict::holds);
  CHECK(checker_of(desk).caret.line == 2);
  CHECK_FALSE(desk.session.view->playback.playing);
  // Esc leaves the text and takes nothing back.
  press(desk, Key::Escape);
  desk.settle();
  CHECK(*checker_of(desk).text == "CO 6 sts.\nRnd 1: Knit. (6 sts)");
  CHECK(desk.session.view->checking);
  press(desk, Key::Space);
  CHECK_FALSE(desk.session.view->playback.playing);
}

TEST_CASE("a click on a mistake marks what it is about, and what is typed takes its place") {
  Desk desk;
  show_checker(desk, bad);
  CHECK(desk.ui.controls.count("checker/mistake/2") == 1);
  CHECK(desk.ui.controls.count("checker/mistake/4") == 1);
  CHECK(desk.ui.controls.count("checker/mistake/3") == 0);
  click(desk, "checker/mistake/2");
  CHECK(checker_of(desk).caret.line == 2);
  CHECK(desk.ui.own<CheckerField>().active);
  const TextCaret marked = checker_of(desk).caret;
  REQUIRE(marked.length > 0);
  std::string should = bad;
  should.replace(10 + marked.at, marked.length, "x");
  type(desk, "x");
  CHECK(*checker_of(desk).text == should);
}

TEST_CASE("F4 goes from mistake to mistake while one types") {
  Desk desk;
  show_checker(desk, bad);
  click(desk, "checker/text");
  REQUIRE(desk.ui.own<CheckerField>().active);
  done(desk, {KeyPress{Key::Home, true, {.ctrl = true}}, KeyPress{Key::Home, false, {}}});
  press(desk, Key::F4);
  CHECK(checker_of(desk).caret.line == 2);
  desk.act(desk.frame());
  press(desk, Key::F4);
  CHECK(checker_of(desk).caret.line == 4);
  press(desk, Key::F4, {.shift = true});
  CHECK(checker_of(desk).caret.line == 2);
}

TEST_CASE("Paste takes the clipboard in place of all, and Put back brings the text of before") {
  Desk desk;
  show_checker(desk, bad);
  desk.clipboard = "CO 9 sts.\nRnd 1: Knit. (9 sts)\n";
  click(desk, "checker/paste");
  CHECK(*checker_of(desk).text == desk.clipboard);
  CHECK(desk.ui.own<CheckerField>().words == desk.clipboard);
  desk.settle();
  click(desk, "checker/restore");
  CHECK(*checker_of(desk).text == bad);
}

TEST_CASE("the text is saved where one says, and Ctrl+S asks once") {
  const test_support::Folder folder;
  Desk desk;
  show_checker(desk, bad);
  click(desk, "checker/text");
  done(desk, {KeyPress{Key::S, true, {.ctrl = true}}, KeyPress{Key::S, false, {}}});
  desk.settle();
  REQUIRE(desk.ui.controls.count("checker/path") == 1);
  done(desk, {KeyPress{Key::A, true, {.ctrl = true}}, KeyPress{Key::A, false, {}}});
  type(desk, (folder.path() / "a.txt").string());
  desk.settle();
  click(desk, "checker/save-it");
  CHECK(test_support::read_text(folder.path() / "a.txt") == bad);
  click(desk, "checker/text");
  type(desk, "K");
  done(desk, {KeyPress{Key::S, true, {.ctrl = true}}, KeyPress{Key::S, false, {}}});
  CHECK(test_support::read_text(folder.path() / "a.txt") == *checker_of(desk).text);
}

TEST_CASE("a click on the shape goes to the round's line, and a drag turns it") {
  Desk desk;
  show_checker(desk, "CO 40 sts.\nRnds 1-8: Knit. (40 sts)\nBO all.\n");
  const Camera before = checker_of(desk).camera;
  const MouseMove at = desk.over("checker/view");
  done(desk, {at, MouseClick{MouseButton::Left, true}, MouseMove{at.x + 60.0f, at.y},
              MouseMove{at.x + 80.0f, at.y}, MouseClick{MouseButton::Left, false}});
  CHECK_FALSE(checker_of(desk).camera == before);
  const Actions wishes =
      done(desk, {at, MouseClick{MouseButton::Left, true}, MouseClick{MouseButton::Left, false}});
  CHECK(count_of<GoToCheckedLine>(wishes) == 1);
}

TEST_CASE("every verdict has its own sign, and a colour that can be told from the panel") {
  for (const Theme* theme : {&dark_theme, &light_theme}) {
    for (const Colour& colour : {theme->selected, theme->problem, theme->warning, theme->faint_text})
      CHECK(contrast(opaque(colour), theme->panel) >= 3.0);
  }
}

TEST_CASE("of a large text a worker reads, and only the lines in sight are drawn") {
  Desk desk;
  desk.session.jobs->beside = true;
  std::string large = "CO 12 sts.\n";
  for (int i = 1; large.size() < 200'000; ++i) large += "Rnd " + std::to_string(i) + ": Knit. (12 sts)\n";
  show_checker(desk, large);
  CHECK(desk.session.jobs->pattern_check);
  CHECK(desk.ui.controls.count("checker/line/1") == 1);
  CHECK(desk.ui.controls.count("checker/line/2000") == 0);  // only what is in sight is drawn
}
