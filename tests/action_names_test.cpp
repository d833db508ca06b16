// Every action has a name, an entry in the palette, and a button, a line of a menu or a place to point at.
#include "app/entries/action_names.h"
#include "app/panels/pattern/pattern_parts.h"

#include <set>

#include "app/files/figures.h"
#include "app/panels/dialogs/action_palette.h"
#include "app/panels/dialogs/file_dialogs.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/model/stitch_size.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

namespace {

class Controls {
 public:
  void note(const Desk& desk) {
    for (const auto& [name, box] : desk.ui.controls) names_.insert(name);
  }
  [[nodiscard]] bool have(std::string_view name) const { return names_.count(std::string(name)) == 1; }

 private:
  std::set<std::string> names_;
};

// Menus inside menus, a lesson's pages, a verdict to guess, an animation in the making.
template <class Look>
void look_at_learning(Desk& desk, const Look& look) {
  desk.session.program->preferences.recent = {"/tmp/work.json"};
  for (const auto& [menu, inner] :
       {std::pair{"view", "Theme"}, std::pair{"view", "Size"}, std::pair{"view", "Panels"},
        std::pair{"file", "Open recent"}, std::pair{"learn", ""}}) {
    desk.click("menu/" + std::string(menu));
    look(desk);
    if (*inner != '\0') desk.click("menu/" + std::string(inner));
    look(desk);
    for (int i = 0; i < 2; ++i) desk.press({Key::Escape, {}, 0});
    desk.settle();
  }
  desk.session.jobs->animation = std::make_shared<const AnimationRun>();
  look(desk);
  desk.session.jobs->animation.reset();
  apply(desk.session, StartLesson{"increases-and-decreases"});  // has questions for a number
  desk.layout = layout_of(1600, 1600, 1, layout_wish(desk.session));
  for (int page = 0; page < 12; ++page) {
    look(desk);
    apply(desk.session, AnswerLesson{"skip"});
    apply(desk.session, TurnLesson{1});
  }
  apply(desk.session, LeaveLesson{});
  apply(desk.session, SetPredicting{true});
  desk.layout = layout_of(1600, 1600, 1, layout_wish(desk.session));
  apply(desk.session, SeekPlace{{knit::Stage::rows, 3, 3}});
  look(desk);
}

// With everything there is to see once: all sides, lists, menus and dialogs.
Controls all_controls() {
  Controls controls;
  const auto look = [&](Desk& desk) {
    desk.settle();
    controls.note(desk);
  };
  {
    Desk desk;
    desk.session.program->assets = KNIT_ASSETS_DIR;
    look(desk);  // nothing open
  }
  for (int side = 0; side < static_cast<int>(side_keys.size()); ++side) {
    Desk desk(1600, 1600);
    desk.open();
    desk.session.view->side = static_cast<SidePanel>(side);
    look(desk);
    apply(desk.session, PinRun{});
    look(desk);
  }
  {
    Desk desk(1600, 1600);
    desk.open();
    apply(desk.session, ToLast{});
    apply(desk.session, SetLayer{Layer::yarn, true});
    look(desk);  // as yarn
  }
  Desk desk(1600, 1600);
  desk.session.program->assets = KNIT_ASSETS_DIR;
  desk.open();
  apply(desk.session, SetBreaks{{knit::BreakCondition{}}});
  apply(desk.session, SeekPlace{{knit::Stage::rows, 3, 3}});
  for (int list = 0; list < static_cast<int>(list_keys.size()); ++list) {
    desk.session.view->list = static_cast<RunList>(list);
    look(desk);
  }
  knit::Parameters changed = desk.session.document->timeline.parameters();
  knit::give_epsilon(changed, changed.epsilon() * 1.1);
  apply(desk.session, EditFromHere{changed});
  apply(desk.session, Select{knit::VertexElement{3}});
  desk.session.outbox->notices.push_back({});
  desk.session.document->place_note = "Row 3 has 8 stitches.";
  desk.session.program->rescued = Rescued{"/nowhere/session.json", "thesis-sphere, row 14"};
  desk.session.jobs->run.long_step.emplace();
  desk.session.jobs->run.long_step->seconds = 1.0;
  look(desk);
  for (const char* menu : {"file", "edit", "presets", "go", "why", "view", "help"}) {
    desk.click("menu/" + std::string(menu));
    look(desk);
    desk.press({Key::Escape, {}, 0});
    desk.settle();
  }
  desk.session.jobs->repair_offer =
      RepairOffer{{"", "ball.obj", {}}, "It has a hole.", std::make_shared<knit::RepairPlan>()};
  look(desk);
  desk.session.jobs->repair_offer.reset();
  desk.session.document->before_repair = std::make_shared<const Session>();
  look(desk);
  desk.session.view->side = SidePanel::pattern;
  desk.ui.own<PatternFields>().open = true;
  look(desk);
  desk.session.view->side = SidePanel::sweep;
  desk.session.jobs->beside = true;
  // So many that it is still at it when it is looked at.
  apply(desk.session, StartSweep{{{"epsilon", 0.1, 0.2, 10000}, std::nullopt}});
  look(desk);
  apply(desk.session, CancelSweep{});
  desk.session.view->dialogs.open_dialog_open = true;
  look(desk);
  desk.session.view->dialogs.open_dialog_open = false;
  desk.settle();
  desk.ui.own<SaveDialog>().wanted = find_export("map");
  look(desk);
  Desk checker(1600, 1600);
  apply(checker.session, SetCheckedText{"CO 6 sts.\n", true});
  apply(checker.session, SetCheckedText{"CO 6 sts.\nRnd 1: Knit. (7 sts)\n", true});
  checker.layout = layout_of(1600, 1600, 1, layout_wish(checker.session));
  look(checker);
  Desk learner(1600, 1600);
  learner.session.program->assets = KNIT_ASSETS_DIR;
  learner.open();
  look_at_learning(learner, look);
  return controls;
}

void note_entries(const Session& session, std::set<std::size_t>& reached) {
  for (const ActionEntry& entry : palette_entries(session, read_action_sources(session))) {
    if (const auto* action = std::get_if<Action>(&entry.does)) {
      reached.insert(action->index());
    } else if (std::holds_alternative<AskToSave>(entry.does)) {
      reached.insert(Action(Export{}).index());
    } else if (session.document) {
      const auto& prompt = std::get<ActionPrompt>(entry.does);
      const std::string file = std::string(KNIT_ASSETS_DIR) + "/torus/mesh.obj";
      const auto read = prompt.read(session, entry.words == "Open file..." ? file : prompt.example);
      if (const auto* made = std::get_if<Action>(&read)) reached.insert(made->index());
    }
  }
}

// Of the actions that some entry of the palette makes: in a session that has something of everything, and without.
std::set<std::size_t> in_the_palette() {
  std::set<std::size_t> reached;
  Desk desk;
  desk.session.program->assets = KNIT_ASSETS_DIR;
  note_entries(desk.session, reached);
  desk.open();
  desk.session.program->preferences.recent = {"/tmp/work.json"};
  desk.session.view->gaze.picking = Picking::start;
  note_entries(desk.session, reached);
  apply(desk.session, SetCheckedText{"CO 6 sts.", true});
  apply(desk.session, SetCheckedText{"CO 9 sts.", true});
  note_entries(desk.session, reached);
  apply(desk.session, ShowChecker{false});
  apply(desk.session, PinRun{});
  const test_support::Folder folder;
  std::filesystem::create_directory(folder.path() / "lessons");
  test_support::write_text(folder.path() / "lessons/first.json", "{\"title\": \"First\"}");
  desk.session.program->assets = folder.path();
  note_entries(desk.session, reached);
  return reached;
}

}  // namespace

