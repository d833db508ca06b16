// Keys: each gives its action, and none while a person types.
#include "app/panels/kit/commands.h"

#include <memory>
#include <set>

#include "app/checker/checker.h"
#include "app/panels/parameters/parameters.h"
#include "app/session/view.h"
#include "tests/support/desk.h"

using namespace desk;

TEST_CASE("every key of the table gives its action, and no key is nameless") {
  for (const CommandInfo& info : command_table()) {
    for (const Chord& chord : info.chords) {
      if (chord.key == Key::None && chord.character == 0) continue;
      Desk desk;
      desk.open();
      if (info.command == Command::close) desk.session.view->gaze.picking = Picking::start;
      if (info.command == Command::next_mistake || info.command == Command::last_mistake ||
          info.command == Command::save_checked) {
        desk.act({ShowChecker{}, SetCheckedText{"CO 6 sts.\nRnd 1: Knit. (7 sts)\n"}});
        auto named = std::make_shared<Checker>(*desk.session.view->checker);
        named->path = "pattern.txt";
        desk.session.view->checker = named;
      }
      INFO(tooltip_of(info) << " by " << text_of(chord));
      const Actions wishes = desk.press(chord);
      REQUIRE(wishes.size() == 1);
      const auto made = info.make(desk.session);
      REQUIRE(made);
      CHECK(wishes[0].index() == made->index());
      if (info.layer) CHECK(wishes[0].get<SetLayer>().layer == *info.layer);
      if (const auto* step = wishes[0].get_if<StepBy>()) {
        CHECK(step->unit == made->get<StepBy>().unit);
        CHECK(step->direction == made->get<StepBy>().direction);
      }
      CHECK((text_of(chord).back() != '?' || chord.character == '?'));
    }
  }
  for (std::size_t i = 0; i < layer_count; ++i) {
    CHECK(!keys_of(info_of(static_cast<Layer>(i))).empty());
  }
}

TEST_CASE("while a person types, keys are text and nothing else") {
  Desk desk;
  desk.open();
  CHECK(desk.click("knob/start", 0.2f).empty());
  desk.settle();  // the queue holds back keys for so long
  for (const CommandInfo& info : command_table()) {
    for (const Chord& chord : info.chords) {
      INFO(tooltip_of(info));
      if (info.command != Command::close && info.command != Command::first && info.command != Command::last) {
        CHECK(desk.press(chord).empty());
      }
    }
  }
  CHECK(desk.press({Key::Escape, {}, 0}).empty());  // leaves the field as it was
  CHECK(desk.click("knob/start", 0.2f).empty());
  desk.settle();  // the queue holds back keys for so long
  desk.type("17");
  const Actions entered = desk.frames({KeyPress{Key::Enter, true, {}}, KeyPress{Key::Enter, false, {}}});
  CHECK(only<Tune>(entered).parameters.timing.start == 17);
  CHECK(only<StepBy>(desk.press({Key::Right, {}, 0})).direction == 1);
}

TEST_CASE("a vertex that the mesh has not is refused where it is typed") {
  Desk desk;
  desk.open();
  CHECK(desk.click("knob/end", 0.2f).empty());
  desk.settle();
  desk.type("999999");
  CHECK(desk.frames({KeyPress{Key::Enter, true, {}}, KeyPress{Key::Enter, false, {}}}).empty());
  CHECK(desk.ui.own<KnobTroubles>().at("end").words.find("999999") != std::string::npos);
}

TEST_CASE("the key of the side panels goes round all that have a name, and each has its tab") {
  Desk desk;
  desk.open();
  std::set<std::string> tabs;
  for (const auto& [mark, box] : desk.ui.controls) {
    if (mark.starts_with("side/")) tabs.insert(mark.substr(5));
  }
  CHECK(tabs == std::set<std::string>(side_keys.begin(), side_keys.end()));
  std::set<std::string> reached;
  for (std::size_t i = 0; i < side_keys.size(); ++i) {
    desk.act(desk.press({Key::R, {}, 0}));
    const auto side = static_cast<std::size_t>(desk.session.view->side);
    REQUIRE(side < side_keys.size());
    reached.insert(std::string(side_keys[side]));
  }
  CHECK(reached == tabs);
  CHECK(desk.session.view->side == SidePanel::step);
}
