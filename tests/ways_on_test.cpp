// Ways on from a stopped run: what is tried, that only what finishes is offered, and that every door says the same.
#include "app/compare/ways_on.h"

#include <algorithm>
#include <map>

#include "app/panels/kit/stop_ways.h"
#include "app/script/command_line.h"
#include "app/script/queries.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/run_figures.h"
#include "app/session/view.h"
#include "knit/mesh/shapes.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;
using test_support::contains;

namespace {

// A ring, which rows from rings cannot follow.
knit::Timeline stopped_torus() {
  knit::Parameters parameters;
  parameters.rows.source = knit::RowSource::rings;
  knit::give_width(parameters, 0.4);
  knit::Timeline run(knit::make_input(knit::torus(24, 12, 2.0, 0.8)), parameters);
  run.extend_to_end();
  run.seek(run.known());
  return run;
}

std::vector<std::string> keys_of(const std::vector<FoundWay>& ways) {
  std::vector<std::string> keys;
  for (const FoundWay& found : ways) keys.push_back(found.way.key);
  return keys;
}

bool has(const std::vector<std::string>& keys, const std::string& key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace

TEST_CASE("ways on: of a torus from rings, contours finish with the rows that are said and other axes do not",
          "[ways-on]") {
  const knit::Timeline run = stopped_torus();
  REQUIRE(run.stop() != nullptr);
  const WaysOnWork work(run);
  work.wait();
  const std::vector<FoundWay> found = work.found();
  const auto keys = keys_of(found);
  REQUIRE(has(keys, "contours"));
  for (const char* axis : {"axis-x", "axis-z"}) CHECK_FALSE(has(keys, axis));
  for (const FoundWay& way : found) {
    CAPTURE(way.way.key);
    const Knobs knobs =
        tuned(knobs_of(run), run.parameters(), with_way(way.way, run.parameters()), run.input());
    const RunTally again = whole_run(run.input(), knobs);
    CHECK(again.state.finished());
    CHECK(again.state.fabric.rows().size() == way.rows);
    CHECK(way.rows > 1);
  }
}

TEST_CASE("ways on: a stall may be bridged, and nothing is tried that is in force already", "[ways-on]") {
  knit::Timeline run = stopped_torus();
  knit::Step stop = *run.stop();
  knit::Parameters parameters = run.parameters();
  parameters.rows.on_stall = knit::OnStall::stop;
  auto stopped = *knit::get_if<knit::Stopped>(stop);
  stopped.reason = knit::StopReason::stall;
  stop.what = stopped;
  const auto ways = ways_to_try(run.input(), parameters, stop);
  REQUIRE_FALSE(ways.empty());
  CHECK(ways.front().options == "--on-stall continue");
  for (const WayOn& way : ways) CHECK_FALSE(with_way(way, parameters) == parameters);
  parameters.rows.source = knit::RowSource::contours;
  for (const WayOn& way : ways_to_try(run.input(), parameters, stop)) CHECK(way.key != "contours");
}

TEST_CASE("ways on: a button near the stop and one over the problems begin the run anew, which finishes",
          "[ways-on]") {
  Desk desk(1280, 1400, 1, KNIT_ASSETS_DIR "/fonts");
  desk.open();
  desk.session.document->timeline = stopped_torus();
  desk.settle();
  REQUIRE(desk.ui.controls.count("stop/contours") == 1);
  desk.session.view->list = RunList::problems;
  desk.settle();
  CHECK(desk.ui.controls.count("problems/contours") == 1);
  const Actions wishes = desk.click("stop/contours");
  CHECK(only<Tune>(wishes).parameters.rows.source == knit::RowSource::contours);
  desk.act(wishes);
  desk.session.document->timeline.extend_to_end();
  CHECK(desk.session.document->timeline.stop() == nullptr);
  desk.settle();
  CHECK(desk.ui.controls.count("stop/contours") == 0);
}

TEST_CASE("ways on: the card at a stop can be put away", "[ways-on]") {
  Desk desk;
  desk.open();
  desk.session.document->timeline = stopped_torus();
  desk.settle();
  CHECK(desk.click("stop/away").empty());
  desk.settle();
  CHECK(desk.ui.controls.count("stop/away") == 0);
}

TEST_CASE("ways on: a script gets the same, a line each, and a sentence where the run did not stop",
          "[ways-on]") {
  Session session = test_support::finished_small_session();
  CHECK(contains(ways_answer(session).error, "did not stop"));
  session.document->timeline = stopped_torus();
  const Answer answer = ways_answer(session);
  CHECK(answer.exit_code == exit_done);
  CHECK(answer.out.starts_with("Rows from contours: "));
  CHECK(contains(answer.out, " rows: --rows contours\n"));
  const auto line = parse_command_line({"--example", "torus", "--ways-on"}, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<CommandLine>(line));
  CHECK(std::get<CommandLine>(line).ways_on);
}

TEST_CASE("ways on: what is found moves no button that is there already", "[ways-on]") {
  Desk desk;
  desk.open();
  desk.session.jobs->beside = true;  // as in a window: they come one by one
  desk.session.document->timeline = stopped_torus();
  std::map<std::string, Box> seen;
  const StopWays& ways = desk.ui.own<StopWays>();
  desk.settle();
  REQUIRE(ways.work() != nullptr);
  std::size_t most = 0;
  for (bool running = true; running;) {
    running = ways.work()->running();
    desk.settle();
    const std::size_t found = ways.work()->found().size();
    if (found != most && found > 0) desk.settle();
    most = found;
    for (const auto& [name, box] : desk.ui.controls) {
      if (!name.starts_with("stop/") || name == "stop/words") continue;
      const auto [known, is_new] = seen.emplace(name, box);
      INFO(name);
      if (!is_new) CHECK(known->second == box);
    }
    CHECK((running || desk.ui.controls.count("problems/contours") == 0));
  }
  CHECK(most >= 2);
  CHECK(seen.count("stop/contours") == 1);
  CHECK(seen.at("stop/contours").y > seen.at("stop/away").y);
  CHECK(desk.ui.controls.at("stop/contours").bottom() <= desk.layout.view.bottom());
}

TEST_CASE("ways on: where the axis gives no ends a person may pick them, with a button each", "[ways-on]") {
  Desk desk(1280, 1400, 1, KNIT_ASSETS_DIR "/fonts");
  knit::Parameters parameters = wide_band();
  parameters.timing.start = parameters.timing.end = 3;  // one place for both
  desk.open(parameters);
  const knit::Step* stop = desk.session.document->timeline.stop();
  REQUIRE(stop != nullptr);
  REQUIRE(knit::get_if<knit::Stopped>(*stop)->reason == knit::StopReason::no_extent);
  desk.act({ToLast{}});
  desk.settle();
  CHECK(only<SetPicking>(desk.click("stop/pick-start")).picking == Picking::start);
  CHECK(only<SetPicking>(desk.click("stop/pick-end")).picking == Picking::end);
}
