// What is wrong with a file beside its bytes: it is no file, may not be read, is gone, or is far too large.
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>

#include "app/session/action.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;
namespace fs = std::filesystem;

namespace {

// A person without rights, for as long as it lives; root may read everything.
class Nobody {
 public:
  Nobody() : root_(::geteuid() == 0) {
    if (root_) REQUIRE(::seteuid(65534) == 0);
  }
  ~Nobody() {
    if (root_ && ::seteuid(0) != 0) std::abort();
  }
  Nobody(const Nobody&) = delete;
  Nobody& operator=(const Nobody&) = delete;

 private:
  bool root_;
};

// Nothing opens, and it is said in one sentence with these words; quickly.
void check_refused(const fs::path& path, const std::vector<std::string>& words) {
  Session session = small_session();
  apply(session, SeekTo{300});
  const std::uint64_t state = hash_of(session.document->timeline.state());
  const knit::Parameters parameters = session.document->timeline.parameters();
  const auto start = std::chrono::steady_clock::now();
  apply(session, OpenFile{path});
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
  REQUIRE(session.outbox->notices.size() == 1);
  const std::string& sentence = session.outbox->notices[0].text;
  CAPTURE(sentence);
  CHECK(is_one_sentence(sentence));
  for (const std::string& word : words) {
    CAPTURE(word);
    CHECK(contains(sentence, word));
  }
  CHECK(session.document->timeline.position() == 300);
  CHECK(hash_of(session.document->timeline.state()) == state);
  CHECK(session.document->timeline.parameters() == parameters);
  CHECK(session.document->source.file.empty());
  CHECK_FALSE(session.jobs->repair_offer);
}

}  // namespace

TEST_CASE("corpus: what is no file is not waited for", "[corpus]") {
  const Folder folder;
  const fs::path pipe = folder.path() / "pipe.obj";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  check_refused(pipe, {"pipe.obj", "is no ordinary file", "Save the mesh to a file"});
  check_refused("/dev/zero", {"is no ordinary file"});
  fs::create_directory(folder.path() / "folder.obj");
  check_refused(folder.path() / "folder.obj", {"is a folder", "Name an OBJ file"});
  fs::create_symlink("round.obj", folder.path() / "round.obj");
  check_refused(folder.path() / "round.obj", {"cannot be reached", "Check"});
}

TEST_CASE("corpus: a file that may not be read", "[corpus]") {
  const Folder folder;
  fs::permissions(folder.path(), fs::perms::all);
  const fs::path path = folder.path() / "locked.obj";
  write_text(path, corpus::obj_of(corpus::ball()));
  fs::permissions(path, fs::perms::none);
  const fs::path closed = folder.path() / "closed";
  fs::create_directory(closed);
  write_text(closed / "ball.obj", corpus::obj_of(corpus::ball()));
  fs::permissions(closed, fs::perms::none);
  {
    const Nobody nobody;
    check_refused(path, {"locked.obj", "cannot be opened", "Permission denied", "permissions"});
    check_refused(closed / "ball.obj", {"cannot be reached", "Permission denied", "permissions"});
  }
  fs::permissions(closed, fs::perms::all);
}

TEST_CASE("corpus: a file that is not there or has gone", "[corpus]") {
  const Folder folder;
  check_refused(folder.path() / "never.obj", {"never.obj does not exist", "Check"});
  fs::create_symlink("nowhere.obj", folder.path() / "dangling.obj");
  check_refused(folder.path() / "dangling.obj", {"dangling.obj does not exist"});

  const fs::path path = folder.path() / "ball.obj";
  write_text(path, corpus::obj_of(corpus::ball()));
  Session session;
  apply(session, OpenFile{path});
  REQUIRE(session.document);
  fs::remove(path);
  check_refused(path, {"ball.obj does not exist"});
  // What is open needs its file no more: welding takes the mesh as it was read.
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.mesh.weld = knit::Weld::on;
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  CHECK(session.document->timeline.state().finished());
  CHECK(session.outbox->notices.empty());
}

TEST_CASE("corpus: a file of two gigabytes is refused before it is read", "[corpus]") {
  const Folder folder;
  const fs::path path = folder.path() / "huge.obj";
  write_text(path, "v 0 0 0\n");
  fs::resize_file(path, std::uintmax_t{1} << 31);  // takes no room on the disk
  const auto start = std::chrono::steady_clock::now();
  check_refused(path, {"huge.obj", "2.1 GB", "at most 1 GB", "Reduce the mesh"});
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
}

TEST_CASE("corpus: a name cannot break the sentence", "[corpus]") {
  const Folder folder;
  check_refused(folder.path() / "two\nlines\x1b[31m.obj", {"two", "lines", "does not exist"});
  const fs::path path = folder.path() / "two\nlines.obj";
  write_text(path, "v 0 0\n");
  check_refused(path, {"lines.obj", "line 1", "three coordinates"});
  write_text(path, "v 0 0 0\n");
  check_refused(path, {"no faces"});
}
