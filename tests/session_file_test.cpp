// Sessions as files: what is saved is shown again, and what cannot be read is said in one sentence.
#include "app/files/session_file.h"
#include "app/actions/background_work.h"

#include "app/describe/describe.h"
#include "app/files/session_json.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"
#include "tests/support/catch.h"
#include "tests/support/open_session.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;
using Json = nlohmann::ordered_json;

namespace {

knit::Parameters with(knit::Parameters parameters, const char* key, const std::string& value) {
  INFO(key);
  REQUIRE_FALSE(knit::set_value(*knit::find_parameter(key), parameters, value));
  return parameters;
}

Session empty_session() {
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  return session;
}

// With something of everything that a session remembers.
Session rich_session() {
  Session session = example_session("sphere");
  apply(session, Tune{with(session.document->timeline.parameters(), "epsilon", "0.061")});
  apply(session, SeekPlace{{knit::Stage::rows, 12, 5}});
  apply(session, EditFromHere{with(session.document->timeline.parameters(), "close", "thesis")});
  apply(session, SeekPlace{{knit::Stage::rows, 14, 7}});
  apply(session, Orbit{0.4, -0.1});
  apply(session, Zoom{0.7, {0.2, 0.1}});
  apply(session, SetLayer{Layer::wire, true});
  apply(session, SetLayer{Layer::band, false});
  apply(session, ShowSide{SidePanel::pattern});
  apply(session, ShowCentre{CentrePanel::chart});
  apply(session, SetSpeed{123.5});
  apply(session, KnitAlong{7});
  knit::PatternOptions options;
  options.title = "Ball \"one\" \xC3\xA9";
  options.needle_mm = 3.25;
  options.stars = true;
  options.form = knit::PatternForm::short_form;
  apply(session, SetPatternOptions{options});
  session.document->travel.loop = Stretch{10, 40};
  session.view->slow_motion = true;
  return session;
}

std::string saved_text(const Session& session, const std::filesystem::path& path) {
  REQUIRE_FALSE(save_session(session, path));
  return read_text(path);
}

bool same_view(const Scene& a, const Scene& b) {
  return a.view.view == b.view.view && a.view.projection == b.view.projection && a.view.eye == b.view.eye;
}

// Writes a session whose JSON was changed by a test, and gives what opening it says.
std::string error_of(const Folder& folder, const std::string& text, Session& session) {
  const auto path = folder.path() / "changed.json";
  write_text(path, text);
  return open_session(session, path).value_or("");
}

}  // namespace

TEST_CASE("a session opened again is the same: bytes, camera, position, state and scene") {
  const Folder folder;
  const Session session = rich_session();
  const std::string text = saved_text(session, folder.path() / "a.json");
  CHECK(text.rfind("{\n  \"knit-mesh-session\": 1,", 0) == 0);
  CHECK(text.size() < 8000);

  Session opened = empty_session();
  REQUIRE(open_session(opened, folder.path() / "a.json") == std::nullopt);
  CHECK(opened.outbox->notices.empty());
  CHECK(saved_text(opened, folder.path() / "b.json") == text);
  CHECK(opened.view->gaze.camera == session.view->gaze.camera);
  CHECK(opened.view->layers == session.view->layers);
  CHECK(opened.document->timeline.position() == session.document->timeline.position());
  CHECK(knit::hash_of(opened.document->timeline.state()) ==
        knit::hash_of(session.document->timeline.state()));
  CHECK(knobs_of(opened.document->timeline) == knobs_of(session.document->timeline));
  CHECK(opened.view->gaze.knit_along == 7);
  CHECK(opened.view->pattern.title == session.view->pattern.title);
  CHECK(opened.document->travel.loop == session.document->travel.loop);
  CHECK(opened.document->defaults == session.document->defaults);
  opened.view->aspect = session.view->aspect;
  const Scene before = Describer().describe(session);
  const Scene after = Describer().describe(opened);
  CHECK(same_view(before, after));
  opened.document->timeline.extend_to_end();
  Session whole = session;
  whole.document->timeline.extend_to_end();
  CHECK(knit::hash_of(opened.document->timeline.furthest()) ==
        knit::hash_of(whole.document->timeline.furthest()));
}

