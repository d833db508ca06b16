// What each action does to a session, and that a refused one leaves it as it was.
#include <filesystem>

#include "app/session/action.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"
#include "knit/run/machine.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using test_support::contains;
using test_support::example_session;
using test_support::finished_small_session;
using test_support::is_one_sentence;
using test_support::small_session;

namespace {

void apply_all(Session& session, const Actions& actions) {
  for (const Action& action : actions) apply(session, action);
}

// What a person would miss if it changed: the run, its place, its parameters, where it came from.
struct Seen {
  std::uint64_t state;
  std::size_t position, known, edits;
  const knit::Input* input;
  knit::Parameters parameters, base, defaults;
  std::string example;
  std::filesystem::path file;
  std::size_t findings;
  Camera camera;
  bool playing;
  friend bool operator==(const Seen&, const Seen&) = default;
};

Seen seen(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  return {hash_of(timeline.state()),
          timeline.position(),
          timeline.known(),
          timeline.edits().size(),
          &timeline.input(),
          timeline.parameters(),
          timeline.base_parameters(),
          session.document->defaults,
          session.document->source.example,
          session.document->source.file,
          session.document->findings.size(),
          session.view->gaze.camera,
          session.view->playback.playing};
}

// Equal ones are one with a number.
int times_said(const Session& session) {
  int times = 0;
  for (const Notice& notice : session.outbox->notices) times += notice.times;
  return times;
}

// One error more than before, a sentence, and nothing else changed.
void check_refused(Session& session, const Action& action, const std::string& says) {
  const Seen before = seen(session);
  const int said = times_said(session);
  apply(session, action);
  CHECK((seen(session) == before));
  REQUIRE(times_said(session) == said + 1);
  CHECK(session.outbox->notices.back().kind == Notice::Kind::error);
  CAPTURE(session.outbox->notices.back().text);
  CHECK(is_one_sentence(session.outbox->notices.back().text));
  CHECK(contains(session.outbox->notices.back().text, says));
}

knit::Parameters with(knit::Parameters parameters, const std::string& key, const std::string& value) {
  REQUIRE_FALSE(knit::set_value(*knit::find_parameter(key), parameters, value));
  return parameters;
}

void save_obj(const std::filesystem::path& path, const knit::Mesh& mesh) {
  std::ofstream out(path);
  knit::write_obj(out, mesh, "");
}

// An open, flat-faced mesh that the method cannot knit.
const char* const flat = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n";

}  // namespace

TEST_CASE("opening an example: its mesh, its parameters, at the start and in view") {
  Session session = example_session("thesis-sphere");
  REQUIRE(session.document);
  CHECK(session.document->source.example == "thesis-sphere");
  CHECK(session.document->source.file.empty());
  CHECK(session.document->timeline.input().mesh.name == "thesis-sphere");
  CHECK(session.document->timeline.position() == 0);
  CHECK(session.document->timeline.parameters() == session.document->defaults);
  CHECK(session.document->defaults.rows.close == knit::Closing::thesis);
  CHECK(session.document->load_ms > 0.0);
  CHECK(session.outbox->notices.empty());
  Camera framed;
  framed.frame(session.document->timeline.input().bounds, session.view->aspect);
  CHECK(session.view->gaze.camera == framed);
}

TEST_CASE("every example opens") {
  for (const std::string& name : list_examples(KNIT_ASSETS_DIR)) {
    CAPTURE(name);
    const Session session = example_session(name);
    REQUIRE(session.document);
    CHECK(session.document->source.example == name);
  }
}

TEST_CASE("opening another mesh begins anew, whatever was going on") {
  Session session = finished_small_session();
  apply_all(session, {SetPlaying{true, -1}, SetSpeed{500.0}, SetPicking{Picking::end}, ShowOpenDialog{true},
                      Orbit{1.0, 0.2}, SetLayer{Layer::faces, false}, OpenExample{"egg"}});
  CHECK(session.document->source.example == "egg");
  CHECK(session.document->timeline.position() == 0);
  CHECK(session.document->run_ms == 0.0);
  CHECK_FALSE(session.view->playback.playing);
  CHECK(session.view->playback.direction == 1);
  CHECK(session.view->playback.steps_per_second == 500.0);
  CHECK(session.view->gaze.picking == Picking::nothing);
  CHECK_FALSE(session.view->dialogs.open_dialog_open);
  CHECK_FALSE(session.view->shows(Layer::faces));  // what the person likes to see stays
}

