// Tuning keeps one's place, and says when the place is gone.
#include "app/actions/navigate.h"
#include "app/session/document.h"
#include "app/session/view.h"

#include "knit/model/stitch_size.h"
#include "tests/support/beside.h"

using namespace app;
using knit::Place;
using knit::Stage;

namespace {

void settle(Session& session) {
  apply(session, PassTime{0.0});
  for (int i = 0; i < 1000 && session.document->timeline.sought(); ++i) apply(session, PassTime{0.0});
  REQUIRE_FALSE(session.document->timeline.sought());
}

knit::Parameters with_width(double width) {
  knit::Parameters parameters = test_support::small_parameters();
  parameters.rows.source = knit::RowSource::contours;
  knit::give_width(parameters, width);
  knit::give_epsilon(parameters, 0.5 * width);
  return parameters;
}

Session contour_session() {
  Session session = test_support::small_session();
  apply(session, Tune{with_width(0.2)});
  apply(session, ToLast{});
  return session;
}

}  // namespace

TEST_CASE("the words for a place that is gone", "[place]") {
  CHECK(place_note({Stage::rows, 14, 3}, {Stage::rows, 13, 8}, {Stage::stitches, 2, 0}) ==
        "Row 14, item 4, is not in this run; showing row 13, its last step.");
  CHECK(place_note({Stage::rows, 14, 30}, {Stage::rows, 14, 28}, {Stage::rows, 14, 29}) ==
        "Row 14, item 31, is not in this run; showing row 14, item 29.");
  CHECK(
      place_note({Stage::faces, 14, 3}, {Stage::stitches, 9, 8}, {Stage::faces, 2, 0}) ==
      "Row 14 of the stage faces, item 4, is not in this run; showing row 9 of the stage stitches, its last "
      "step.");
  CHECK(place_note({Stage::timing, 0, 9}, {Stage::timing, 0, 8}, {Stage::cast_on, 1, 0}) ==
        "The stage timing, item 10, is not in this run; showing the stage timing, its last step.");
  CHECK(place_note({Stage::rows, 14, 3}, {Stage::rows, 14, 3}, {Stage::rows, 14, 4}).empty());
  CHECK(place_note({Stage::done, 0, 0}, {Stage::pattern, 14, 3}, {Stage::done, 0, 0}).empty());
  CHECK(place_note({Stage::rows, 14, INT32_MAX}, {Stage::rows, 14, 3}, {Stage::rows, 15, 0}).empty());
}

TEST_CASE("a place that is gone is told, and comes back with the parameters", "[place]") {
  Session session = contour_session();
  const auto last_row = static_cast<std::int32_t>(session.document->timeline.state().fabric.rows().size());
  const Place place{Stage::rows, last_row, 2};
  apply(session, SeekPlace{place});
  REQUIRE(session.document->timeline.place() == place);

  for (const double width : {0.3, 0.5, 0.4}) {  // a hand on the knob
    apply(session, Tune{with_width(width)});
    settle(session);
    CHECK(session.document->timeline.place().stage == Stage::rows);
    CHECK(session.document->timeline.place().row < last_row);
    CHECK(session.document->timeline.state().next.stage == Stage::stitches);  // the nearest before it
    CHECK(test_support::contains(session.document->place_note,
                                 "Row " + std::to_string(last_row) + ", item 3, is not"));
  }
  apply(session, Tune{with_width(0.2)});
  settle(session);
  CHECK(session.document->timeline.place() == place);
  CHECK(session.document->place_note.empty());
}

TEST_CASE("the next move ends what is said about the place, and what is come back to", "[place]") {
  Session session = contour_session();
  const auto last_row = static_cast<std::int32_t>(session.document->timeline.state().fabric.rows().size());
  for (const Action& move : std::vector<Action>{StepBy{Unit::item, -1}, SeekTo{500},
                                                SeekPlace{{Stage::rows, 3, 1}}, StepDeep{Depth::into, -1}}) {
    apply(session, Tune{with_width(0.2)});
    apply(session, SeekPlace{{Stage::rows, last_row, 2}});
    apply(session, Tune{with_width(0.4)});
    settle(session);
    REQUIRE_FALSE(session.document->place_note.empty());
    apply(session, PassTime{0.1});
    REQUIRE_FALSE(session.document->place_note.empty());  // time alone is no move
    apply(session, move);
    CHECK(session.document->place_note.empty());
    const Place here = session.document->timeline.place();
    apply(session, Tune{with_width(0.2)});
    settle(session);
    CHECK(session.document->timeline.place().row == here.row);
  }
}

TEST_CASE("playing on from another place says nothing more about it", "[place]") {
  Session session = contour_session();
  apply(session,
        SeekPlace{{Stage::rows,
                   static_cast<std::int32_t>(session.document->timeline.state().fabric.rows().size()), 2}});
  apply(session, Tune{with_width(0.4)});
  settle(session);
  REQUIRE_FALSE(session.document->place_note.empty());
  session.view->playback.playing = true;
  apply(session, PassTime{0.2});
  CHECK(session.document->place_note.empty());
}

TEST_CASE("in a window the place is told once the run has come back", "[place]") {
  Session session = test_support::beside_session(test_support::large_parameters());
  test_support::tick_until(session, test_support::run_is_complete);
  const auto rows = static_cast<std::int32_t>(session.document->timeline.furthest().fabric.rows().size());
  apply(session, SeekPlace{{Stage::rows, rows, 2}});
  apply(session, PassTime{0.0});
  REQUIRE(session.document->timeline.place().row == rows);
  knit::Parameters wider = test_support::large_parameters(knit::TimingKind::arc_length);
  knit::give_width(wider, 0.4);
  knit::give_epsilon(wider, 0.2);
  apply(session, Tune{wider});
  CHECK(session.document->place_note.empty());
  REQUIRE(session.document->timeline.sought().has_value());
  test_support::tick_until(session, [](const Session& s) { return !s.document->timeline.sought(); });
  CHECK(test_support::contains(session.document->place_note, "is not in this run"));
  CHECK(session.document->timeline.place().stage == Stage::rows);
}

TEST_CASE("the start stays the start, and an edit from here keeps the step shown", "[place]") {
  Session session = contour_session();
  apply(session, ToFirst{});
  apply(session, Tune{with_width(0.4)});
  settle(session);
  CHECK(session.document->timeline.position() == 0);
  CHECK(session.document->place_note.empty());
  apply(session, SeekPlace{{Stage::rows, 3, 1}});
  const std::size_t position = session.document->timeline.position();
  apply(session, EditFromHere{with_width(0.2)});
  settle(session);
  CHECK(session.document->timeline.position() == position);
  CHECK(session.document->place_note.empty());
}