TEST_CASE("the start of a run, its end and the middle are come back to") {
  const Folder folder;
  for (const knit::Place& place :
       {knit::Place{}, knit::Place{knit::Stage::timing, 0, 0}, knit::Place{knit::Stage::pattern, 9, 3},
        knit::Place{knit::Stage::done, 0, 0}}) {
    Session session = example_session("sphere");
    if (place != knit::Place{}) apply(session, SeekPlace{place});
    const std::string text = saved_text(session, folder.path() / "a.json");
    Session opened = empty_session();
    REQUIRE_FALSE(open_session(opened, folder.path() / "a.json"));
    CHECK(opened.document->timeline.position() == session.document->timeline.position());
    CHECK(saved_text(opened, folder.path() / "a.json") == text);
  }
}

TEST_CASE("a mesh below the session's folder is named from there, another by its whole path") {
  const Folder folder;
  std::filesystem::create_directories(folder.path() / "one" / "meshes");
  const auto mesh = std::filesystem::path(KNIT_ASSETS_DIR) / "sphere" / "mesh.obj";
  std::filesystem::copy_file(mesh, folder.path() / "one" / "meshes" / "ball.obj");
  Session session = empty_session();
  apply(session, OpenFile{folder.path() / "one" / "meshes" / "ball.obj"});
  REQUIRE(session.document);
  const std::string text = saved_text(session, folder.path() / "one" / "s.json");
  CHECK(Json::parse(text)["source"]["file"] == "meshes/ball.obj");
  CHECK(Json::parse(saved_text(session, folder.path() / "far.json"))["source"]["file"] ==
        "one/meshes/ball.obj");
  std::filesystem::create_directory(folder.path() / "two");
  CHECK(Json::parse(saved_text(session, folder.path() / "two" / "s.json"))["source"]["file"] ==
        (folder.path() / "one" / "meshes" / "ball.obj").string());

  SECTION("moved together, it opens") {
    std::filesystem::rename(folder.path() / "one", folder.path() / "three");
    Session opened = empty_session();
    CHECK(open_session(opened, folder.path() / "three" / "s.json") == std::nullopt);
    CHECK(opened.outbox->notices.empty());
    CHECK(saved_text(opened, folder.path() / "three" / "t.json") == text);
  }
  SECTION("without its mesh it says where it looked") {
    std::filesystem::remove(folder.path() / "one" / "meshes" / "ball.obj");
    Session opened = empty_session();
    const auto error = open_session(opened, folder.path() / "one" / "s.json");
    REQUIRE(error);
    CHECK(contains(*error, (folder.path() / "one" / "meshes" / "ball.obj").string()));
    CHECK(is_one_sentence(*error));
    CHECK_FALSE(opened.document);
  }
  SECTION("a mesh that has changed is a warning") {
    write_text(folder.path() / "one" / "meshes" / "ball.obj",
               "# other\n" + read_text(std::filesystem::path(KNIT_ASSETS_DIR) / "egg" / "mesh.obj"));
    Session opened = empty_session();
    CHECK(open_session(opened, folder.path() / "one" / "s.json") == std::nullopt);
    REQUIRE(opened.document);
    REQUIRE_FALSE(opened.outbox->notices.empty());
    CHECK(contains(opened.outbox->notices.back().text, "another mesh"));
    CHECK(opened.outbox->notices.back().kind == Notice::Kind::warning);
  }
}

