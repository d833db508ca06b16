// With nothing open: how one comes there, by hand and from the command line, and that nothing can be asked then.
#include "app/files/export.h"
#include "app/script/command_line.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using test_support::contains;
using test_support::example_session;
using test_support::is_one_sentence;

TEST_CASE("closing the mesh puts away all that belongs to it, and another can be opened") {
  Session session = example_session("sphere");
  apply(session, ToLast{});
  apply(session, PinRun{});
  apply(session, Select{knit::VertexElement{3}});
  apply(session, SetPredicting{true});
  const Preferences preferences = session.program->preferences;
  apply(session, CloseMesh{});
  CHECK_FALSE(session.document);
  CHECK_FALSE(session.learning->prediction);
  CHECK(session.outbox->notices.empty());
  CHECK(session.program->preferences.recent == preferences.recent);  // so that it is one click away
  REQUIRE(!session.program->preferences.recent.empty());
  // With nothing open these do nothing, and exports say so.
  for (const Action& action : Actions{CloseMesh{}, ToLast{}, PassTime{0.1}, Undo{}, GoBack{}, FrameAll{}})
    apply(session, action);
  const auto refused = export_to_file(session, {"mesh", "knit.obj"});
  REQUIRE(refused);
  CHECK(refused->find("nothing is open") != std::string::npos);
  apply(session, OpenExample{"sphere"});
  CHECK(session.document);
}

TEST_CASE("closing the mesh leaves a lesson too") {
  Session session = example_session("sphere");
  apply(session, StartLesson{"what-it-does"});
  REQUIRE(session.learning->lesson);
  apply(session, CloseMesh{});
  CHECK_FALSE(session.learning->lesson);
  CHECK_FALSE(session.document);
}

TEST_CASE("with --empty nothing is opened, and nothing can be asked of it") {
  const auto parsed =
      parse_command_line({"--empty", "--headless", "--screenshot", "start.png"}, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<CommandLine>(parsed));
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  CHECK_FALSE(open_as_asked(session, std::get<CommandLine>(parsed)));
  CHECK_FALSE(session.document);
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"mesh.obj"},
                                             {"--example", "sphere"},
                                             {"--epsilon", "0.1"},
                                             {"--preset", "thesis"},
                                             {"--at", "3"},
                                             {"--why", "vertex:3"},
                                             {"--lesson", "what-it-does"},
                                             {"--save-mesh", "knit.obj"}}) {
    CAPTURE(more);
    std::vector<std::string> words{"--empty"};
    words.insert(words.end(), more.begin(), more.end());
    const auto refused = parse_command_line(words, KNIT_ASSETS_DIR);
    REQUIRE(std::holds_alternative<Answer>(refused));
    const Answer& answer = std::get<Answer>(refused);
    CHECK(answer.exit_code == exit_usage);
    CHECK(contains(answer.error, "--empty opens nothing"));
    CHECK(is_one_sentence(answer.error));
  }
}
