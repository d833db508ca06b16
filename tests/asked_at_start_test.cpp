// What the command line asks of a mesh that opens only after the window came: when repairs are made, or a worker is done.
#include "app/script/open_as_asked.h"

#include <sstream>
#include <thread>

#include "app/actions/opening.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/program.h"
#include "knit/import/obj.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;

namespace {

std::filesystem::path bad_file(const Folder& folder) {
  for (const corpus::Case& file : corpus::all_cases())
    if (file.name == "two-pieces.obj") return corpus::write(file, folder.path());
  FAIL("the corpus has no two pieces");
  return {};
}

// Large enough for a worker; without its last face where it is not whole.
std::filesystem::path large_file(const Folder& folder, bool whole) {
  std::ostringstream out;
  knit::write_obj(out, knit::sphere(160, 150), "");
  std::string text = out.str();
  if (!whole) text.resize(text.rfind("f "));
  write_text(folder.path() / "large.obj", text);
  return folder.path() / "large.obj";
}

struct Start {
  explicit Start(const std::filesystem::path& file) {
    const std::vector<std::string> words{file.string(), "--stitch-width", "0.37", "--theme", "light"};
    line = std::get<CommandLine>(parse_command_line(words, KNIT_ASSETS_DIR));
    session.program->assets = KNIT_ASSETS_DIR;
    error = open_as_asked(session, line);
    session.jobs->beside = true;
  }
  [[nodiscard]] double stitch_width() const { return session.document->timeline.parameters().stitch.width; }

  CommandLine line;
  Session session;
  std::optional<std::string> error;
};

void wait_for_worker(Start& start, AskedAtStart& asked) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(3);
  while (start.session.jobs->opening) {
    CHECK_FALSE(asked.tend(start.session, start.line));
    apply(start.session, PassTime{0.001});
    REQUIRE(std::chrono::steady_clock::now() < give_up);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace

TEST_CASE("asked at the start: options wait until repairs are made") {
  const Folder folder;
  Start start(bad_file(folder));
  CHECK_FALSE(start.error);
  REQUIRE(start.session.jobs->repair_offer);
  AskedAtStart asked(start.session);
  CHECK_FALSE(asked.tend(start.session, start.line));
  apply(start.session, RepairAndOpen{});
  REQUIRE(start.session.document);
  CHECK(start.stitch_width() != 0.37);
  CHECK(asked.tend(start.session, start.line));
  CHECK(start.stitch_width() == 0.37);
  apply(start.session, Tune{start.session.document->defaults});
  CHECK_FALSE(asked.tend(start.session, start.line));  // once
  CHECK(start.stitch_width() != 0.37);
}

TEST_CASE("asked at the start: options are not for another mesh") {
  const Folder folder;
  Start start(bad_file(folder));
  AskedAtStart asked(start.session);
  apply(start.session, DropRepairOffer{});
  CHECK_FALSE(asked.tend(start.session, start.line));
  apply(start.session, OpenExample{"egg"});
  CHECK_FALSE(asked.tend(start.session, start.line));
  apply(start.session, OpenFile{bad_file(folder)});
  apply(start.session, RepairAndOpen{});
  CHECK_FALSE(asked.tend(start.session, start.line));
  CHECK(start.stitch_width() != 0.37);
}

TEST_CASE("asked at the start: options wait for the worker, and then for repairs") {
  const Folder folder;
  for (const bool whole : {true, false}) {
    CAPTURE(whole);
    Start start(large_file(folder, whole));
    CHECK_FALSE(start.error);
    REQUIRE(start.session.jobs->opening);
    AskedAtStart asked(start.session);
    wait_for_worker(start, asked);
    if (!whole) {
      CHECK_FALSE(asked.tend(start.session, start.line));
      REQUIRE(start.session.jobs->repair_offer);
      apply(start.session, RepairAndOpen{});
      wait_for_worker(start, asked);
    }
    CHECK(asked.tend(start.session, start.line));
    CHECK(start.stitch_width() == 0.37);
  }
}

TEST_CASE("asked at the start: a cancelled opening takes its options along") {
  const Folder folder;
  Start start(large_file(folder, true));
  AskedAtStart asked(start.session);
  apply(start.session, CancelWork{});
  CHECK_FALSE(asked.tend(start.session, start.line));
  apply(start.session, OpenExample{"egg"});
  CHECK_FALSE(asked.tend(start.session, start.line));
  CHECK(start.stitch_width() != 0.37);
}

TEST_CASE("asked at the start: with the mesh open at once there is nothing to wait for") {
  Start start("nowhere.obj");
  CHECK(start.error);
  AskedAtStart asked(start.session);
  apply(start.session, OpenExample{"egg"});
  CHECK_FALSE(asked.tend(start.session, start.line));
}