TEST_CASE("every action has a name of its own, and the machine's own say why they are") {
  std::set<std::string_view> words;
  std::size_t machines = 0;
  for (const ActionName& name : action_names()) {
    INFO(name.words);
    CHECK(name.words.size() > 3);
    CHECK(words.insert(name.words).second);
    CHECK(!name.where.empty());
    if (name.reach != Reach::control) CHECK(name.where.back() == '.');
    machines += name.reach != Reach::machine ? 0 : 1;
  }
  CHECK(machines == 7);
  CHECK_FALSE(name_of(PassTime{}).reach != Reach::machine);
  CHECK(name_of(Quit{}).words == "Quit");
  CHECK(name_of(PinRun{}).words == "Pin this run");
}

TEST_CASE("every action of a person's has a button, a line of a menu or a place to point at") {
  const Controls controls = all_controls();
  std::size_t found = 0;
  for (const ActionName& name : action_names()) {
    if (name.reach != Reach::control) continue;
    INFO(name.words << ": " << name.where);
    const bool there = controls.have(name.where);
    CHECK(there);
    found += there ? 1 : 0;
  }
  CHECK(found > 80);
}

TEST_CASE("every action of a person's has an entry in the palette") {
  const std::set<std::size_t> reached = in_the_palette();
  for (std::size_t i = 0; i < action_names().size(); ++i) {
    INFO(action_names()[i].words);
    CHECK((reached.count(i) == 1) == (action_names()[i].reach != Reach::machine));
  }
}
