// The offer of repairs in the program: made where they would do, shown, taken with one click and undone with one; saved
// with the session, and said by the command line.
#include <tuple>

#include "app/files/link.h"
#include "app/files/load.h"
#include "app/files/report.h"
#include "app/files/session_file.h"
#include "app/script/command_line.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/model/words.h"
#include "tests/support/corpus.h"
#include "tests/support/desk.h"
#include "tests/support/open_session.h"
#include "tests/support/session.h"

using namespace desk;
using test_support::contains;
using test_support::Folder;
using test_support::is_one_sentence;
using test_support::open_session;

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

TEST_CASE("repairs are offered where they would do and what is open stays") {
  const Folder folder;
  Session session = test_support::example_session("sphere");
  apply(session, SeekTo{500});
  const std::string before = saved(session);
  apply(session, OpenFile{bad_file(folder, "two-pieces.obj")});
  REQUIRE(session.jobs->repair_offer);
  CHECK(contains(session.jobs->repair_offer->finding, "2 pieces"));
  REQUIRE(session.jobs->repair_offer->plan->steps.size() == 1);
  CHECK(session.outbox->notices.empty());
  CHECK(saved(session) == before);
  apply(session, DropRepairOffer{});
  CHECK_FALSE(session.jobs->repair_offer);
  CHECK(saved(session) == before);

  apply(session, OpenFile{bad_file(folder, "two-pieces.obj")});
  apply(session, OpenFile{bad_file(folder, "moebius-strip.obj")});  // no repairs would do
  CHECK_FALSE(session.jobs->repair_offer);
  REQUIRE(session.outbox->notices.size() == 1);
  apply(session, OpenFile{bad_file(folder, "two-pieces.obj")});
  apply(session, OpenExample{"egg"});  // opened something else
  CHECK_FALSE(session.jobs->repair_offer);
}

TEST_CASE("repairs are carried out with one click and undone with one") {
  const Folder folder;
  Session session = test_support::example_session("sphere");
  apply(session, SeekTo{500});
  const std::string before = saved(session);
  const std::uint64_t state = hash_of(session.document->timeline.state());
  const auto path = bad_file(folder, "two-holes-and-a-flipped-face.obj");
  apply(session, OpenFile{path});
  apply(session, RepairAndOpen{});
  CHECK(session.document->source.file == path);
  CHECK(session.document->source.repairs == std::vector{knit::RepairKind::reorient, knit::RepairKind::holes});
  CHECK(session.document->timeline.input().mesh.triangles.size() == 528);
  CHECK(session.document->findings.empty());
  CHECK(session.view->list == RunList::problems);
  REQUIRE(session.outbox->notices.size() == 2);
  CHECK(session.outbox->notices[0].kind == Notice::Kind::info);
  CHECK(session.outbox->notices[0].text == session.document->repaired[0].did);
  CHECK(contains(session.outbox->notices[1].text, "filled 2 holes of 7 edges with 3 triangles"));
  CHECK(report_json(session)["mesh"]["mended"].size() == 2);
  apply(session, ToLast{});
  CHECK(session.document->timeline.state().finished());

  apply(session, SetTheme{ThemeKind::light});
  apply(session, UndoRepair{});
  CHECK(saved(session) == before);
  CHECK(hash_of(session.document->timeline.state()) == state);
  CHECK(session.program->preferences.theme == ThemeKind::light);  // what was set for the program stays
  CHECK(session.document->repaired.empty());
  CHECK_FALSE(session.document->before_repair);
  REQUIRE(session.jobs->repair_offer);  // as it was before the click
  apply(session, RepairAndOpen{});
  CHECK(session.document->source.file == path);
}

TEST_CASE("repairs undone leave alone what was begun and asked for meanwhile") {
  const Folder folder;
  Session session = test_support::example_session("sphere");
  const SaveAnimation wish{folder.path() / "a.gif", {0, 0}, 1, 10.0, 64, 64, false};
  const auto open_repaired = [&] {
    apply(session, OpenFile{bad_file(folder, "fin.obj")});
    apply(session, RepairAndOpen{});
  };
  SECTION("an animation that is done is not begun again") {
    apply(session, wish);
    REQUIRE(session.jobs->animation);
    open_repaired();
    CHECK(session.jobs->animation);  // it goes on
    apply(session, CancelAnimation{});
    apply(session, UndoRepair{});
    CHECK_FALSE(session.jobs->animation);
  }
  SECTION("one in the making goes on") {
    open_repaired();
    apply(session, wish);
    REQUIRE(session.jobs->animation);
    apply(session, UndoRepair{});
    CHECK(session.jobs->animation);
  }
  SECTION("what was learned stays") {
    open_repaired();
    apply(session, SetPredicting{true});
    apply(session, UndoRepair{});
    CHECK(session.learning->prediction);
  }
  CHECK(session.document->source.example == "sphere");
}

