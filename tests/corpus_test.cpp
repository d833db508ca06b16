// Every bad file ends in one sentence that says what is wrong and what to do, with the session as it was; every odd
// but good one opens as what it is. Through the real path: a file on disk, opened by the action.
#include <chrono>
#include <cstdlib>
#include <set>

#include "app/files/session_file.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;

namespace {

// All that a saved session says, and what it leaves out.
struct Seen {
  std::string saved;
  std::uint64_t state = 0;
  std::size_t known = 0, notices = 0;
  const void* input = nullptr;
  std::vector<std::string> recent;
  friend bool operator==(const Seen&, const Seen&) = default;
};

Seen seen(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  return {session_text(session, "-").text,
          hash_of(timeline.state()),
          timeline.known(),
          session.outbox->notices.size(),
          &session.document->timeline.input(),
          session.program->preferences.recent};
}

Session session_under_way() {
  Session session = example_session("sphere");
  apply(session, SeekTo{700});
  return session;
}

// The one sentence that a refused opening ends in, taken away again; else empty.
std::string take_sentence(Session& session, std::size_t notices_before) {
  std::string sentence;
  if (session.jobs->repair_offer) sentence = session.jobs->repair_offer->finding;
  if (session.outbox->notices.size() == notices_before + 1) {
    CHECK(sentence.empty());
    CHECK(session.outbox->notices.back().kind == Notice::Kind::error);
    sentence = session.outbox->notices.back().text;
    session.outbox->notices.pop_back();
  }
  apply(session, DropRepairOffer{});
  return sentence;
}

void check_refused(Session& session, const std::filesystem::path& path,
                   const std::vector<std::string>& words) {
  const Seen before = seen(session);
  apply(session, OpenFile{path});
  const std::string sentence = take_sentence(session, before.notices);
  CAPTURE(sentence);
  CHECK(is_one_sentence(sentence));
  // Which file, by its name or its stem.
  CHECK(contains(sentence, path.stem().string().substr(0, 4)));
  for (const std::string& word : words) {
    CAPTURE(word);
    CHECK(contains(sentence, word));
  }
  CHECK((seen(session) == before));
}

void check_opened(const std::filesystem::path& path, const corpus::Opens& as) {
  Session session;
  apply(session, OpenFile{path});
  if (!session.document) FAIL(take_sentence(session, 0));
  CHECK(session.document->source.file == path);
  CHECK(session.document->original->positions.size() == as.vertices);
  CHECK(session.document->original->triangles.size() == as.triangles);
  REQUIRE(session.document->findings.size() == as.warnings.size());
  REQUIRE(session.outbox->notices.size() == as.warnings.size());
  for (std::size_t i = 0; i < as.warnings.size(); ++i) {
    CAPTURE(session.outbox->notices[i].text);
    CHECK(is_one_sentence(session.outbox->notices[i].text));
    CHECK(contains(session.outbox->notices[i].text, as.warnings[i]));
  }
}

std::vector<int> sizes_of_run(const knit::Mesh& mesh) {
  const Folder folder;
  write_text(folder.path() / "ball.obj", corpus::obj_of(mesh));
  Session session;
  apply(session, OpenFile{folder.path() / "ball.obj"});
  REQUIRE(session.document);
  apply(session, ToLast{});
  REQUIRE(session.document->timeline.complete());
  INFO(sentence(session));
  CHECK(session.document->timeline.stop() == nullptr);
  return row_sizes(session.document->timeline.state());
}

}  // namespace

TEST_CASE("corpus: every file opens as what it is or is refused in a sentence that helps", "[corpus]") {
  const Folder folder;
  Session session = session_under_way();
  std::size_t opened = 0;
  std::size_t refused = 0;
  for (const corpus::Case& file : corpus::all_cases()) {
    CAPTURE(file.name);
    const std::filesystem::path path = corpus::write(file, folder.path());
    const auto start = std::chrono::steady_clock::now();
    if (file.opens) {
      check_opened(path, file.opened);
    } else {
      check_refused(session, path, file.refused.words);
    }
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
    ++(file.opens ? opened : refused);
  }
  CHECK(opened >= 25);
  CHECK(refused >= 50);
}

TEST_CASE("corpus: the same bytes each time and no name twice", "[corpus]") {
  const auto once = corpus::all_cases();
  const auto again = corpus::all_cases();
  std::set<std::string> names;
  REQUIRE(once.size() == again.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    CAPTURE(once[i].name);
    CHECK(once[i].bytes() == again[i].bytes());
    CHECK(names.insert(once[i].name).second);
    CHECK((once[i].opens || !once[i].refused.words.empty()));
  }
}

TEST_CASE("corpus: what a mesh is measured in and where it lies change no count", "[corpus]") {
  const std::vector<int> plain = sizes_of_run(corpus::ball());
  REQUIRE(plain.size() > 10);
  for (const double scale : {1e-9, 1e-3, 1e9}) {
    CAPTURE(scale);
    CHECK(sizes_of_run(corpus::moved(corpus::ball(), scale, 0)) == plain);
  }
  for (const double by : {1e3, 1e6}) {
    CAPTURE(by);
    CHECK(sizes_of_run(corpus::moved(corpus::ball(), 1, by)) == plain);
  }
}

// KNIT_CORPUS=FOLDER knit_tests "[corpus-files]": for a look at the files, and as seeds for fuzzing.
TEST_CASE("corpus: written to the folder that KNIT_CORPUS names", "[.][corpus-files]") {
  const char* folder = std::getenv("KNIT_CORPUS");
  REQUIRE(folder != nullptr);
  std::filesystem::create_directories(folder);
  for (const corpus::Case& file : corpus::all_cases()) corpus::write(file, folder);
}