TEST_CASE("what is wrong with a session file is one sentence, and the session stays as it was") {
  const Folder folder;
  const std::string good = saved_text(rich_session(), folder.path() / "good.json");
  Session session = example_session("egg");
  apply(session, SeekTo{100});
  const std::uint64_t before = knit::hash_of(session.document->timeline.state());
  struct Case {
    std::string pointer, value, says;
  };
  const std::vector<Case> cases{
      {"/knit-mesh-session", "2", "version 2"},
      {"/knit-mesh-session", "\"1\"", "version"},
      {"/source", "{}", "source.file"},
      {"/source", "{\"example\": \"no-such\"}", "no-such"},
      {"/source", "[]", "source"},
      {"/source/example", "5", "source.example"},
      {"/parameters/bogus", "1", "bogus"},
      {"/parameters/epsilon", "\"wide\"", "parameters.epsilon"},
      {"/parameters/epsilon", "null", "parameters.epsilon"},
      {"/parameters/start", "99999999", "--start"},
      {"/edits", "{}", "edits"},
      {"/edits/0/at/stage", "\"weaving\"", "edits[0].at.stage"},
      {"/edits/0/at/row", "-1", "edits[0].at.row"},
      {"/edits/0/at/row", "1e99", "edits[0].at.row"},
      {"/edits/0/at/row", "99999999999999999999", "edits[0].at.row"},
      {"/edits/0/parameters/weld", "\"on\"", "weld"},
      {"/edits/0/parameters/rows", "\"contours\"", "rows"},
      {"/edits/1", "{\"at\": {\"stage\": \"timing\", \"row\": 0, \"item\": 0}, \"parameters\": {}}",
       "edits[1].at"},
      {"/at", "\"middle\"", "at"},
      {"/camera/distance", "0", "camera.distance"},
      {"/camera/target", "[1, 2]", "camera.target"},
      {"/camera/yaw", "\"left\"", "camera.yaw"},
      {"/layers/wire", "1", "layers.wire"},
      {"/side", "\"inside\"", "side"},
      {"/centre", "3", "centre"},
      {"/playback/steps-per-second", "0", "playback.steps-per-second"},
      {"/playback/loop/end", "3", "playback.loop.end"},
      {"/breaks", "[1]", "breaks[0]"},
      {"/pinned", "{}", "pinned.parameters"},
      {"/knit-along/round", "0", "knit-along.round"},
      {"/pattern/needle-mm", "900", "pattern.needle-mm"},
      {"/pattern/stars", "\"yes\"", "pattern.stars"},
      {"/pattern/form", "\"brief\"", "pattern.form"},
  };
  for (const Case& c : cases) {
    CAPTURE(c.pointer, c.value);
    Json json = Json::parse(good);
    json[Json::json_pointer(c.pointer)] = Json::parse(c.value);
    const std::string error = error_of(folder, json.dump(), session);
    CAPTURE(error);
    CHECK(is_one_sentence(error));
    CHECK(contains(error, c.says));
    CHECK(contains(error, "changed.json"));
  }
  {
    // Found by fuzzing: a name may hold anything, and the sentence about it is one line all the same.
    Json json = Json::parse(good);
    json["parameters"]["two\nlines\x1b[31m" + std::string(200, 'x')] = 1;
    const std::string error = error_of(folder, json.dump(), session);
    CAPTURE(error);
    CHECK(is_one_sentence(error));
    CHECK(contains(error, "\"parameters.two?lines?[31mxxx"));
    CHECK(error.find('\x1b') == std::string::npos);
  }
  const Json whole = Json::parse(good);
  for (const auto& [key, value] : whole.items()) {
    if (key == "positions" || key == "yarn") continue;  // younger than the version
    CAPTURE(key);
    Json json = Json::parse(good);
    json.erase(key);
    const std::string error = error_of(folder, json.dump(), session);
    CAPTURE(error);
    CHECK(is_one_sentence(error));
    CHECK(contains(error, key));
  }
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[1]"), std::string("v 0 0 0\n"), std::string("null"),
        std::string(200000, '['), good.substr(0, good.size() / 2), "{\"knit-mesh-session\": 1e999}" + good}) {
    const std::string error = error_of(folder, text, session);
    CAPTURE(error);
    CHECK(is_one_sentence(error));
  }
  CHECK(knit::hash_of(session.document->timeline.state()) == before);
  CHECK(session.document->source.example == "egg");
  CHECK(session.outbox->notices.empty());
}

TEST_CASE("files that cannot be sessions: none, a folder, too large") {
  const Folder folder;
  Session session = empty_session();
  for (const std::filesystem::path& path : {folder.path(), folder.path() / "none.json"}) {
    const auto error = open_session(session, path);
    REQUIRE(error);
    CHECK(is_one_sentence(*error));
  }
  write_text(folder.path() / "large.json", std::string((16U << 20U) + 1, ' '));
  const auto error = open_session(session, folder.path() / "large.json");
  REQUIRE(error);
  CHECK(contains(*error, "16 MB"));
  apply(session, OpenSession{folder.path() / "none.json"});
  REQUIRE(session.outbox->notices.size() == 1);
  CHECK(session.outbox->notices[0].kind == Notice::Kind::error);
}