TEST_CASE("repairs undone with nothing open before leave nothing open") {
  const Folder folder;
  Session session;
  apply(session, OpenFile{bad_file(folder, "fin.obj")});
  apply(session, RepairAndOpen{});
  REQUIRE(session.document);
  apply(session, UndoRepair{});
  CHECK_FALSE(session.document);
  apply(session, DropRepairOffer{});
  apply(session, RepairAndOpen{});
  apply(session, UndoRepair{});
  CHECK_FALSE(session.document);
}

TEST_CASE("repairs are undone no more once something else is open") {
  const Folder folder;
  Session session = test_support::example_session("sphere");
  apply(session, OpenFile{bad_file(folder, "fin.obj")});
  apply(session, RepairAndOpen{});
  apply(session, OpenExample{"egg"});
  CHECK_FALSE(session.document->before_repair);
  CHECK(session.document->repaired.empty());
  CHECK(session.document->source.repairs.empty());
  apply(session, UndoRepair{});
  CHECK(session.document->source.example == "egg");
}

TEST_CASE("repairs are saved with the session and carried out when it is opened") {
  const Folder folder;
  const auto path = bad_file(folder, "two-holes-and-a-flipped-face.obj");
  Session session;
  apply(session, OpenFile{path});
  apply(session, RepairAndOpen{});
  apply(session, SeekPlace{{knit::Stage::rows, 5, 2}});
  const auto file = folder.path() / "ball.json";
  REQUIRE_FALSE(save_session(session, file));
  CHECK(contains(test_support::read_text(file), "\"mends\": [\n      \"reorient\",\n      \"holes\"\n    ]"));
  Session again;
  REQUIRE_FALSE(open_session(again, file));
  CHECK(again.document->repaired.size() == 2);
  CHECK(again.document->source.repairs == session.document->source.repairs);
  CHECK(saved(again) == saved(session));
  CHECK(hash_of(again.document->timeline.state()) == hash_of(session.document->timeline.state()));
  // Welding on the way is of the repaired mesh.
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

TEST_CASE("repairs by the command line") {
  const Folder folder;
  const std::string path = bad_file(folder, "two-pieces.obj").string();
  {
    Session session;
    const auto error = open_with(session, {path, "--headless"});
    REQUIRE(error);
    CHECK(contains(*error, "2 pieces"));
    CHECK(contains(*error, "--repair largest-piece"));
    CHECK(contains(*error, "drops 1 piece of 4 triangles"));
    CHECK(contains(*error, " % of the surface, 4 triangles."));
    CHECK(is_one_sentence(*error));
  }
  {
    Session session;  // a window shows the offer
    CHECK_FALSE(open_with(session, {path}));
    CHECK(session.jobs->repair_offer);
    CHECK_FALSE(session.document);
  }
  for (const char* wish : {"all", "largest-piece", "holes,largest-piece,holes"}) {
    CAPTURE(wish);
    Session session;
    CHECK_FALSE(open_with(session, {path, "--headless", "--repair", wish}));
    REQUIRE(session.document);
    CHECK(session.document->source.repairs == std::vector{knit::RepairKind::largest_piece});
    CHECK(contains(session.outbox->notices.at(0).text, "dropped 1 piece of 4 triangles"));
    // What was asked for and not needed is said too.
    CHECK(session.outbox->notices.size() == (contains(wish, "holes") ? 2 : 1));
    const auto link = link_by_options(session);
    REQUIRE(link);
    CHECK(contains(*link, " --repair largest-piece "));
  }
  Session session;
  CHECK(open_with(session, {path, "--headless", "--mend", "holes"}));  // the option's former name
  CHECK_FALSE(session.document);
}

TEST_CASE("repairs that cannot be asked for") {
  CHECK(contains(usage_error({"ball.obj", "--repair", "darn"}), "largest-piece"));
  CHECK(contains(usage_error({"ball.obj", "--repair", "holes,"}), "--repair cannot be"));
  CHECK(contains(usage_error({"--example", "egg", "--repair", "all"}), "needs a mesh's file"));
  CHECK(contains(usage_error({"--session", "a.json", "--repair", "all"}), "needs a mesh's file"));
  CHECK(contains(usage_error({"ball.obj", "--repair", ""}), "--repair"));
}

TEST_CASE("repairs have a card with what is wrong and what each would do") {
  const Folder folder;
  {
    Desk empty;  // the welcome gives way
    apply(empty.session, OpenFile{bad_file(folder, "fin.obj")});
    empty.settle();
    CHECK(empty.ui.controls.count("repair/open") == 1);
    CHECK(empty.ui.controls.count("welcome/open") == 0);
  }
  Desk desk;
  desk.open();
  apply(desk.session, OpenFile{bad_file(folder, "two-holes-and-a-flipped-face.obj")});
  desk.settle();
  only<DropRepairOffer>(desk.click("repair/not-now"));
  desk.act(desk.click("repair/open"));
  CHECK(desk.session.document->source.repairs.size() == 2);
  desk.settle();
  CHECK(desk.ui.controls.count("repair/open") == 0);
  REQUIRE(desk.ui.controls.count("problem/1") == 1);  // both are in the list
  only<UndoRepair>(desk.click("repair/undo-here"));
  desk.act(desk.click("repair/undo"));
  desk.settle();
  CHECK(desk.session.document->source.repairs.empty());
  CHECK(desk.ui.controls.count("repair/undo") == 0);
}

TEST_CASE("of several pieces any one may be opened, as by --piece") {
  const Folder folder;
  Desk desk;
  desk.open();
  apply(desk.session, OpenFile{bad_file(folder, "two-pieces.obj")});
  desk.settle();
  CHECK(desk.ui.controls.count("repair/piece-1") == 1);
  CHECK(desk.ui.controls.count("repair/piece-3") == 0);
  CHECK(desk.ui.controls.count("repair/piece-words-2") == 1);
  const knit::RepairPlan plan = *desk.session.jobs->repair_offer->plan;
  REQUIRE(plan.pieces.size() == 2);
  CHECK(plan.pieces[1].triangles == 4);
  CHECK(plan.pieces[0].share + plan.pieces[1].share == Approx(1.0));
  CHECK(piece_words(plan, 2) ==
        "Piece 2: " + knit::percent_text(plan.pieces[1].share) + " of the surface, 4 triangles");
  desk.act(desk.click("repair/piece-2"));
  REQUIRE(desk.session.document);
  CHECK(desk.session.document->source.repairs.front() == knit::keeping_piece(2));
  CHECK(desk.session.document->timeline.input().mesh.triangles.size() == 4);
}

TEST_CASE("an open edge can be closed flat by a click, and opened again") {
  const Folder folder;
  Desk desk;
  apply(desk.session, OpenFile{bad_file(folder, "open-bowl.obj")});
  REQUIRE(desk.session.document);
  CHECK(desk.session.document->timeline.input().rims.size() == 1);
  desk.session.view->list = RunList::problems;
  desk.settle();
  desk.act(desk.click("repair/openings"));
  CHECK(desk.session.document->timeline.input().rims.empty());
  CHECK(desk.session.document->source.repairs == std::vector{knit::RepairKind::openings});
  desk.settle();
  desk.act(desk.click("repair/undo-here"));
  CHECK(desk.session.document->timeline.input().rims.size() == 1);
}

TEST_CASE("repairs are offered in the list for what is only warned of too") {
  const Folder folder;
  for (const auto& [name, control, kind] :
       {std::tuple{"stray-vertex.obj", "repair/unreferenced", knit::RepairKind::unreferenced},
        std::tuple{"flipped-face.obj", "repair/reorient", knit::RepairKind::reorient},
        std::tuple{"inside-out.obj", "repair/reorient", knit::RepairKind::reorient}}) {
    CAPTURE(name);
    Desk desk;
    apply(desk.session, OpenFile{bad_file(folder, name)});
    REQUIRE(desk.session.document->findings.size() == 1);
    CHECK_FALSE(desk.session.document->before_repair);
    desk.session.view->list = RunList::problems;
    apply(desk.session, SeekTo{20});
    desk.settle();
    desk.act(desk.click(control));
    CHECK(desk.session.document->findings.empty());
    CHECK(desk.session.document->source.repairs == std::vector{kind});
    desk.settle();
    desk.act(desk.click("repair/undo-here"));
    CHECK(desk.session.document->findings.size() == 1);
    CHECK(desk.session.document->source.repairs.empty());
    CHECK(desk.session.document->timeline.position() == 20);
  }
}

TEST_CASE("repairs of what is only warned of stand with what was found at opening, and at a stop") {
  const Folder folder;
  Desk desk;
  apply(desk.session, OpenFile{bad_file(folder, "flipped-face.obj")});
  REQUIRE(desk.session.document->findings.size() == 1);
  desk.settle();
  CHECK(only<OpenFile>(desk.click("found/reorient")).repairs.kinds ==
        std::vector{knit::RepairKind::reorient});

  knit::Parameters parameters = desk.session.document->timeline.parameters();
  parameters.rows.source = knit::RowSource::rings;
  knit::give_epsilon(parameters, 1e-6);
  parameters.rows.on_stall = knit::OnStall::stop;
  apply(desk.session, Tune{parameters});
  apply(desk.session, ToLast{});
  REQUIRE(desk.session.document->timeline.stop() != nullptr);
  desk.session.outbox->notices.clear();
  desk.settle();
  desk.act(desk.click("stop/reorient"));
  CHECK(desk.session.document->findings.empty());
}

TEST_CASE("repairs of the teapot that people download are offered and it is knitted with them", "[shared]") {
  const std::filesystem::path file = std::filesystem::path(KNIT_SHARED_MESHES) / "teapot.obj";
  if (!std::filesystem::exists(file)) return;
  Session session;
  apply(session, OpenFile{file});
  REQUIRE(session.jobs->repair_offer);
  CHECK(session.outbox->notices.empty());
  apply(session, RepairAndOpen{});
  REQUIRE(session.document);
  apply(session, ToLast{});
  CHECK(session.document->timeline.state().finished());
}
