// The copied command line opens exactly the state it was copied from.
#include "app/files/link.h"

#include <algorithm>

#include "app/actions/navigate.h"
#include "app/files/session_file.h"
#include "app/script/command_line.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;

namespace {

void tune(Session& session, const char* key, const std::string& value) {
  knit::Parameters parameters = session.document->timeline.parameters();
  REQUIRE_FALSE(knit::set_value(*knit::find_parameter(key), parameters, value));
  apply(session, Tune{parameters});
}

// As a shell would take it apart: words, and single quotes.
std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\'') {
      quoted = !quoted;
    } else if (line[i] == '\\' && !quoted) {
      words.back() += line[++i];
    } else if (line[i] == ' ' && !quoted) {
      words.emplace_back();
    } else {
      words.back() += line[i];
    }
  }
  return words;
}

std::string copied(Session& session) {
  session.outbox->clipboard.reset();
  const std::size_t told = session.outbox->notices.size();
  apply(session, CopyLink{});
  for (std::size_t i = told; i < session.outbox->notices.size(); ++i)
    UNSCOPED_INFO(session.outbox->notices[i].text);
  return session.outbox->clipboard.value_or("");
}

Session opened_by(const std::string& link) {
  CAPTURE(link);
  std::vector<std::string> words = words_of(link);
  REQUIRE(words.front() == "knit-mesh");
  words.erase(words.begin());
  const auto parsed = parse_command_line(words, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<CommandLine>(parsed));
  const auto& line = std::get<CommandLine>(parsed);
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  CHECK(open_as_asked(session, line) == std::nullopt);
  REQUIRE(session.document);
  if (line.at) CHECK(go_to(session, *line.at) == std::nullopt);
  return session;
}

void check_same(const Session& session, const Session& other) {
  CHECK(knobs_of(other.document->timeline) == knobs_of(session.document->timeline));
  CHECK(other.document->timeline.position() == session.document->timeline.position());
  CHECK(knit::hash_of(other.document->timeline.state()) == knit::hash_of(session.document->timeline.state()));
  CHECK(other.view->side == session.view->side);
  CHECK(other.view->centre == session.view->centre);
}

}  // namespace

TEST_CASE("a link by options opens the same state at the same position") {
  struct Change {
    const char *key, *value;
  };
  const std::vector<std::vector<Change>> lists{
      {},
      {{"epsilon", "0.0613"}},
      {{"stitch-width", "0.1300001"}},
      {{"gauge", "19,27"}},
      {{"gauge", "19.3,27"}, {"height-cm", "17"}, {"axis", "-1,0.2,0.1"}},
      {{"close", "thesis"}, {"placement", "nearest"}, {"stacking-penalty", "0.25"}},
      {{"weld", "on"}, {"start-direction", "-1,0,0"}},
      {{"rows", "contours"}, {"stitch-height", "0.09"}, {"timing", "arc-length"}},
  };
  for (const char* example : {"sphere", "thesis-sphere"}) {
    for (const auto& list : lists) {
      Session session = example_session(example);
      for (const Change& change : list) tune(session, change.key, change.value);
      for (const knit::Place& place :
           {knit::Place{knit::Stage::rows, 9, 4}, knit::Place{knit::Stage::timing, 0, 3}}) {
        apply(session, SeekPlace{place});
        const std::string link = copied(session);
        CAPTURE(link);
        CHECK(contains(link, "--example " + std::string(example)));
        check_same(session, opened_by(link));
      }
    }
  }
}

