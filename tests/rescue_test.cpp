// What is saved aside while the program runs, and found after a crash.
#include "app/files/rescue.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "app/files/session_file.h"
#include "app/session/action.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "tests/support/catch.h"
#include "tests/support/open_session.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;

namespace {

// A process that is over.
Process gone() {
  const pid_t id = ::fork();
  if (id == 0) ::_exit(0);
  ::waitpid(id, nullptr, 0);
  return {id, 1};
}

// Sets a variable of the environment while it lives.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    if (value != nullptr) ::setenv(name, value, 1);
    if (value == nullptr) ::unsetenv(name);
  }
  ~Variable() {
    if (before_) ::setenv(name_, before_->c_str(), 1);
    if (!before_) ::unsetenv(name_);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

}  // namespace

TEST_CASE("the state folder is where the system says, or nowhere") {
  const Variable home("HOME", "/home/someone");
  {
    const Variable state("XDG_STATE_HOME", "/var/state");
    CHECK(rescue_folder() == "/var/state/knit-mesh");
  }
  {
    const Variable state("XDG_STATE_HOME", "relative");
    CHECK(rescue_folder() == "/home/someone/.local/state/knit-mesh");
  }
  const Variable state("XDG_STATE_HOME", nullptr);
  const Variable homeless("HOME", nullptr);
  CHECK_FALSE(rescue_folder());
}

TEST_CASE("only real changes are written, some seconds after them, and a clean end leaves nothing") {
  const Folder folder;
  const auto place = folder.path() / "state" / "knit-mesh";
  Session session = example_session("sphere");
  RescueKeeper keeper(session, place);
  for (int i = 0; i < 10; ++i) keeper.pass(session, 1.0);
  CHECK_FALSE(std::filesystem::exists(place));
  apply(session, SeekPlace{{knit::Stage::rows, 9, 4}});
  keeper.pass(session, 0.5);
  CHECK_FALSE(std::filesystem::exists(place));
  for (int i = 0; i < 10; ++i) keeper.pass(session, 1.0);
  const auto file = rescue_file(place, this_process());
  REQUIRE(std::filesystem::exists(file));
  Session opened = example_session("egg");
  CHECK(open_session(opened, file) == std::nullopt);
  CHECK(opened.document->timeline.place() == session.document->timeline.place());
  CHECK_FALSE(find_rescued(place));  // it is of a program that runs: this one
  keeper.end();
  CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("what a process left behind is found, newest first, opened or forgotten") {
  const Folder folder;
  Session session = example_session("sphere");
  apply(session, SeekPlace{{knit::Stage::rows, 9, 4}});
  const Process old_one = gone();
  const Process new_one = gone();
  REQUIRE_FALSE(save_session(session, rescue_file(folder.path(), old_one)));
  apply(session, SeekPlace{{knit::Stage::rows, 12, 4}});
  REQUIRE_FALSE(save_session(session, rescue_file(folder.path(), new_one)));
  const auto earlier =
      std::filesystem::last_write_time(rescue_file(folder.path(), old_one)) - std::chrono::hours(1);
  std::filesystem::last_write_time(rescue_file(folder.path(), old_one), earlier);
  // What is not ours, not whole, or of a running program is let be.
  REQUIRE_FALSE(save_session(session, rescue_file(folder.path(), this_process())));
  write_text(folder.path() / "session-x-1.json", "{}");
  write_text(rescue_file(folder.path(), gone()), "{ half");
  write_text(folder.path() / "notes.txt", "mine");

  Session fresh = example_session("egg");
  fresh.program->rescued = find_rescued(folder.path());
  REQUIRE(fresh.program->rescued);
  CHECK(fresh.program->rescued->path == rescue_file(folder.path(), new_one));
  CHECK(fresh.program->rescued->words == "sphere, row 12");

  SECTION("opened, it is this program's own from then on") {
    apply(fresh, TakeRescued{});
    CHECK(fresh.document->source.example == "sphere");
    CHECK(fresh.document->timeline.place() == session.document->timeline.place());
    CHECK_FALSE(fresh.program->rescued);
    CHECK_FALSE(fresh.document->saved);
    CHECK_FALSE(std::filesystem::exists(rescue_file(folder.path(), new_one)));
    CHECK(std::filesystem::exists(rescue_file(folder.path(), this_process())));
  }
  SECTION("forgotten, the one before it is offered") {
    apply(fresh, DropRescued{});
    CHECK(fresh.document->source.example == "egg");
    CHECK_FALSE(std::filesystem::exists(rescue_file(folder.path(), new_one)));
    REQUIRE(fresh.program->rescued);
    CHECK(fresh.program->rescued->words == "sphere, row 9");
    apply(fresh, DropRescued{});
    CHECK_FALSE(fresh.program->rescued);
    CHECK(std::filesystem::exists(rescue_file(folder.path(), this_process())));
  }
  SECTION("where its mesh is gone it says so and stays on offer") {
    fresh.program->assets = folder.path();
    apply(fresh, TakeRescued{});
    CHECK(fresh.program->rescued);
    REQUIRE(fresh.outbox->notices.size() == 1);
    CHECK(fresh.outbox->notices[0].kind == Notice::Kind::error);
  }
}

TEST_CASE("a number used again is another process, and where nothing can be written nothing is said") {
  CHECK(is_running(this_process()));
  CHECK_FALSE(is_running(gone()));
  Process other = this_process();
  if (other.began != 0) {
    ++other.began;
    CHECK_FALSE(is_running(other));
  }
  const Folder folder;
  write_text(folder.path() / "file", "in the way");
  Session session = example_session("sphere");
  RescueKeeper nowhere(session, std::nullopt);
  RescueKeeper blocked(session, folder.path() / "file" / "knit-mesh");
  apply(session, SeekTo{50});
  nowhere.pass(session, 10.0);
  blocked.pass(session, 10.0);
  nowhere.end();
  blocked.end();
  CHECK(session.outbox->notices.empty());
  CHECK_FALSE(find_rescued(folder.path() / "file"));
  CHECK_FALSE(find_rescued(folder.path() / "none"));
}