TEST_CASE("opening a file: parameters follow its size") {
  const test_support::Folder folder;
  save_obj(folder.path() / "a ball.obj", knit::sphere(24, 12));
  Session session;
  apply(session, OpenFile{folder.path() / "a ball.obj"});
  REQUIRE(session.document);
  CHECK(session.document->source.example.empty());
  CHECK(session.document->source.file == folder.path() / "a ball.obj");
  CHECK(session.document->timeline.input().mesh.name == "a ball");
  CHECK(session.document->defaults.stitch.width ==
        Approx(0.03 * session.document->timeline.input().bounds.diagonal()));
  CHECK(session.outbox->notices.empty());
}

TEST_CASE("what is odd about a mesh that can be knitted is a warning") {
  const test_support::Folder folder;
  save_obj(folder.path() / "seam.obj", knit::sphere(24, 12, true));
  Session session;
  apply(session, OpenFile{folder.path() / "seam.obj"});
  REQUIRE(session.document);
  REQUIRE(session.document->findings.size() == 1);
  REQUIRE(session.outbox->notices.size() == 1);
  CHECK(session.outbox->notices[0].kind == Notice::Kind::warning);
  CHECK(session.outbox->notices[0].text == session.document->findings[0].sentence);
}

TEST_CASE("what cannot be opened leaves the session as it was, with a sentence") {
  const test_support::Folder folder;
  test_support::write_text(folder.path() / "flat.obj", flat);
  test_support::write_text(folder.path() / "words.obj", "hello\n");
  Session session = finished_small_session();
  apply(session, SeekTo{700});
  check_refused(session, OpenFile{folder.path() / "flat.obj"}, "plane");
  check_refused(session, OpenFile{folder.path() / "words.obj"}, "words.obj");
  check_refused(session, OpenFile{folder.path() / "missing.obj"}, "does not exist");
  check_refused(session, OpenFile{folder.path()}, "folder");
  check_refused(session, OpenExample{"teapot"}, "choose one of");
  session.program->assets = folder.path();
  check_refused(session, OpenExample{"sphere"}, "build the project again");
}

TEST_CASE("with nothing open, actions about a run do nothing") {
  Session session;
  apply_all(session, {StepBy{}, SeekTo{5}, SeekPlace{}, ToFirst{}, ToLast{}, SetPlaying{}, PassTime{0.1},
                      Tune{}, EditFromHere{}, RemoveEdit{}, PickVertex{3}, FrameAll{}, Export{"map", "-"}});
  CHECK_FALSE(session.document);
  CHECK_FALSE(session.view->playback.playing);
  CHECK(session.outbox->notices.empty());
  CHECK(is_one_sentence(sentence(session)));
}

TEST_CASE("stepping and seeking") {
  Session session = small_session();
  apply(session, StepBy{Unit::item, 1});
  CHECK(session.document->timeline.position() == 1);
  apply(session, StepBy{Unit::stage, 1});
  CHECK(session.document->timeline.state().stage() == knit::Stage::cast_on);
  apply(session, StepBy{Unit::stage, -1});
  CHECK(session.document->timeline.position() == 0);
  apply(session, StepBy{Unit::item, -1});
  CHECK(session.document->timeline.position() == 0);
  apply(session, SeekTo{900});  // further than worked out
  CHECK(session.document->timeline.position() == 900);
  apply(session, SeekPlace{{knit::Stage::rows, 3, 2}});
  CHECK(session.document->timeline.place() == knit::Place{knit::Stage::rows, 3, 2});
  apply(session, ToLast{});
  CHECK(session.document->timeline.state().finished());
  CHECK(session.document->timeline.complete());
  apply(session, StepBy{Unit::item, 1});
  CHECK(session.document->timeline.position() == session.document->timeline.known());
  apply(session, ToFirst{});
  CHECK(session.document->timeline.position() == 0);
  apply(session, SeekTo{10000000});
  CHECK(session.document->timeline.position() == session.document->timeline.known());
}