TEST_CASE("fields that are not known are left alone, parameters that are missing keep their value") {
  const Folder folder;
  Json json = Json::parse(saved_text(example_session("sphere"), folder.path() / "a.json"));
  json["later"] = {{"deep", true}};
  json["camera"]["roll"] = 3;
  json["parameters"].erase("stacking-penalty");
  json["source"].erase("hash");
  Session session = empty_session();
  CHECK(error_of(folder, json.dump(), session) == "");
  CHECK(session.document);
  CHECK(session.outbox->notices.empty());
}

TEST_CASE("a welded run and a pinned one come back with the session") {
  const Folder folder;
  Session session = example_session("sphere");
  apply(session, SeekPlace{{knit::Stage::rows, 9, 2}});
  const knit::Parameters base = session.document->timeline.base_parameters();
  const bool welded = base.mesh.weld == knit::Weld::on;
  apply(session, Tune{with(base, "weld", welded ? "off" : "on")});
  REQUIRE(session.document->timeline.base_parameters().mesh.weld != base.mesh.weld);
  session.document->timeline.extend_to_end();  // and back to the place
  knit::Timeline other(session.document->timeline.input_pointer(),
                       with(session.document->timeline.base_parameters(), "close", "thesis"));
  other.extend_to_end();
  session.document->pinned = Pin{other.input_pointer(), knobs_of(other), other.furthest()};
  const std::string text = saved_text(session, folder.path() / "a.json");
  Session opened = empty_session();
  REQUIRE(open_session(opened, folder.path() / "a.json") == std::nullopt);
  CHECK(saved_text(opened, folder.path() / "a.json") == text);
  CHECK(knit::hash_of(opened.document->timeline.state()) ==
        knit::hash_of(session.document->timeline.state()));
  REQUIRE(opened.document->pinned);
  finish_pin(opened);
  CHECK(knit::hash_of(opened.document->pinned->end) == knit::hash_of(session.document->pinned->end));
  CHECK(opened.document->pinned->knobs == session.document->pinned->knobs);
  CHECK(opened.document->changes.undo.empty());
}

TEST_CASE("a saved run can be read without opening it") {
  const Folder folder;
  const Session session = rich_session();
  saved_text(session, folder.path() / "a.json");
  const auto read = read_saved_run(folder.path() / "a.json");
  REQUIRE(std::holds_alternative<SavedRun>(read));
  const auto& run = std::get<SavedRun>(read);
  CHECK(run.source.example == "sphere");
  const Knobs knobs = resolved(Knobs{run.base, run.edits}, session.document->timeline.input());
  CHECK(knobs.base == session.document->timeline.base_parameters());
  CHECK(knobs.edits == session.document->timeline.edits());
  const auto none = read_saved_run(folder.path() / "none.json");
  REQUIRE(std::holds_alternative<std::string>(none));
  CHECK(is_one_sentence(std::get<std::string>(none)));
}

TEST_CASE("a session without a mesh from a file cannot be saved, and says so") {
  const Folder folder;
  for (const Session& session : {Session{}, small_session()}) {
    const auto error = save_session(session, folder.path() / "a.json");
    REQUIRE(error);
    CHECK(is_one_sentence(*error));
  }
  Session session = example_session("sphere");
  session.view->pattern.title = "\xff\xfe";
  const auto error = save_session(session, folder.path() / "a.json");
  REQUIRE(error);
  CHECK(is_one_sentence(*error));
  CHECK(folder.files() == 0);
}

TEST_CASE("a file is known as a session by its ending or by what it begins with") {
  const Folder folder;
  saved_text(example_session("sphere"), folder.path() / "saved.JSON");
  std::filesystem::copy_file(folder.path() / "saved.JSON", folder.path() / "saved.knit");
  write_text(folder.path() / "ball.obj", "v 0 0 0\n");
  write_text(folder.path() / "ball", "v 0 0 0\n");
  CHECK(opening_of(folder.path() / "saved.JSON").is<OpenSession>());
  CHECK(opening_of(folder.path() / "saved.knit").is<OpenSession>());
  CHECK(opening_of(folder.path() / "ball.obj").is<OpenFile>());
  CHECK(opening_of(folder.path() / "ball").is<OpenFile>());
  CHECK(opening_of(folder.path() / "none").is<OpenFile>());
  CHECK(opening_of(folder.path()).is<OpenFile>());
}
