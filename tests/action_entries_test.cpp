// Finding what can be done by what is typed, and what the palette offers in a session.
#include "app/entries/action_entries.h"

#include <algorithm>
#include <set>

#include "app/base/word_search.h"
#include "app/panels/dialogs/action_palette.h"
#include "app/panels/dialogs/file_dialogs.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

namespace {

std::vector<ActionEntry> entries_of(const Session& session) {
  return palette_entries(session, read_action_sources(session));
}

const ActionEntry* entry_named(const std::vector<ActionEntry>& entries, const std::string& words) {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const ActionEntry& e) { return e.words == words; });
  return found == entries.end() ? nullptr : &*found;
}

std::string first_for(const std::vector<ActionEntry>& entries, const std::string& typed) {
  const auto found = find_entries(entries, typed, {});
  return found.empty() ? "nothing" : entries[found[0]].words;
}

std::variant<Action, std::string> read(const Session& session, const std::string& words,
                                       const std::string& typed) {
  const auto entries = entries_of(session);
  const ActionEntry* entry = entry_named(entries, words);
  INFO(words);
  REQUIRE(entry != nullptr);
  REQUIRE(std::holds_alternative<ActionPrompt>(entry->does));
  return std::get<ActionPrompt>(entry->does).read(session, typed);
}

template <class T>
T taken(const Session& session, const std::string& words, const std::string& typed) {
  const auto got = read(session, words, typed);
  INFO(words << " " << typed << ": " << (got.index() == 1 ? std::get<std::string>(got) : ""));
  REQUIRE(std::holds_alternative<Action>(got));
  REQUIRE(std::get<Action>(got).is<T>());
  return std::get<Action>(got).get<T>();
}

// The sentence of a refusal.
std::string refused(const Session& session, const std::string& words, const std::string& typed) {
  const auto got = read(session, words, typed);
  return got.index() == 1 ? std::get<std::string>(got) : "taken";
}

}  // namespace

TEST_CASE(
    "a line is found by words in any order, their beginnings, parts and letters, the better the higher") {
  const Searchable line{"Set epsilon to...", "Parameters", "Ctrl+E or F3"};
  const auto points = [&](std::string_view typed) { return fit(typed, line).value_or(-1); };
  CHECK(points("epsilon") > points("eps"));
  CHECK(points("eps") > points("silon"));
  CHECK(points("silon") > points("steps"));  // S of set, t of to: not in this order
  CHECK(points("seto") > 0);                 // se of set, to
  CHECK(points("silon") > points("seto"));
  CHECK(points("seto") > points("parameters"));
  CHECK(points("parameters") > 0);
  CHECK(points("EPS set") == points("set eps"));
  CHECK(points("eps banana") == -1);
  CHECK(points("tes") == -1);
  CHECK(points("  ") == 0);
  CHECK(points("ctrl+e") > points("epsilon"));
  CHECK(points("f3") > points("epsilon"));
  CHECK(points("ctrl") == -1);
}

TEST_CASE("a few letters find what is meant first") {
  Desk desk;
  desk.session.program->assets = KNIT_ASSETS_DIR;
  desk.open();
  const auto entries = entries_of(desk.session);
  CHECK(first_for(entries, "eps") == "Set epsilon \xCE\xB5 to...");
  CHECK(first_for(entries, "ex vase") == "Open the example vase");
  CHECK(first_for(entries, "vase") == "Open the example vase");
  CHECK(first_for(entries, "Ctrl+Z") == "Undo a change");
  CHECK(first_for(entries, "ctrl+shift+z") == "Redo it");
  CHECK(first_for(entries, "go row") == "Go to row...");
  CHECK(first_for(entries, "break when") == "Break when...");
  CHECK(first_for(entries, "timing geo") == "Timing: geodesic");
  CHECK(first_for(entries, "save mesh") == "Save the knit mesh...");
  CHECK(first_for(entries, "light theme") == "Use the light theme");
  CHECK(first_for(entries, "saddle") == "What is meant by: saddle");
  CHECK(first_for(entries, "quit") == "Quit");
  CHECK(first_for(entries, "xyzzy") == "nothing");
}

