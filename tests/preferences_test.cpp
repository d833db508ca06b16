// Preferences: what is remembered, where, and what becomes of a file that is wrong.
#include "app/actions/preferences_keeper.h"
#include "app/files/preferences_file.h"

#include <algorithm>
#include <map>

#include "app/actions/apply_parts.h"
#include "app/session/outbox.h"
#include "app/session/preferences.h"
#include "app/session/program.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

namespace {

using namespace app;
using namespace test_support;

Preferences all_changed() {
  Preferences preferences;
  preferences.theme = ThemeKind::light;
  preferences.scale = 1.25;
  preferences.motion = false;
  preferences.panels = {true, false, true};
  preferences.splits = {310.0, 0.0, 150.0};
  preferences.row_columns = {true, false, true, false, true};
  preferences.recent = {"/tmp/a \"b\".obj", "example:vase"};
  preferences.lessons["what-it-does"] = {3, 4};
  preferences.longest_streak = 7;
  return preferences;
}

std::string fault_of(const std::string& text) {
  const auto result = read_preferences(text);
  REQUIRE(std::holds_alternative<std::string>(result));
  return std::get<std::string>(result);
}

std::string with_field(const std::string& field) { return "{\"knit-mesh-preferences\": 1, " + field + "}"; }

Environment environment(const std::map<std::string, std::string>& values) {
  return [values](const char* name) {
    const auto found = values.find(name);
    return found != values.end() ? found->second : "";
  };
}

// What a start would find there.
Preferences in_file(const std::filesystem::path& file) {
  const auto result = read_preferences(read_text(file));
  REQUIRE(std::holds_alternative<Preferences>(result));
  return std::get<Preferences>(result);
}

}  // namespace

TEST_CASE("preferences written are read back the same") {
  for (const Preferences& preferences : {Preferences{}, all_changed()}) {
    const auto result = read_preferences(preferences_text(preferences));
    REQUIRE(std::holds_alternative<Preferences>(result));
    CHECK(std::get<Preferences>(result) == preferences);
  }
}

TEST_CASE("preferences that lack a field have it as at first, and fields of others are let be") {
  const auto result =
      read_preferences(with_field("\"theme\": \"light\", \"panels\": {\"side\": false}, \"x\": 1"));
  REQUIRE(std::holds_alternative<Preferences>(result));
  Preferences expected;
  expected.theme = ThemeKind::light;
  expected.panels[static_cast<std::size_t>(Panel::side)] = false;
  CHECK(std::get<Preferences>(result) == expected);
}

TEST_CASE("a wrong field of the preferences is named") {
  CHECK(contains(fault_of("{"), "JSON"));
  CHECK(contains(fault_of("[]"), "object"));
  CHECK(contains(fault_of("{}"), "knit-mesh-preferences"));
  CHECK(contains(fault_of("{\"knit-mesh-preferences\": 2}"), "newer"));
  CHECK(contains(fault_of(with_field("\"theme\": \"pink\"")), "\"theme\" must be one of dark, light"));
  CHECK(contains(fault_of(with_field("\"scale\": 7")), "\"scale\" must be a number from 0.75 to 2.5"));
  CHECK(contains(fault_of(with_field("\"motion\": 1")), "\"motion\""));
  CHECK(contains(fault_of(with_field("\"panels\": []")), "\"panels\""));
  CHECK(contains(fault_of(with_field("\"panels\": {\"side\": 2}")), "\"panels.side\""));
  CHECK(contains(fault_of(with_field("\"splits\": {\"left\": -1}")), "\"splits.left\""));
  CHECK(contains(fault_of(with_field("\"recent\": [3]")), "\"recent\""));
  CHECK(contains(fault_of(with_field("\"lessons\": {\"a\": {\"of\": 2, \"right\": 3}}")),
                 "\"lessons.a.right\""));
  CHECK(contains(fault_of(with_field("\"lessons\": 3")), "\"lessons\""));
  CHECK(contains(fault_of(with_field("\"longest-streak\": -1")), "\"longest-streak\""));
}

TEST_CASE("preferences lie in the usual place of each system") {
  const auto home = environment({{"HOME", "/home/ann"}});
  CHECK(preferences_file(Platform::xdg, home) == "/home/ann/.config/knit-mesh/preferences.json");
  CHECK(preferences_file(Platform::mac, home) ==
        "/home/ann/Library/Application Support/knit-mesh/preferences.json");
  const auto xdg = environment({{"HOME", "/home/ann"}, {"XDG_CONFIG_HOME", "/conf"}});
  CHECK(preferences_file(Platform::xdg, xdg) == "/conf/knit-mesh/preferences.json");
  const auto relative = environment({{"HOME", "/home/ann"}, {"XDG_CONFIG_HOME", "conf"}});
  CHECK(preferences_file(Platform::xdg, relative) == "/home/ann/.config/knit-mesh/preferences.json");
  CHECK(preferences_file(Platform::windows, environment({{"APPDATA", "/data"}})) ==
        "/data/knit-mesh/preferences.json");
  CHECK_FALSE(preferences_file(Platform::xdg, environment({})));
}