TEST_CASE("the time spent on the run is counted, by whatever action it is worked out") {
  for (const Action& action : Actions{ToLast{}, PassTime{0.0}, SeekTo{1500}, StepBy{Unit::stage, 1},
                                      SeekPlace{{knit::Stage::rows, 5, 0}}}) {
    Session session = small_session();
    apply(session, action);
    CAPTURE(action.index());
    CHECK(session.document->timeline.known() > 0);
    CHECK(session.document->run_ms > 0.0);
  }
}

TEST_CASE("playing takes as many steps as the time and the speed give") {
  Session session = small_session();
  constexpr std::size_t from = 1000;  // behind the times, which are played in strides
  apply_all(session, {SeekTo{from}, SetSpeed{100.0}, SetPlaying{}, PassTime{0.1}});
  CHECK(session.view->playback.playing);
  CHECK(session.document->timeline.position() == from + 10);
  for (int i = 0; i < 8; ++i) apply(session, PassTime{0.0125});  // 1.25 steps each
  CHECK(session.document->timeline.position() == from + 20);
  apply(session, SetPlaying{false});
  apply(session, PassTime{0.2});
  CHECK(session.document->timeline.position() == from + 20);
  apply_all(session, {SetPlaying{true, -1}, PassTime{0.05}});
  CHECK(session.document->timeline.position() == from + 15);
}

TEST_CASE("a long pause, as of a laptop asleep, is not played back at once") {
  Session session = small_session();
  apply_all(session, {SeekTo{1000}, SetSpeed{100.0}, SetPlaying{}, PassTime{3600.0}});
  CHECK(session.document->timeline.position() <= 1050);
  apply(session, PassTime{-5.0});
  CHECK(session.view->playback.playing);
}

TEST_CASE("the clock works the run out, playing or not, and playing goes no further than it") {
  Session session = small_session();
  apply(session, PassTime{0.0});
  CHECK(session.document->timeline.known() > 1000);
  CHECK(session.document->timeline.position() == 0);
  CHECK_FALSE(session.view->playback.playing);
}

TEST_CASE("playing ends at both ends, and playing again at the end begins anew") {
  Session session = small_session();
  apply_all(session, {SetSpeed{fastest_steps_per_second}, SetPlaying{}});
  for (int i = 0; i < 1000 && session.view->playback.playing; ++i) apply(session, PassTime{0.25});
  CHECK_FALSE(session.view->playback.playing);
  CHECK(session.document->timeline.state().finished());
  apply(session, SetPlaying{});
  CHECK(session.view->playback.playing);
  CHECK(session.document->timeline.position() == 0);

  apply_all(session, {ToLast{}, SetPlaying{true, -1}});
  CHECK(session.document->timeline.state().finished());
  for (int i = 0; i < 1000 && session.view->playback.playing; ++i) apply(session, PassTime{0.25});
  CHECK(session.document->timeline.position() == 0);
  CHECK_FALSE(session.view->playback.playing);
  CHECK(session.view->playback.direction == 1);
}

TEST_CASE("a step taken by hand pauses") {
  Session session = small_session();
  apply_all(session, {SetPlaying{}, StepBy{}});
  CHECK_FALSE(session.view->playback.playing);
}

TEST_CASE("the speed stays within its range") {
  Session session = small_session();
  apply(session, SetSpeed{0.0});
  CHECK(session.view->playback.steps_per_second == slowest_steps_per_second);
  apply(session, SetSpeed{1e30});
  CHECK(session.view->playback.steps_per_second == fastest_steps_per_second);
  apply(session, SetSpeed{250.0});
  CHECK(session.view->playback.steps_per_second == 250.0);
}

