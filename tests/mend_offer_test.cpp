// The offer of mends in the program: made where they would do, shown, taken with one click and undone with one; saved
// with the session, and said by the command line.
#include <tuple>

#include "app/actions/show_session.h"
#include "app/files/link.h"
#include "app/files/report.h"
#include "app/files/session_file.h"
#include "app/script/command_line.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "tests/support/corpus.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;
using test_support::contains;
using test_support::Folder;
using test_support::is_one_sentence;

namespace {

std::filesystem::path bad_file(const Folder& folder, const std::string& name) {
  for (const corpus::Case& file : corpus::all_cases())
    if (file.name == name) return corpus::write(file, folder.path());
  FAIL("no case " << name);
  return {};
}

std::variant<CommandLine, Answer> parsed(const std::vector<std::string>& words) {
  return parse_command_line(words, KNIT_ASSETS_DIR);
}

// Opened as on the command line; the error, or nothing.
std::optional<std::string> open_with(Session& session, const std::vector<std::string>& words) {
  const auto line = parsed(words);
  REQUIRE(std::holds_alternative<CommandLine>(line));
  session.program->assets = KNIT_ASSETS_DIR;
  return open_as_asked(session, std::get<CommandLine>(line));
}

std::string usage_error(const std::vector<std::string>& words) {
  const auto answer = parsed(words);
  REQUIRE(std::holds_alternative<Answer>(answer));
  CHECK(std::get<Answer>(answer).exit_code == exit_usage);
  return std::get<Answer>(answer).error;
}

std::string saved(const Session& session) { return session_text(session, "-").text; }

}  // namespace

TEST_CASE("mends are offered where they would do and what is open stays") {
  const Folder folder;
  Session session = test_support::example_session("sphere");
  apply(session, SeekTo{500});
  const std::string before = saved(session);
  apply(session, OpenFile{bad_file(folder, "two-pieces.obj")});
  REQUIRE(session.jobs->mend_offer);
  CHECK(contains(session.jobs->mend_offer->finding, "2 pieces"));
  REQUIRE(session.jobs->mend_offer->plan->steps.size() == 1);
  CHECK(session.outbox->notices.empty());
  CHECK(saved(session) == before);
  apply(session, DropMendOffer{});
  CHECK_FALSE(session.jobs->mend_offer);
  CHECK(saved(session) == before);

  apply(session, OpenFile{bad_file(folder, "two-pieces.obj")});
  apply(session, OpenFile{bad_file(folder, "open-bowl.obj")});  // no mends would do
  CHECK_FALSE(session.jobs->mend_offer);
  REQUIRE(session.outbox->notices.size() == 1);
  apply(session, OpenFile{bad_file(folder, "two-pieces.obj")});
  apply(session, OpenExample{"egg"});  // opened something else
  CHECK_FALSE(session.jobs->mend_offer);
}

TEST_CASE("mends are carried out with one click and undone with one") {
  const Folder folder;
  Session session = test_support::example_session("sphere");
  apply(session, SeekTo{500});
  const std::string before = saved(session);
  const std::uint64_t state = hash_of(session.document->timeline.state());
  const auto path = bad_file(folder, "two-holes-and-a-flipped-face.obj");
  apply(session, OpenFile{path});
  apply(session, MendAndOpen{});
  CHECK(session.document->source.file == path);
  CHECK(session.document->source.mends == std::vector{knit::MendKind::reorient, knit::MendKind::holes});
  CHECK(session.document->timeline.input().mesh.triangles.size() == 528);
  CHECK(session.document->findings.empty());
  CHECK(session.view->list == RunList::problems);
  REQUIRE(session.outbox->notices.size() == 2);
  CHECK(session.outbox->notices[0].kind == Notice::Kind::info);
  CHECK(session.outbox->notices[0].text == session.document->mended[0].did);
  CHECK(contains(session.outbox->notices[1].text, "filled 2 holes of 7 edges with 3 triangles"));
  CHECK(report_json(session)["mesh"]["mended"].size() == 2);
  apply(session, ToLast{});
  CHECK(session.document->timeline.state().finished());

  apply(session, SetTheme{ThemeKind::light});
  apply(session, UndoMend{});
  CHECK(saved(session) == before);
  CHECK(hash_of(session.document->timeline.state()) == state);
  CHECK(session.program->preferences.theme == ThemeKind::light);  // what was set for the program stays
  CHECK(session.document->mended.empty());
  CHECK_FALSE(session.document->before_mend);
  REQUIRE(session.jobs->mend_offer);  // as it was before the click
  apply(session, MendAndOpen{});
  CHECK(session.document->source.file == path);
}