TEST_CASE("what was used lately comes first, and decides between equals") {
  Desk desk;
  desk.open();
  const auto entries = entries_of(desk.session);
  const auto found = find_entries(entries, "", {"Go to row...", "Zoom in"});
  REQUIRE(found.size() == entries.size());
  CHECK(entries[found[0]].words == "Go to row...");
  CHECK(entries[found[1]].words == "Zoom in");
  CHECK(entries[found[2]].words == entries[0].words);
}

TEST_CASE("no two entries are called alike, with or without a mesh, and those that are idle say why") {
  Desk desk;
  desk.session.program->assets = KNIT_ASSETS_DIR;
  for (const bool open : {false, true}) {
    if (open) desk.open();
    const auto entries = entries_of(desk.session);
    std::set<std::string> words;
    std::size_t idle = 0;
    for (const ActionEntry& entry : entries) {
      INFO(entry.words);
      CHECK(words.insert(entry.words).second);
      CHECK(!entry.group.empty());
      idle += entry.why_not.empty() ? 0 : 1;
      if (!entry.why_not.empty()) CHECK(entry.why_not.back() == '.');
    }
    CHECK(idle > (open ? 5U : 60U));
    for (const char* must :
         {"Open a mesh", "Quit", "The glossary", "Use the light theme", "Open the example torus"}) {
      INFO(must);
      REQUIRE(entry_named(entries, must) != nullptr);
      CHECK(entry_named(entries, must)->why_not.empty());
    }
  }
}

TEST_CASE("everything that is listed somewhere has its entry") {
  Desk desk;
  desk.session.program->assets = KNIT_ASSETS_DIR;
  desk.session.program->preferences.recent = {"/tmp/ball.obj", "example:vase", "/tmp/work.json"};
  desk.open();
  const auto entries = entries_of(desk.session);
  const auto has = [&](const std::string& words) {
    INFO(words);
    CHECK(entry_named(entries, words) != nullptr);
  };
  for (const CommandInfo& info : command_table()) {
    has(words_of(info));
    CHECK(entry_named(entries, words_of(info))->keys == keys_of(info));
  }
  for (const std::string& name : list_examples(desk.session.program->assets)) has("Open the example " + name);
  for (const ExportInfo* kind : exports_of_menu()) has("Save the " + std::string(kind->words) + "...");
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    const auto* choice = std::get_if<knit::Choice>(&info.kind);
    for (std::size_t i = 0; choice != nullptr && i < choice->names.size(); ++i)
      has(std::string(info.label) + ": " + std::string(choice->names[i]));
  }
  has("Open again: /tmp/ball.obj");
  CHECK(std::get<Action>(entry_named(entries, "Open again: /tmp/work.json")->does).is<OpenSession>());
  CHECK(entry_named(entries, "Open again: example:vase") == nullptr);
}

TEST_CASE("every example of a prompt can be typed as it stands") {
  Desk desk;
  desk.open();
  apply(desk.session, StartSweep{{{"epsilon", 0.1, 0.2, 2}, std::nullopt}});
  desk.session.view->gaze.picking = Picking::start;
  const auto entries = entries_of(desk.session);
  std::size_t prompts = 0;
  for (const ActionEntry& entry : entries) {
    const auto* prompt = std::get_if<ActionPrompt>(&entry.does);
    if (prompt == nullptr || entry.words == "Open file...") continue;
    ++prompts;
    INFO(entry.words << ": " << prompt->example);
    const bool possible = entry.why_not.empty() ||
                          entry.why_not.find("nothing reads it") != std::string::npos ||
                          entry.why_not.find("No lesson") != std::string::npos ||
                          entry.why_not.find("No pattern is being checked") != std::string::npos;
    CHECK(possible);
    const auto read = prompt->read(desk.session, prompt->example);
    INFO((read.index() == 1 ? std::get<std::string>(read) : ""));
    CHECK(std::holds_alternative<Action>(read));
  }
  CHECK(prompts > 25);
}