TEST_CASE("a link says what is shown, and quotes what a shell would take apart") {
  const Folder folder;
  const auto mesh = folder.path() / "it's a $ball & more.obj";
  std::filesystem::copy_file(std::filesystem::path(KNIT_ASSETS_DIR) / "sphere" / "mesh.obj", mesh);
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  apply(session, OpenFile{mesh});
  REQUIRE(session.document);
  apply(session, ShowSide{SidePanel::report});
  apply(session, ShowCentre{CentrePanel::chart});
  apply(session, KnitAlong{5});
  knit::PatternOptions options;
  options.title = "- a \"b\" 'c' $(d) -";
  options.needle_mm = 3.5;
  options.markers = true;
  apply(session, SetPatternOptions{options});
  YarnLook look;
  look.by = YarnColours::label;
  look.wool = {1, 2, 3};
  look.second = {4, 5, 6};
  look.stripe_rounds = 3;
  look.radius = 0.11;
  look.easing = 30;
  apply(session, SetYarnLook{look});
  apply(session, SetLayer{Layer::yarn, true});
  apply(session, SetLayer{Layer::faces, false});
  const std::string link = copied(session);
  CHECK(contains(link, "--at 0"));
  const Session other = opened_by(link);
  CHECK(other.view->yarn == look);
  CHECK(other.view->layers == session.view->layers);
  check_same(session, other);
  CHECK(other.view->gaze.knit_along == 5);
  CHECK(other.view->pattern.title == options.title);
  CHECK(other.view->pattern.needle_mm == 3.5);
  CHECK(other.view->pattern.markers);
  CHECK(shell_quoted("") == "''");
  CHECK(shell_quoted("a'b") == "'a'\\''b'");
  CHECK(shell_quoted("--at=rows:1:2") == "--at=rows:1:2");
}

TEST_CASE("a link says where one knits along as the pattern counts, short rows too") {
  Session session = example_session("heel");
  session.document->timeline.extend_to_end();
  const auto rows = session.document->timeline.furthest().fabric.rows();
  const auto turned =
      std::find_if(rows.begin(), rows.end(), [](const auto& row) { return knit::is_short(*row); });
  REQUIRE(turned != rows.end());
  const knit::RowId short_row = (*turned)->id;  // the rows before it are rounds
  apply(session, KnitAlong{short_row});
  const std::string link = copied(session);
  CHECK(contains(link, "--knit-along " + std::to_string(short_row - 1) + ".1"));
  CHECK(opened_by(link).view->gaze.knit_along == short_row);

  // A round that short rows came before has a smaller number than its row.
  const auto round = std::find_if(turned, rows.end(), [](const auto& row) { return !knit::is_short(*row); });
  REQUIRE(round != rows.end());
  apply(session, KnitAlong{(*round)->id});
  const std::string other = copied(session);
  CHECK(contains(other, "--knit-along " + std::to_string(short_row)));
  CHECK_FALSE(contains(other, std::to_string(short_row) + "."));
  CHECK(opened_by(other).view->gaze.knit_along == (*round)->id);
}

TEST_CASE("with edits the link names the session file, while that says what is shown") {
  const Folder folder;
  Session session = example_session("sphere");
  apply(session, SeekPlace{{knit::Stage::rows, 9, 4}});
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.rows.close =
      parameters.rows.close == knit::Closing::arc ? knit::Closing::thesis : knit::Closing::arc;
  apply(session, EditFromHere{parameters});
  CHECK(copied(session) == "");
  REQUIRE_FALSE(session.outbox->notices.empty());
  CHECK(contains(session.outbox->notices.back().text, "save the session first"));

  const auto path = folder.path() / "my session.json";
  apply(session, Export{"session", path});
  const std::string link = copied(session);
  CHECK(link == "knit-mesh --session '" + path.string() + "'");
  Session other = opened_by(link);
  check_same(session, other);
  CHECK(other.view->gaze.camera == session.view->gaze.camera);
  CHECK(copied(other) == link);

  apply(session, Orbit{0.3, 0.0});
  CHECK(copied(session) == "");
  apply(session, Orbit{-0.3, 0.0});
  std::filesystem::remove(path);
  CHECK(copied(session) == "");
}

TEST_CASE("a parameter, a place and a side beside --session go over what it says") {
  const Folder folder;
  Session session = example_session("sphere");
  apply(session, SeekPlace{{knit::Stage::rows, 9, 4}});
  apply(session, ShowSide{SidePanel::report});
  const auto path = (folder.path() / "s.json").string();
  REQUIRE_FALSE(save_session(session, path));
  const Session plain = opened_by("knit-mesh " + path);
  check_same(session, plain);
  const Session tuned = opened_by("knit-mesh --session " + path + " --close none --at rows:5:2 --side step");
  CHECK(tuned.document->timeline.base_parameters().rows.close == knit::Closing::none);
  CHECK(tuned.document->timeline.place() == knit::Place{knit::Stage::rows, 5, 1});
  CHECK(tuned.view->side == SidePanel::step);
  CHECK(tuned.document->changes.undo.empty());
  const auto both = parse_command_line({"--session", path, "--example", "sphere"}, KNIT_ASSETS_DIR);
  CHECK(std::holds_alternative<Answer>(both));
}
