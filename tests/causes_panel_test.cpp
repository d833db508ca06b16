// What decided, in the panels: under the step's sentence, in the rows' and candidates' tips, and in the pattern of a run that
// stopped.
#include "app/explain/why_words.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/insight/causes.h"
#include "tests/support/desk.h"

using namespace desk;

TEST_CASE("causes: one click on a row says under the sentence why it has its stitches") {
  Desk desk(1280, 1200);
  desk.open();
  desk.act({ToLast{}});
  desk.settle();
  CHECK(desk.ui.controls.count("cause") == 1);  // of the last row
  desk.act(desk.click("row/4"));
  desk.settle();
  const std::string why = knit::why_count(desk.session.document->timeline, 4);
  CHECK_FALSE(why.empty());
  CHECK(cause(desk.session).ends_with(why));
  CHECK(desk.ui.controls.count("cause") == 1);
  desk.act({SetPredicting{true}});  // verdicts are to be guessed
  desk.settle();
  CHECK(desk.ui.controls.count("cause") == 0);
  desk.act({SetPredicting{false}});
  // Not while it plays, nor under a step that decides nothing.
  desk.session.view->playback.playing = true;
  desk.settle();
  CHECK(desk.ui.controls.count("cause") == 0);
  desk.session.view->playback.playing = false;
  desk.act({SeekPlace{{knit::Stage::rows, 5, 3}}});
  desk.settle();
  CHECK(cause(desk.session).empty());
  CHECK(desk.ui.controls.count("cause") == 0);
}

TEST_CASE("causes: the pattern of a run that stopped says that it stopped and why, and leads there") {
  Desk desk(1280, 1200);
  knit::Parameters stops = wide_band();
  knit::give_epsilon(stops, 0.001);
  stops.rows.on_stall = knit::OnStall::stop;
  desk.session.view->side = SidePanel::pattern;
  desk.open(stops);
  const knit::Timeline& timeline = desk.session.document->timeline;
  REQUIRE(timeline.stop() != nullptr);
  CHECK(desk.ui.controls.count("pattern/stop") == 1);
  desk.act({ToFirst{}});
  desk.settle();
  CHECK(only<SeekTo>(desk.click("pattern/to-stop")).position == timeline.known());
  desk.act({SeekTo{timeline.known()}});
  desk.settle();
  CHECK(desk.ui.controls.count("pattern/stop") == 1);
  CHECK(desk.ui.controls.count("pattern/to-stop") == 0);
  desk.open();
  CHECK(desk.ui.controls.count("pattern/stop") == 0);
}