TEST_CASE("the keeper writes what has changed, not more often than every few seconds, and at the end") {
  const Folder folder;
  const auto file = folder.path() / "deep" / "preferences.json";
  Session session;
  PreferencesKeeper keeper(session, file);
  keeper.pass(session, 100.0);
  CHECK_FALSE(std::filesystem::exists(file));  // nothing has changed
  apply(session, SetTheme{ThemeKind::light});
  keeper.pass(session, 0.5);
  CHECK(in_file(file).theme == ThemeKind::light);
  apply(session, SetScale{1.5});
  keeper.pass(session, 0.5);
  CHECK(in_file(file).scale == 1.0);
  keeper.pass(session, PreferencesKeeper::seconds_between);
  CHECK(in_file(file).scale == 1.5);
  apply(session, ShowPanel{Panel::side, false});
  keeper.end(session);
  CHECK(in_file(file).panels == std::array{true, false, true});
  const auto time = std::filesystem::last_write_time(file);
  keeper.end(session);
  CHECK(std::filesystem::last_write_time(file) == time);

  Session next;
  const PreferencesKeeper again(next, file);
  CHECK(next.program->preferences == session.program->preferences);
}

TEST_CASE("what the command line says counts for one start, unless it is changed by hand") {
  const Folder folder;
  const auto file = folder.path() / "preferences.json";
  write_text(file, preferences_text(all_changed()));
  Session session;
  session.program->preferences.theme = ThemeKind::dark;  // as --theme dark has left it
  const decltype(Preferences::row_columns) given{false, false, true, true, false};
  PreferencesKeeper keeper(session, file, {ThemeKind::dark, 2.0, given});
  CHECK(session.program->preferences.row_columns == given);
  CHECK(session.program->preferences.theme == ThemeKind::dark);
  CHECK(session.program->preferences.scale == 2.0);
  CHECK_FALSE(session.program->preferences.motion);
  apply(session, SetMotion{true});
  keeper.pass(session, 10.0);
  CHECK(in_file(file).theme == ThemeKind::light);
  CHECK(in_file(file).scale == 1.25);
  CHECK(in_file(file).row_columns == all_changed().row_columns);
  CHECK(in_file(file).motion);
  apply(session, SetTheme{ThemeKind::light});
  keeper.pass(session, 0.0);
  apply(session, SetTheme{ThemeKind::dark});  // by hand, though the same as given
  keeper.end(session);
  CHECK(in_file(file).theme == ThemeKind::dark);
  CHECK(in_file(file).scale == 1.25);
}

TEST_CASE(
    "a wrong preferences file is told of once, let be, and kept aside when there is something to write") {
  const Folder folder;
  const auto file = folder.path() / "preferences.json";
  write_text(file, with_field("\"scale\": \"big\""));
  const std::string before = read_text(file);
  Session session;
  PreferencesKeeper keeper(session, file);
  REQUIRE(session.outbox->notices.size() == 1);
  const Notice& notice = session.outbox->notices.front();
  CHECK(notice.kind == Notice::Kind::warning);
  CHECK(is_one_sentence(notice.text));
  CHECK(contains(notice.text, file.string()));
  CHECK(contains(notice.text, "\"scale\""));
  CHECK(session.program->preferences == Preferences{});
  keeper.pass(session, 100.0);
  keeper.end(session);
  CHECK(read_text(file) == before);
  CHECK(folder.files() == 1);
  apply(session, SetScale{1.25});
  keeper.end(session);
  CHECK(read_text(folder.path() / "preferences.json.old") == before);
  CHECK(in_file(file).scale == 1.25);
  CHECK(folder.files() == 2);
  CHECK(session.outbox->notices.size() == 1);
}

TEST_CASE("preferences that cannot be written are told of once") {
  const Folder folder;
  write_text(folder.path() / "knit-mesh", "a file where the folder should be");
  Session session;
  PreferencesKeeper keeper(session, folder.path() / "knit-mesh" / "preferences.json");
  apply(session, SetScale{1.25});
  keeper.pass(session, 10.0);
  apply(session, SetScale{1.5});
  keeper.pass(session, 10.0);
  REQUIRE(session.outbox->notices.size() == 1);
  CHECK(is_one_sentence(session.outbox->notices.front().text));
}