TEST_CASE("tuning keeps the place and counts from the start") {
  Session session = finished_small_session();
  const knit::Place place{knit::Stage::rows, 6, 4};
  apply_all(session,
            {SeekPlace{place}, Tune{with(test_support::small_parameters(), "cast-on", "8")}, PassTime{0.0}});
  CHECK(session.document->timeline.base_parameters().rows.cast_on == 8);
  CHECK(session.document->timeline.place() == place);
  CHECK(session.document->timeline.state().fabric.rows()[0]->stitches.size() == 8);
  CHECK(session.document->defaults.rows.cast_on == 0);
  CHECK(session.outbox->notices.empty());
}

TEST_CASE("tuning while it plays goes on from the same place, however long the run takes to get there") {
  Session session = small_session();
  session.document->timeline =
      knit::Timeline(knit::make_input(knit::sphere(256, 129)), test_support::thesis_parameters());
  const knit::Place place{knit::Stage::rows, 100, 4};
  apply_all(session, {ToLast{}, SeekPlace{place}, SetPlaying{}});
  REQUIRE(session.document->timeline.position() > 45000);  // more than one tick works out
  apply(session, Tune{with(session.document->timeline.parameters(), "axis", "0,-1,0")});
  for (int i = 0; i < 1000 && !session.document->timeline.complete(); ++i) apply(session, PassTime{0.0});
  CHECK(session.view->playback.playing);
  CHECK(session.document->timeline.place() == place);
  apply(session, PassTime{0.2});
  CHECK(session.document->timeline.place() > place);
}

TEST_CASE("refused parameters leave the session as it was, with a sentence") {
  Session session = finished_small_session();
  apply(session, SeekTo{700});
  const knit::Parameters good = session.document->timeline.parameters();
  for (const bool tune : {true, false}) {
    const auto change = [&](const std::string& key, const std::string& value) {
      return tune ? Action(Tune{with(good, key, value)}) : Action(EditFromHere{with(good, key, value)});
    };
    check_refused(session, change("epsilon", "0.4"), "\xCE\xB5 must be smaller");
    check_refused(session, change("start", "99999"), "--start");
    check_refused(session, change("end", "99999"), "--end");
  }
  check_refused(session, EditFromHere{with(good, "weld", "on")}, "whole run");
}

TEST_CASE("an edit from here keeps the past, and can be removed") {
  Session session = finished_small_session();
  const knit::Place place{knit::Stage::rows, 6, 4};
  apply(session, SeekPlace{place});
  const Seen before = seen(session);
  apply(session, EditFromHere{with(test_support::small_parameters(), "epsilon", "0.28")});
  CHECK(session.document->timeline.edits().size() == 1);
  CHECK(session.document->timeline.position() == before.position);
  CHECK(hash_of(session.document->timeline.state()) == before.state);
  CHECK(session.document->timeline.parameters().epsilon() == 0.28);
  CHECK(session.document->timeline.base_parameters().epsilon() == 0.15);
  apply(session, RemoveEdit{7});  // there is none
  CHECK(session.document->timeline.edits().size() == 1);
  apply_all(session, {RemoveEdit{0}, PassTime{0.0}});
  CHECK(session.document->timeline.edits().empty());
  CHECK((seen(session) == before));
}

TEST_CASE("where rows come from cannot change from here once they have begun") {
  Session session = finished_small_session();
  for (const knit::Place& place : {knit::Place{knit::Stage::cast_on, 1, 0}, {knit::Stage::rows, 5, 3}}) {
    apply(session, SeekPlace{place});
    check_refused(session, EditFromHere{with(session.document->timeline.parameters(), "rows", "contours")},
                  "whole run");
    CHECK(contains(session.outbox->notices.back().text, "from rings already"));
  }
  apply_all(
      session,
      {SeekTo{0}, EditFromHere{with(session.document->timeline.parameters(), "rows", "contours")}, ToLast{}});
  CHECK(session.outbox->notices.empty());  // values were taken
  CHECK(session.document->timeline.state().finished());
  CHECK(session.document->timeline.base_parameters().rows.source == knit::RowSource::rings);
  CHECK(session.document->timeline.state().fabric.rows()[3]->ring->ordered_by == knit::OrderedBy::cut);
}