TEST_CASE("what is typed becomes the action, or is refused in one sentence") {
  Desk desk;
  desk.open();
  const Session& session = desk.session;
  CHECK(taken<SeekTo>(session, "Go to step...", "17").position == 17);
  const knit::Place row = taken<SeekPlace>(session, "Go to row...", "2").place;
  CHECK(row.row == 2);
  CHECK(taken<SeekPlace>(session, "Go to place...", "rows:2:3").place ==
        knit::Place{knit::Stage::rows, 2, 2});
  CHECK(taken<Tune>(session, "Set epsilon \xCE\xB5 to...", "0.125").parameters.epsilon() == 0.125);
  CHECK(taken<EditFromHere>(session, "Change a parameter from here on...", "epsilon = 0.125")
            .parameters.epsilon() == 0.125);
  CHECK(taken<SetBreaks>(session, "Break when...", "stall").conditions.size() == 1);
  CHECK(taken<Select>(session, "Select vertex...", "12").thing == knit::Element(knit::VertexElement{12}));
  CHECK(taken<SetScale>(session, "Set the size of words and lines to...", "150").scale == 1.5);
  const auto picture = taken<SavePicture>(session, "Save a picture of any size...", "my ball.png 640x480");
  CHECK(picture.path == "my ball.png");
  CHECK(picture.width == 640);
  CHECK(taken<SavePicture>(session, "Save a picture of any size...", "ball.png").width == 1600);
  for (const auto& [words, typed] : std::vector<std::pair<std::string, std::string>>{
           {"Go to step...", "soon"},
           {"Go to step...", "99999999"},
           {"Go to row...", "0"},
           {"Go to row...", "9999"},
           {"Go to place...", "nowhere:1"},
           {"Go to place...", "rows:2:0"},
           {"Set epsilon \xCE\xB5 to...", "wide"},
           {"Set epsilon \xCE\xB5 to...", "-1"},
           {"Set start vertex to...", "99999999"},
           {"Change a parameter from here on...", "epsilonn = 3"},
           {"Break when...", "perhaps"},
           {"Select vertex...", "99999999"},
           {"Select stitch or face...", "stitch:9999:1"},
           {"Why is it there...", "somehow"},
           {"Sweep a parameter...", "epsilon=1"},
           {"Set the speed to...", "0"},
           {"Set the size of words and lines to...", "1000"},
           {"Set the width of the left panel to...", "-3"},
           {"Set the needle to...", "thick"},
           {"Save a picture of any size...", "ball.jpg"},
           {"Save a picture of any size...", "ball.png 9x9"},
           {"Open file...", "no/such/file.obj"}}) {
    const std::string sentence = refused(session, words, typed);
    INFO(words << " " << typed << ": " << sentence);
    CHECK(test_support::is_one_sentence(sentence));
    CHECK(sentence.rfind("--", 0) != 0);
  }
}

TEST_CASE("looking from a side turns the camera there, the shorter way") {
  Desk desk;
  desk.open();
  const auto entries = entries_of(desk.session);
  desk.session.view->gaze.camera.yaw = 3.0;
  const auto turn = [&](const char* words) {
    const auto now = entries_of(desk.session);
    return std::get<Action>(entry_named(now, words)->does).get<Orbit>();
  };
  CHECK(std::abs(turn("Look from the back").yaw - 0.1416) < 0.001);
  apply(desk.session, turn("Look from the right"));
  const glm::dvec3 from = desk.session.view->gaze.camera.eye() - desk.session.view->gaze.camera.target;
  CHECK(from.x > 0.99 * desk.session.view->gaze.camera.distance);
  CHECK(std::abs(from.y) < 0.01);
}

TEST_CASE("lessons are listed by their titles, and files that are none are left out") {
  const test_support::Folder folder;
  std::filesystem::create_directory(folder.path() / "lessons");
  test_support::write_text(folder.path() / "lessons/first.json",
                           R"({"knit-mesh-lesson": 1, "key": "first", "title": "What it does", "about": "A",
                               "pages": [{"title": "One", "text": "First."}]})");
  test_support::write_text(folder.path() / "lessons/broken.json", "{\"title\": ");
  test_support::write_text(folder.path() / "lessons/untitled.json", "[1, 2]");
  test_support::write_text(folder.path() / "lessons/notes.txt", "nothing");
  Session session;
  session.program->assets = folder.path();
  const ActionSources sources = read_action_sources(session);
  REQUIRE(sources.lessons.size() == 1);
  CHECK(sources.lessons[0].key == "first");
  const auto entries = palette_entries(session, sources);
  const ActionEntry* lesson = entry_named(entries, "Lesson: What it does");
  REQUIRE(lesson != nullptr);
  CHECK(std::get<Action>(lesson->does).get<StartLesson>().key == "first");
}