TEST_CASE("mends undone leave alone what was begun and asked for meanwhile") {
  const Folder folder;
  Session session = test_support::example_session("sphere");
  const SaveAnimation wish{folder.path() / "a.gif", {0, 0}, 1, 10.0, 64, 64, false};
  const auto open_mended = [&] {
    apply(session, OpenFile{bad_file(folder, "fin.obj")});
    apply(session, MendAndOpen{});
  };
  SECTION("an animation that is done is not begun again") {
    apply(session, wish);
    REQUIRE(session.jobs->animation);
    open_mended();
    CHECK(session.jobs->animation);  // it goes on
    apply(session, CancelAnimation{});
    apply(session, UndoMend{});
    CHECK_FALSE(session.jobs->animation);
  }
  SECTION("one in the making goes on") {
    open_mended();
    apply(session, wish);
    REQUIRE(session.jobs->animation);
    apply(session, UndoMend{});
    CHECK(session.jobs->animation);
  }
  SECTION("what was learned stays") {
    open_mended();
    apply(session, SetPredicting{true});
    apply(session, UndoMend{});
    CHECK(session.learning->prediction);
  }
  CHECK(session.document->source.example == "sphere");
}

TEST_CASE("mends undone with nothing open before leave nothing open") {
  const Folder folder;
  Session session;
  apply(session, OpenFile{bad_file(folder, "fin.obj")});
  apply(session, MendAndOpen{});
  REQUIRE(session.document);
  apply(session, UndoMend{});
  CHECK_FALSE(session.document);
  apply(session, DropMendOffer{});
  apply(session, MendAndOpen{});
  apply(session, UndoMend{});
  CHECK_FALSE(session.document);
}

TEST_CASE("mends are undone no more once something else is open") {
  const Folder folder;
  Session session = test_support::example_session("sphere");
  apply(session, OpenFile{bad_file(folder, "fin.obj")});
  apply(session, MendAndOpen{});
  apply(session, OpenExample{"egg"});
  CHECK_FALSE(session.document->before_mend);
  CHECK(session.document->mended.empty());
  CHECK(session.document->source.mends.empty());
  apply(session, UndoMend{});
  CHECK(session.document->source.example == "egg");
}

TEST_CASE("mends are saved with the session and carried out when it is opened") {
  const Folder folder;
  const auto path = bad_file(folder, "two-holes-and-a-flipped-face.obj");
  Session session;
  apply(session, OpenFile{path});
  apply(session, MendAndOpen{});
  apply(session, SeekPlace{{knit::Stage::rows, 5, 2}});
  const auto file = folder.path() / "ball.json";
  REQUIRE_FALSE(save_session(session, file));
  CHECK(contains(test_support::read_text(file), "\"mends\": [\n      \"reorient\",\n      \"holes\"\n    ]"));
  Session again;
  REQUIRE_FALSE(open_session(again, file));
  CHECK(again.document->mended.size() == 2);
  CHECK(again.document->source.mends == session.document->source.mends);
  CHECK(saved(again) == saved(session));
  CHECK(hash_of(again.document->timeline.state()) == hash_of(session.document->timeline.state()));
  // Welding on the way is of the mended mesh.
  knit::Parameters parameters = again.document->timeline.parameters();
  parameters.mesh.weld = knit::Weld::on;
  apply(again, Tune{parameters});
  CHECK(again.document->timeline.input().mesh.triangles.size() == 528);

  std::string text = test_support::read_text(file);
  text.replace(text.find("\"holes\""), 7, "\"darning\"");
  test_support::write_text(file, text);
  const auto error = open_session(again, file);
  REQUIRE(error);
  CHECK(contains(*error, "mends"));
  CHECK(is_one_sentence(*error));
}