TEST_CASE("welding runs on the merged mesh, at the same place, and back again") {
  Session session = small_session(true);
  const std::size_t unwelded = session.document->timeline.input().mesh.positions.size();
  const knit::Place place{knit::Stage::rows, 6, 4};
  apply_all(session, {ToLast{}, SeekPlace{place}, Tune{with(test_support::small_parameters(), "weld", "on")},
                      PassTime{0.0}});
  CHECK(session.document->timeline.input().mesh.positions.size() < unwelded);
  CHECK(session.document->original->positions.size() == unwelded);
  CHECK(session.document->timeline.parameters().mesh.weld == knit::Weld::on);
  CHECK(session.document->timeline.place() == place);

  apply_all(session, {Tune{test_support::small_parameters()}, PassTime{0.0}});
  CHECK(session.document->timeline.input().mesh.positions.size() == unwelded);
  CHECK(session.document->timeline.place() == place);
}

TEST_CASE("welding keeps edits, and is refused when a picked vertex would be gone") {
  Session session = small_session(true);
  const knit::Parameters good = test_support::small_parameters();
  apply_all(session,
            {ToLast{}, SeekPlace{{knit::Stage::rows, 6, 4}}, EditFromHere{with(good, "epsilon", "0.28")}});
  apply_all(session, {Tune{with(session.document->timeline.parameters(), "weld", "on")}, PassTime{0.0}});
  REQUIRE(session.document->timeline.edits().size() == 1);
  CHECK(session.document->timeline.edits()[0].parameters.epsilon() == 0.28);
  CHECK(session.document->timeline.edits()[0].parameters.mesh.weld == knit::Weld::on);
  CHECK(session.document->timeline.base_parameters().epsilon() == 0.15);

  Session picked = small_session(true);
  const auto last = std::to_string(picked.document->timeline.input().mesh.positions.size() - 1);
  apply_all(picked, {Tune{with(good, "end", last)}, ToLast{}});
  CHECK(picked.outbox->notices.empty());
  check_refused(picked, Tune{with(with(good, "end", last), "weld", "on")}, "--end");
}

TEST_CASE("picking start and end vertices") {
  Session session = finished_small_session();
  const auto top = static_cast<knit::VertexId>(session.document->timeline.input().mesh.positions.size() - 1);
  apply(session, PickVertex{top});  // nobody asked
  CHECK(session.document->timeline.parameters().timing.start == knit::no_vertex);
  apply(session, SetPicking{Picking::start});
  CHECK(session.view->gaze.picking == Picking::start);
  apply(session, PickVertex{top});
  CHECK(session.view->gaze.picking == Picking::nothing);
  CHECK(session.document->timeline.parameters().timing.start == top);
  apply_all(session, {SetPicking{Picking::end}, PickVertex{0}});
  CHECK(session.document->timeline.parameters().timing.end == 0);
  CHECK(session.document->timeline.parameters().timing.start == top);
  apply(session, ToLast{});
  CHECK(session.document->timeline.furthest().fabric.rows().front()->stitches.front().position.y >
        0.0);  // now from the top

  apply(session, SetPicking{Picking::end});
  check_refused(session, PickVertex{top}, "two different");
  CHECK(session.view->gaze.picking == Picking::nothing);
  apply(session, SetPicking{Picking::end});
  check_refused(session, PickVertex{top + 1}, "--end");
}

TEST_CASE("layers go on and off, one at a time") {
  Session session;
  for (std::size_t i = 0; i < layer_count; ++i) {
    const auto layer = static_cast<Layer>(i);
    const auto others = [&] {
      auto layers = session.view->layers;
      layers[i] = false;
      return layers;
    };
    const auto before = others();
    apply(session, SetLayer{layer, true});
    CHECK(session.view->shows(layer));
    apply(session, SetLayer{layer, false});
    CHECK_FALSE(session.view->shows(layer));
    CHECK(others() == before);
    CHECK_FALSE(name_of(layer).empty());
    CHECK_FALSE(key_of(layer).empty());
  }
}