TEST_CASE("without a place for preferences nothing is read or written") {
  Session session;
  apply(session, SetTheme{ThemeKind::light});
  PreferencesKeeper keeper(session, std::nullopt);
  keeper.pass(session, 100.0);
  keeper.end(session);
  CHECK(session.program->preferences.theme == ThemeKind::light);
  CHECK(session.outbox->notices.empty());
}

TEST_CASE("what was opened at the start comes before what the file remembers, an example does not count") {
  const Folder folder;
  const auto file = folder.path() / "preferences.json";
  write_text(file, preferences_text(all_changed()));
  Session session;
  session.program->preferences.recent = {"/tmp/new.obj", "example:thesis-sphere"};
  const PreferencesKeeper keeper(session, file);
  CHECK(session.program->preferences.recent ==
        std::vector<std::string>{"/tmp/new.obj", "/tmp/a \"b\".obj", "example:vase"});
}

TEST_CASE("what is opened comes first among the recent ones, each once, at most ten") {
  Preferences preferences;
  for (int i = 0; i < 12; ++i) note_recent(preferences, "/tmp/" + std::to_string(i) + ".obj");
  note_recent(preferences, "/tmp/5.obj");
  CHECK(preferences.recent.size() == most_recent);
  CHECK(preferences.recent.front() == "/tmp/5.obj");
  CHECK(preferences.recent[1] == "/tmp/11.obj");
  CHECK(std::count(preferences.recent.begin(), preferences.recent.end(), "/tmp/5.obj") == 1);

  Session session = example_session("thesis-sphere");
  CHECK(session.program->preferences.recent == std::vector<std::string>{"example:thesis-sphere"});
  CHECK(opening_of_recent("example:thesis-sphere").get<OpenExample>().name == "thesis-sphere");
  CHECK(opening_of_recent("/tmp/a.obj").get<OpenFile>().path == "/tmp/a.obj");
  CHECK(opening_of_recent("/tmp/a.json").is<OpenSession>());
  CHECK(words_of_recent("/tmp/a.obj").what == "a.obj");
  CHECK(words_of_recent("/tmp/a.obj").where == "/tmp");
  apply(session, ForgetRecent{});
  CHECK(session.program->preferences.recent.empty());
}

TEST_CASE("a session is remembered as itself, not as its mesh, when it is saved and when it is opened") {
  const Folder folder;
  const auto path = folder.path() / "s.json";
  Session session = example_session("thesis-sphere");
  apply(session, Export{"session", path});
  const std::vector<std::string> both{path.string(), "example:thesis-sphere"};
  CHECK(session.program->preferences.recent == both);
  apply(session, OpenSession{path});
  CHECK(session.program->preferences.recent == both);
}

TEST_CASE("a file that has gone says so in one sentence when it is chosen, and is not offered again") {
  const Folder folder;
  for (const char* name : {"gone.obj", "gone.json"}) {
    Session session = example_session("thesis-sphere");
    const std::string gone = recent_name(folder.path() / name);
    note_recent(session.program->preferences, gone);
    session.outbox->notices.clear();
    app::apply(session, opening_of_recent(gone));
    REQUIRE(session.outbox->notices.size() == 1);
    CHECK(is_one_sentence(session.outbox->notices.front().text));
    CHECK(session.program->preferences.recent == std::vector<std::string>{"example:thesis-sphere"});
  }
  // One that is there and wrong stays: it may be repaired.
  Session session = example_session("thesis-sphere");
  write_text(folder.path() / "bad.obj", "v 1 2\n");
  const std::string bad = recent_name(folder.path() / "bad.obj");
  note_recent(session.program->preferences, bad);
  app::apply(session, opening_of_recent(bad));
  CHECK(session.program->preferences.recent.front() == bad);
}

TEST_CASE("all panels go and come back at once, and resetting the layout brings everything back") {
  Session session;
  apply(session, ShowPanel{every_panel, false});
  CHECK(session.program->preferences.panels == std::array{false, false, false});
  apply(session, SetSplit{Split::left, 300.0});
  apply(session, SetSplit{Split::left, -5.0});  // is none
  CHECK(session.program->preferences.splits[0] == 300.0);
  apply(session, ResetLayout{});
  CHECK(session.program->preferences == Preferences{});
  apply(session, ShowPanel{every_panel, false});
  apply(session, ShowPanel{every_panel, true});
  CHECK(session.program->preferences == Preferences{});
}
