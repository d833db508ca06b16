// The list of rows in its panel, and the same as CSV.
#include "app/session/row_table.h"

#include <cmath>
#include <string>

#include "app/session/outbox.h"
#include "app/session/pins.h"
#include "app/session/program.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

namespace {

using namespace desk;

const knit::Timeline& run_of(const Desk& desk) { return desk.session.document->timeline; }

void go_to(Desk& desk, std::int32_t row, std::int32_t item) {
  desk.act({SeekPlace{{knit::Stage::rows, row, item}}});
  desk.settle();
}

std::size_t rows_listed(const Desk& desk) {
  std::size_t count = 0;
  for (const auto& [name, box] : desk.ui.controls) count += name.rfind("row/", 0) == 0 ? 1 : 0;
  return count;
}

std::string line_of_csv(const std::string& csv, std::size_t line) {
  std::size_t begin = 0;
  while (line-- > 0) begin = csv.find('\n', begin) + 1;
  return csv.substr(begin, csv.find('\n', begin) - begin);
}

}  // namespace

TEST_CASE("the list of rows keeps its lines, its height and its scroll while one steps") {
  Desk desk(1280, 1500);
  desk.open();
  go_to(desk, 3, 2);
  const std::size_t all = run_of(desk).furthest().fabric.rows().size();
  REQUIRE(all > run_of(desk).state().fabric.rows().size());
  CHECK(rows_listed(desk) == all);
  const Box list = desk.ui.controls.at("row/1");
  for (int i = 0; i < 12; ++i) {
    desk.act({StepBy{Unit::item, 1}});
    desk.settle();
    CHECK(desk.ui.controls.at("row/1").y == list.y);
    CHECK(rows_listed(desk) == all);
  }
}

TEST_CASE("a jump brings the row into sight, a step leaves the list where somebody scrolled it") {
  Desk desk(1280, 720);
  desk.open();
  const std::int32_t last = run_of(desk).furthest().fabric.row_count();
  REQUIRE(last == 8);
  go_to(desk, last, 0);
  CHECK(desk.ui.controls.count("row/" + std::to_string(last)) == 1);
  go_to(desk, 2, 1);
  CHECK(desk.ui.controls.count("row/2") == 1);
  CHECK(desk.ui.controls.count("row/" + std::to_string(last)) == 0);
  // Scrolled away by hand: it stays, even when the row steps on.
  desk.frames({desk.over("row/2"), Wheel{0.0f, -10.0f}});
  desk.settle();
  CHECK(desk.ui.controls.count("row/2") == 0);
  go_to(desk, 3, 1);
  CHECK(desk.ui.controls.count("row/3") == 0);
}

TEST_CASE("columns of the list of rows are chosen at its heads") {
  Desk desk(1280, 960);
  desk.open();
  for (const MouseButton button : {MouseButton::Left, MouseButton::Right}) {
    CHECK(desk.click("rows/columns", 0.3f, button).empty());
    desk.settle();
    const Actions chosen = desk.click("rows/column/course");
    const auto& choice = only<ShowRowColumn>(chosen);
    CHECK(choice.column == RowColumn::course);
    CHECK(choice.shown == !desk.session.program->preferences.shows(RowColumn::course));
    desk.act(chosen);
    desk.settle();
  }
  CHECK_FALSE(desk.session.program->preferences.shows(RowColumn::course));
}

TEST_CASE("the list of rows is copied whole, with the pinned run's stitches beside") {
  Desk desk(1280, 960);
  desk.open();
  go_to(desk, 2, 1);
  desk.act(desk.click("rows/copy"));
  REQUIRE(desk.session.outbox->clipboard);
  const std::string plain = *desk.session.outbox->clipboard;
  CHECK(plain == rows_csv(desk.session));
  CHECK(line_of_csv(plain, 0) == "row,tube,stitches,change,holds,course");
  const auto& rows = run_of(desk).furthest().fabric.rows();
  CHECK(line_of_csv(plain, 1).rfind("1,A," + std::to_string(rows[0]->stitches.size()) + ",,", 0) == 0);
  const auto change = static_cast<std::ptrdiff_t>(rows[1]->stitches.size()) -
                      static_cast<std::ptrdiff_t>(rows[0]->stitches.size());
  CHECK(line_of_csv(plain, 2).rfind(
            "2,A," + std::to_string(rows[1]->stitches.size()) + "," + std::to_string(change) + ",", 0) == 0);

  desk.act({PinRun{}});
  knit::Parameters other = wide_band();
  knit::give_width(other, 0.3);
  const std::string was = std::to_string(rows[1]->stitches.size());
  desk.act({Tune{other}});
  desk.session.document->timeline.extend_to_end();
  REQUIRE(desk.session.document->pinned->known);
  const std::string csv = rows_csv(desk.session);
  CHECK(line_of_csv(csv, 0) == "row,tube,stitches,change,holds,course,pinned");
  const std::string second = line_of_csv(csv, 2);
  CHECK(second.substr(second.rfind(',') + 1) == was);
}