TEST_CASE("the camera turns, moves, zooms and frames, and nonsense is ignored") {
  Session session = small_session();
  const Camera framed = session.view->gaze.camera;
  apply(session, Orbit{0.5, 0.1});
  CHECK(session.view->gaze.camera.yaw == Approx(framed.yaw + 0.5));
  apply(session, Pan{{0.5, 0.0}});
  CHECK_FALSE(session.view->gaze.camera.target == framed.target);
  apply(session, Zoom{0.5, {0.0, 0.0}});
  CHECK(session.view->gaze.camera.distance == Approx(0.5 * framed.distance));
  const Camera zoomed = session.view->gaze.camera;
  apply_all(session, {Zoom{0.0, {0.0, 0.0}}, Zoom{-1.0, {0.0, 0.0}}});
  CHECK(session.view->gaze.camera == zoomed);
  apply(session, FrameAll{});
  CHECK(session.view->gaze.camera.target == framed.target);
  CHECK(session.view->gaze.camera.distance == framed.distance);
  CHECK(session.view->gaze.camera.yaw == zoomed.yaw);  // framing does not turn

  apply(session, SetAspect{2.0});
  CHECK(session.view->aspect == 2.0);
  apply_all(session, {SetAspect{0.0}, SetAspect{-1.0}, SetAspect{std::numeric_limits<double>::infinity()},
                      SetAspect{std::numeric_limits<double>::quiet_NaN()}});
  CHECK(session.view->aspect == 2.0);
}

TEST_CASE("exports are written where asked, with a notice either way") {
  const test_support::Folder folder;
  Session session = finished_small_session();
  for (const std::string what : {"mesh", "map", "report", "steps"}) {
    const std::filesystem::path path = folder.path() / ("out." + what);
    apply(session, Export{what, path});
    CHECK(std::filesystem::file_size(path) > 0);
    CHECK(session.outbox->notices.back().kind == Notice::Kind::info);
    CHECK(contains(session.outbox->notices.back().text, path.filename().string()));
  }
  check_refused(session, Export{"map", folder.path() / "no" / "such" / "folder.txt"}, "cannot write");
  apply(session, Export{"screenshot", "p.png"});
  REQUIRE(session.outbox->screenshots.size() == 1);
  CHECK(session.outbox->screenshots[0] == "p.png");
}

TEST_CASE("help, the open dialog, notices and quitting") {
  Session session;
  apply_all(session, {ShowHelp{true}, ShowOpenDialog{true}});
  CHECK(session.view->dialogs.help_open);
  CHECK(session.view->dialogs.open_dialog_open);
  apply_all(session, {ShowHelp{false}, ShowOpenDialog{false}});
  CHECK_FALSE(session.view->dialogs.help_open);
  CHECK_FALSE(session.view->dialogs.open_dialog_open);

  apply_all(session, {OpenFile{"no-such-1.obj"}, OpenFile{"no-such-2.obj"}, DismissNotice{5}});
  CHECK(session.outbox->notices.size() == 2);
  apply(session, DismissNotice{0});
  REQUIRE(session.outbox->notices.size() == 1);
  CHECK(contains(session.outbox->notices[0].text, "no-such-2"));

  CHECK_FALSE(session.outbox->quit);
  apply(session, Quit{});
  CHECK(session.outbox->quit);
}

TEST_CASE("the sentence always says something, and at a stop why") {
  Session session = small_session();
  for (int i = 0; i < 2000; i += 37) {
    apply(session, SeekTo{static_cast<std::size_t>(i)});
    CHECK(is_one_sentence(sentence(session)));
  }
  Session torus = test_support::torus_from_rings();
  apply(torus, ToLast{});
  REQUIRE(stop_shown(torus) != nullptr);
  CHECK(contains(sentence(torus), "splits"));
  apply(torus, StepBy{Unit::item, -1});
  CHECK(stop_shown(torus) == nullptr);
  CHECK_FALSE(contains(sentence(torus), "splits"));
}
