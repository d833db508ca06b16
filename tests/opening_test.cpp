// A large file is opened beside the window: to the same end, with progress, and cancelled whenever one likes.
#include "app/actions/opening.h"

#include <sstream>
#include <thread>

#include "app/files/session_file.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "knit/import/obj.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;

namespace {

std::string ball_text(unsigned segments) {
  std::ostringstream out;
  knit::write_obj(out, knit::sphere(segments, 150), "");
  return out.str();
}

struct Files {
  Folder folder;
  std::filesystem::path large = folder.path() / "large ball.obj", other = folder.path() / "other.obj",
                        holed = folder.path() / "holed.obj", small = folder.path() / "small.obj";
  Files() {
    write_text(large, ball_text(160));
    write_text(other, ball_text(170));
    const std::string text = ball_text(160);
    write_text(holed, text.substr(0, text.rfind("f ")));  // its last face is missing
    std::ostringstream out;
    knit::write_obj(out, knit::sphere(12, 8), "");
    write_text(small, out.str());
  }
};

Session window_session() {
  Session session = example_session("egg");
  session.jobs->beside = true;
  return session;
}

void tick_to_end_of_opening(Session& session) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(3);
  while (session.jobs->opening) {
    apply(session, PassTime{0.001});
    REQUIRE(std::chrono::steady_clock::now() < give_up);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void check_untouched(const Session& session, const knit::Input* input) {
  CHECK(session.document->source.example == "egg");
  CHECK(&session.document->timeline.input() == input);
}

}  // namespace

TEST_CASE("in a window a large file is opened beside it and what is open stays until then") {
  const Files files;
  Session session = window_session();
  const knit::Input* egg = &session.document->timeline.input();
  apply(session, ToLast{});
  apply(session, OpenFile{files.large});
  REQUIRE(session.jobs->opening);
  check_untouched(session, egg);
  CHECK(session.document->timeline.position() > 0);
  apply(session, SeekTo{5});  // it can be worked with meanwhile
  CHECK(session.document->timeline.position() == 5);
  tick_to_end_of_opening(session);

  Session plain;
  plain.program->assets = KNIT_ASSETS_DIR;
  apply(plain, OpenFile{files.large});
  REQUIRE(plain.document);
  CHECK_FALSE(plain.jobs->opening);
  CHECK(session.document->source.file == files.large);
  CHECK(session.document->source.example.empty());
  CHECK(session.document->timeline.position() == 0);
  CHECK(session.document->timeline.parameters() == plain.document->timeline.parameters());
  CHECK(session.document->timeline.input().mesh.positions == plain.document->timeline.input().mesh.positions);
  CHECK(session.document->timeline.input().mesh.triangles == plain.document->timeline.input().mesh.triangles);
  CHECK(session.document->mesh_hash == plain.document->mesh_hash);
  CHECK(session.document->mesh_hash == hash_text(*session.document->original));
  CHECK(session.outbox->notices.empty());
  CHECK(session.document->load_ms > 0.0);
  CHECK_FALSE(session.document->timeline.sought());  // no place of the egg's is looked for
}

TEST_CASE("what is small is opened at once and so is everything without a window") {
  const Files files;
  Session session = window_session();
  apply(session, OpenFile{files.small});
  CHECK_FALSE(session.jobs->opening);
  CHECK(session.document->source.file == files.small);
  session.jobs->beside = false;
  apply(session, OpenFile{files.large});
  CHECK_FALSE(session.jobs->opening);
  CHECK(session.document->source.file == files.large);
  session.jobs->beside = true;
  apply(session, OpenFile{files.folder.path() / "none.obj"});
  CHECK_FALSE(session.jobs->opening);
  REQUIRE_FALSE(session.outbox->notices.empty());
  CHECK(contains(session.outbox->notices.back().text, "does not exist"));
}

TEST_CASE("opening is cancelled and nothing of it stays") {
  const Files files;
  Session session = window_session();
  const knit::Input* egg = &session.document->timeline.input();
  apply(session, OpenFile{files.large});
  const std::shared_ptr<Opening> opening = session.jobs->opening;
  REQUIRE(opening);
  const knit::Parameters before = session.document->timeline.parameters();
  apply(session, CancelWork{});
  CHECK_FALSE(session.jobs->opening);
  CHECK(opening->progress->stopped());
  while (!opening->work.ready()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  apply(session, PassTime{0.1});
  check_untouched(session, egg);
  CHECK(session.document->timeline.parameters() == before);
  CHECK(session.outbox->notices.empty());
}

TEST_CASE("opening another thing cancels the first") {
  const Files files;
  Session session = window_session();
  apply(session, OpenFile{files.large});
  const std::shared_ptr<Opening> first = session.jobs->opening;
  REQUIRE(first);
  SECTION("another file") {
    apply(session, OpenFile{files.other});
    REQUIRE(session.jobs->opening);
    CHECK(session.jobs->opening != first);
    tick_to_end_of_opening(session);
    CHECK(session.document->source.file == files.other);
  }
  SECTION("a small one") {
    apply(session, OpenFile{files.small});
    CHECK_FALSE(session.jobs->opening);
    apply(session, PassTime{0.1});
    CHECK(session.document->source.file == files.small);
  }
  SECTION("an example") {
    apply(session, OpenExample{"sphere"});
    CHECK_FALSE(session.jobs->opening);
    apply(session, PassTime{0.1});
    CHECK(session.document->source.example == "sphere");
  }
  CHECK(first->progress->stopped());
}

TEST_CASE("a large file that is not fit leaves the session as it was, says why, and offers repairs") {
  const Files files;
  Session session = window_session();
  const knit::Input* egg = &session.document->timeline.input();
  apply(session, OpenFile{files.holed});
  REQUIRE(session.jobs->opening);
  tick_to_end_of_opening(session);
  check_untouched(session, egg);
  REQUIRE(session.jobs->repair_offer);
  CHECK(contains(session.jobs->repair_offer->finding, "hole"));
  apply(session, RepairAndOpen{});
  check_untouched(session, egg);
  tick_to_end_of_opening(session);
  CHECK(session.document->source.file == files.holed);
  CHECK(session.document->repaired.size() == 1);
}

TEST_CASE("a session with a large mesh is opened beside the window too") {
  const Files files;
  Session saved;
  saved.program->assets = KNIT_ASSETS_DIR;
  apply(saved, OpenFile{files.large});
  apply(saved, SeekTo{300});
  const auto path = files.folder.path() / "a.json";
  REQUIRE_FALSE(save_session(saved, path));
  Session session = window_session();
  apply(session, OpenSession{path});
  REQUIRE(session.jobs->opening);
  CHECK(session.document->source.example == "egg");
  tick_to_end_of_opening(session);
  for (int i = 0; i < 3; ++i) apply(session, PassTime{0.01});
  CHECK(session.document->source.file == files.large);
  CHECK(session.document->timeline.place() == saved.document->timeline.place());
  CHECK(session.document->saved);
  CHECK(session.program->preferences.recent.front() == path.string());
  CHECK(session.outbox->notices.empty());
}

TEST_CASE("reading and checking tell how far they are and stop when that is wished") {
  const std::string text = ball_text(160);
  knit::Progress progress;
  std::istringstream in(text);
  const auto read = knit::read_obj(in, "ball", &progress);
  REQUIRE(std::holds_alternative<knit::Mesh>(read));
  CHECK(progress.task() == knit::Progress::Task::reading);
  CHECK(progress.share() > 0.9);
  CHECK(knit::check(std::get<knit::Mesh>(read), &progress).fit());
  CHECK(progress.task() == knit::Progress::Task::checking);
  CHECK(progress.share() > 0.5);
  progress.stop();
  std::istringstream again(text);
  CHECK_THROWS_AS(knit::read_obj(again, "ball", &progress), knit::Cancelled);
  CHECK_THROWS_AS(knit::check(std::get<knit::Mesh>(read), &progress), knit::Cancelled);
}

TEST_CASE("a part of a task tells its share of the whole") {
  knit::Progress progress;
  knit::PartProgress part(&progress, 0.2, 0.6);
  for (std::size_t i = 0; i < 8192; ++i) part.at(i, 8192);
  CHECK(progress.share() == Approx(0.6).margin(0.001));
  progress.stop();
  const auto go_on = [&] {
    for (std::size_t i = 0; i < 4096; ++i) part.at(i, 4096);
  };
  CHECK_THROWS_AS(go_on(), knit::Cancelled);
}

TEST_CASE("the card of an opening comes after a moment and cancels it") {
  desk::Desk desk;
  desk.session.jobs->opening = std::make_shared<Opening>();
  Opening& opening = *desk.session.jobs->opening;
  opening.path = "/meshes/big.obj";
  opening.progress = std::make_shared<knit::Progress>();
  opening.progress->begin(knit::Progress::Task::checking);
  CHECK(words_of(opening) == "Checking big.obj");
  opening.seconds = 0.1;
  desk.settle();
  CHECK(desk.ui.controls.count("waiting/cancel") == 0);
  opening.seconds = 0.4;
  desk.settle();
  const Actions wishes = desk.click("waiting/cancel");
  CHECK(desk::count_of<CancelWork>(wishes) == 1);
  desk.act(wishes);
  CHECK_FALSE(desk.session.jobs->opening);
}