TEST_CASE("what a row holds and its course are lengths in stitch widths") {
  Desk desk;
  desk.open();
  const knit::Row& row = run_of(desk).furthest().fabric.row(3);
  const RowFacts once = facts_of_row(row, 0.45);
  const RowFacts twice = facts_of_row(row, 0.9);
  CHECK(once.holds == Approx(2.0 * twice.holds));
  CHECK(once.course * once.stitches <= once.holds * 1.0001);  // chords of the curve
  CHECK(once.course * once.stitches > 0.8 * once.holds);
  CHECK(facts_of_row(row, 0.0).course == 0.0);
}

TEST_CASE("the row in progress counts the anchor, which is a stitch from the moment that it is taken") {
  Desk desk;
  desk.open();
  knit::Timeline& timeline = desk.session.document->timeline;
  std::size_t before = 0, met = 0;
  for (std::size_t at = 1; at <= timeline.known(); ++at) {
    timeline.seek(at);
    const knit::Place place = timeline.place();
    const bool ended = timeline.state().fabric.has_row(place.row);
    if (place.stage == knit::Stage::rows && ended && before > 0) {
      CHECK(before == timeline.state().fabric.row(place.row).stitches.size());
      ++met;
    }
    before = ended ? 0 : stitches_so_far(timeline.state());
    const auto* work = std::get_if<knit::RowWork>(&timeline.state().work);
    if (!ended && work != nullptr && work->phase == knit::RowPhase::measure) CHECK(before > 0);
  }
  CHECK(met > 3);
}

TEST_CASE("the tabs of the lists keep their place and height at every step, whatever is selected") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  desk.open();
  desk.settle();
  const Box first = desk.ui.controls.at("list");
  knit::Timeline& timeline = desk.session.document->timeline;
  for (std::size_t at = 0; at <= timeline.known(); at += 17) {
    timeline.seek(at);
    desk.frame();
    CHECK(desk.ui.controls.at("list").y == first.y);
    CHECK(desk.ui.controls.at("list").height == first.height);
  }
  apply(desk.session, Select{knit::StitchElement{2, 1}});
  desk.settle();
  REQUIRE(desk.ui.controls.count("selected") == 1);
  CHECK(desk.ui.controls.at("list").y == first.y);
}

TEST_CASE("the list of problems tells them whole, on as many lines as they need") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  knit::Parameters parameters = wide_band();
  knit::give_epsilon(parameters, 0.01);
  parameters.rows.on_stall = knit::OnStall::stop;
  desk.open(parameters);
  desk.session.view->list = RunList::problems;
  desk.settle();
  REQUIRE(desk.session.document->timeline.stop() != nullptr);
  const Box stop = desk.ui.controls.at("problem/0");
  CHECK(stop.height > 1.5f * ImGui::GetTextLineHeight());
}

TEST_CASE("a jump leaves no row cut under the heads, and the tabs of the lists stay in a narrow panel") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  desk.session.document = test_support::example_session("thesis-sphere").document;
  desk.session.document->timeline.extend_to_end();
  const Box head = [&] {
    desk.settle();
    return desk.ui.controls.at("rows/columns");
  }();
  for (const std::int32_t row : {14, 30, 41}) {
    go_to(desk, row, 1);
    const Box line = desk.ui.controls.at("row/" + std::to_string(row));
    const Box next = desk.ui.controls.at("row/" + std::to_string(row + 1));
    const float lines = (line.y - head.y) / (next.y - line.y);
    CHECK(std::abs(lines - std::round(lines)) < 0.02f);
  }
  knit::Parameters parameters = desk.session.document->timeline.parameters();
  knit::give_epsilon(parameters, 0.012);
  desk.act({Tune{parameters}});
  desk.session.document->timeline.extend_to_end();
  desk.session.view->list = RunList::problems;
  desk.session.view->breaks = {std::get<knit::BreakCondition>(knit::parse_break("stall"))};
  desk.act({ToLast{}});
  desk.settle();
  CHECK(desk.ui.controls.at("list").right() <= desk.layout.explanation.right() - 9.5f);
}