TEST_CASE("mends by the command line") {
  const Folder folder;
  const std::string path = bad_file(folder, "two-pieces.obj").string();
  {
    Session session;
    const auto error = open_with(session, {path, "--headless"});
    REQUIRE(error);
    CHECK(contains(*error, "2 pieces"));
    CHECK(contains(*error, "--mend largest-piece"));
    CHECK(contains(*error, "drops 1 piece of 4 triangles"));
    CHECK(is_one_sentence(*error));
  }
  {
    Session session;  // a window shows the offer
    CHECK_FALSE(open_with(session, {path}));
    CHECK(session.jobs->mend_offer);
    CHECK_FALSE(session.document);
  }
  for (const char* wish : {"all", "largest-piece", "holes,largest-piece,holes"}) {
    CAPTURE(wish);
    Session session;
    CHECK_FALSE(open_with(session, {path, "--headless", "--mend", wish}));
    REQUIRE(session.document);
    CHECK(session.document->source.mends == std::vector{knit::MendKind::largest_piece});
    CHECK(contains(session.outbox->notices.at(0).text, "dropped 1 piece of 4 triangles"));
    // What was asked for and not needed is said too.
    CHECK(session.outbox->notices.size() == (contains(wish, "holes") ? 2 : 1));
    const auto link = link_by_options(session);
    REQUIRE(link);
    CHECK(contains(*link, " --mend largest-piece "));
  }
  Session session;
  CHECK(open_with(session, {path, "--headless", "--mend", "holes"}));
  CHECK_FALSE(session.document);
}

TEST_CASE("mends that cannot be asked for") {
  CHECK(contains(usage_error({"ball.obj", "--mend", "darn"}), "largest-piece"));
  CHECK(contains(usage_error({"ball.obj", "--mend", "holes,"}), "--mend cannot be"));
  CHECK(contains(usage_error({"--example", "egg", "--mend", "all"}), "needs a mesh's file"));
  CHECK(contains(usage_error({"--session", "a.json", "--mend", "all"}), "needs a mesh's file"));
  CHECK(contains(usage_error({"ball.obj", "--mend", ""}), "--mend"));
}

TEST_CASE("mends have a card with what is wrong and what each would do") {
  const Folder folder;
  {
    Desk empty;  // the welcome gives way
    apply(empty.session, OpenFile{bad_file(folder, "fin.obj")});
    empty.settle();
    CHECK(empty.ui.controls.count("mend/open") == 1);
    CHECK(empty.ui.controls.count("welcome/open") == 0);
  }
  Desk desk;
  desk.open();
  apply(desk.session, OpenFile{bad_file(folder, "two-holes-and-a-flipped-face.obj")});
  desk.settle();
  only<DropMendOffer>(desk.click("mend/not-now"));
  desk.act(desk.click("mend/open"));
  CHECK(desk.session.document->source.mends.size() == 2);
  desk.settle();
  CHECK(desk.ui.controls.count("mend/open") == 0);
  REQUIRE(desk.ui.controls.count("problem/1") == 1);  // both are in the list
  only<UndoMend>(desk.click("mend/undo-here"));
  desk.act(desk.click("mend/undo"));
  desk.settle();
  CHECK(desk.session.document->source.mends.empty());
  CHECK(desk.ui.controls.count("mend/undo") == 0);
}

TEST_CASE("mends are offered in the list for what is only warned of too") {
  const Folder folder;
  for (const auto& [name, control, kind] :
       {std::tuple{"stray-vertex.obj", "mend/unreferenced", knit::MendKind::unreferenced},
        std::tuple{"flipped-face.obj", "mend/reorient", knit::MendKind::reorient},
        std::tuple{"inside-out.obj", "mend/reorient", knit::MendKind::reorient}}) {
    CAPTURE(name);
    Desk desk;
    apply(desk.session, OpenFile{bad_file(folder, name)});
    REQUIRE(desk.session.document->findings.size() == 1);
    CHECK_FALSE(desk.session.document->before_mend);
    desk.session.view->list = RunList::problems;
    apply(desk.session, SeekTo{20});
    desk.settle();
    desk.act(desk.click(control));
    CHECK(desk.session.document->findings.empty());
    CHECK(desk.session.document->source.mends == std::vector{kind});
    desk.settle();
    desk.act(desk.click("mend/undo-here"));
    CHECK(desk.session.document->findings.size() == 1);
    CHECK(desk.session.document->source.mends.empty());
    CHECK(desk.session.document->timeline.position() == 20);
  }
}
