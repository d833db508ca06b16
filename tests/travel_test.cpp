// Running to break conditions, and steps over, into and out.
#include "app/actions/navigate.h"
#include "app/script/queries.h"
#include "app/session/break_hits.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/model/stitch_size.h"
#include "tests/support/beside.h"

using namespace app;
using knit::Place;
using knit::Stage;
using test_support::finished_small_session;
using test_support::small_session;

namespace {

SetBreaks breaks(const std::vector<std::string>& texts) { return {breaks_of(texts)}; }

std::size_t after_deep(Session& session, std::size_t position, Depth depth, int direction) {
  apply(session, SeekTo{position});
  apply(session, StepDeep{depth, direction});
  return session.document->timeline.position();
}

// What a debugger says, on a run's places: over and out as stretches between two steps' borders.
bool between(const knit::Timeline& timeline, std::size_t position, bool rows) {
  if (position == 0 || position == timeline.known()) return true;
  const Place& a = timeline.step(position - 1).place;
  const Place& b = timeline.step(position).place;
  return a.stage != b.stage || (rows && a.row != b.row);
}
std::size_t to_border(const knit::Timeline& timeline, std::size_t position, bool rows, int direction) {
  const std::size_t last = direction > 0 ? timeline.known() : 0;
  if (position == last) return position;
  do {
    position = direction > 0 ? position + 1 : position - 1;
  } while (!between(timeline, position, rows));
  return position;
}
std::size_t plainly(const knit::Timeline& timeline, std::size_t position, Depth depth, int direction) {
  const std::size_t last = direction > 0 ? timeline.known() : 0;
  if (position == last) return position;
  const std::size_t one = direction > 0 ? position + 1 : position - 1;
  const bool row = between(timeline, position, true);
  const bool stage = between(timeline, position, false);
  if (depth == Depth::into) return one;
  if (depth == Depth::over) return row ? to_border(timeline, position, !stage, direction) : one;
  return stage ? last : to_border(timeline, position, !row, direction);
}

}  // namespace

TEST_CASE("over, into and out go as a debugger's do, from everywhere, forwards and backwards", "[travel]") {
  Session session = finished_small_session();
  for (const Depth depth : {Depth::over, Depth::into, Depth::out}) {
    for (const int direction : {1, -1}) {
      std::size_t wrong = 0;
      for (std::size_t position = 0; position <= session.document->timeline.known(); ++position) {
        const std::size_t plain = plainly(session.document->timeline, position, depth, direction);
        wrong += after_deep(session, position, depth, direction) == plain ? 0U : 1U;
      }
      CAPTURE(static_cast<int>(depth), direction);
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("over then over back returns where both ends are borders of the same kind", "[travel]") {
  Session session = finished_small_session();
  const knit::Timeline& timeline = session.document->timeline;
  const auto kind = [&](std::size_t position) {
    return between(timeline, position, false) ? 2 : between(timeline, position, true) ? 1 : 0;
  };
  std::size_t returned = 0, wrong = 0, stages = 0;
  for (std::size_t position = 0; position < timeline.known(); ++position) {
    const std::size_t there = after_deep(session, position, Depth::over, 1);
    const std::size_t back = after_deep(session, there, Depth::over, -1);
    if (kind(position) != kind(there)) continue;
    ++returned;
    stages += kind(position) == 2 ? 1U : 0U;
    wrong += back == position ? 0U : 1U;
  }
  CHECK(wrong == 0);
  CHECK(stages + 3 == knit::machine_stages.size());  // rings make no tubes and stay on the mesh
  CHECK(returned > timeline.known() / 2);
}

TEST_CASE("hits carried on piece by piece are those of the whole run, and a changed run has others",
          "[travel]") {
  const auto conditions = breaks_of({"row=5", "label=m1l", "wider>1.1", "grows>2"});
  knit::Timeline timeline(test_support::small_sphere(), test_support::small_parameters());
  BreakHits pieces;
  while (timeline.extend(37)) pieces.refresh(timeline, conditions, 11);
  CHECK(pieces.reach() < timeline.known());
  CHECK_FALSE(pieces.whole());
  while (!pieces.whole()) pieces.refresh(timeline, conditions, 11);
  BreakHits whole;
  whole.refresh(timeline, conditions, BreakHits::all);
  REQUIRE(whole.hits().size() > 10);
  CHECK(pieces.hits() == whole.hits());
  CHECK(whole.from(0) == whole.position_of(whole.hits().front()));
  CHECK(whole.before(BreakHits::all) == whole.position_of(whole.hits().back()));
  CHECK_FALSE(whole.before(*whole.from(0)));

  knit::Parameters other = test_support::small_parameters();
  other.rows.cast_on = 9;
  timeline.tune(other);
  pieces.refresh(timeline, conditions, BreakHits::all);
  timeline.extend_to_end();
  pieces.refresh(timeline, conditions, BreakHits::all);
  BreakHits fresh;
  fresh.refresh(timeline, conditions, BreakHits::all);
  CHECK(pieces.hits() == fresh.hits());
  CHECK(fresh.hits() != whole.hits());

  knit::Parameters finer = other;  // a longer run, seen only when it is whole again
  knit::give_width(finer, 0.2);
  knit::give_epsilon(finer, 0.1);
  timeline.tune(finer);
  timeline.extend_to_end();
  REQUIRE(timeline.known() > pieces.reach());
  pieces.refresh(timeline, conditions, BreakHits::all);
  BreakHits anew;
  anew.refresh(timeline, conditions, BreakHits::all);
  CHECK(pieces.hits() == anew.hits());
  pieces.refresh(timeline, breaks_of({"row=5"}), BreakHits::all);
  CHECK(pieces.hits().size() == 4);
}

TEST_CASE("run to next goes from hit to hit, works the run out for it, and says when there is none",
          "[travel]") {
  Session session = small_session();
  apply(session, RunToBreak{1});
  CHECK(session.document->timeline.position() == 0);
  CHECK_FALSE(session.document->place_note.empty());  // there is no condition
  apply(session, breaks({"row=4", "row=4", "stage=faces"}));
  CHECK(session.view->breaks.size() == 2);
  std::vector<Place> places;
  for (int i = 0; i < 5; ++i) {
    apply(session, RunToBreak{1});
    places.push_back(session.document->timeline.place());
    CHECK(session.document->place_note.rfind("Break: ", 0) == 0);
  }
  CHECK(places == std::vector<Place>{{Stage::rows, 4, 0},
                                     {Stage::stitches, 4, 0},
                                     {Stage::faces, 2, 0},
                                     {Stage::faces, 4, 0},
                                     {Stage::pattern, 4, 0}});
  apply(session, RunToBreak{1});
  CHECK(session.document->timeline.place() == places.back());
  CHECK(test_support::contains(session.document->place_note, "to the end of the run"));
  for (std::size_t i = 4; i-- > 0;) {
    apply(session, RunToBreak{-1});
    CHECK(session.document->timeline.place() == places[i]);
  }
  apply(session, RunToBreak{-1});
  CHECK(test_support::contains(session.document->place_note, "before"));
  apply(session, StepBy{});
  CHECK(session.document->place_note.empty());
}

TEST_CASE("in a window run to next waits for the run, and any move calls it off", "[travel]") {
  Session session = test_support::beside_session(test_support::large_parameters());
  apply(session, breaks({"stage=pattern"}));
  apply(session, RunToBreak{1});
  CHECK(session.document->timeline.position() == 0);
  CHECK(session.document->travel.running_to == 1);
  test_support::tick_until(session, [](const Session& s) { return s.document->travel.running_to == 0; });
  CHECK(session.document->timeline.place().stage == Stage::pattern);

  Session other = test_support::beside_session(test_support::large_parameters());
  apply(other, breaks({"stage=pattern"}));
  apply(other, RunToBreak{1});
  apply(other, ToFirst{});
  test_support::tick_until(other, test_support::run_is_complete);
  apply(other, PassTime{0.0});
  CHECK(other.document->timeline.position() == 0);
}

TEST_CASE("the command line stops at the first hit from its place on", "[travel]") {
  Session session = small_session();
  apply(session, breaks({"row=4", "stage=stitches"}));
  Answer answer = break_answer(session);
  CHECK(answer.exit_code == exit_done);
  CHECK(session.document->timeline.place() == Place{Stage::rows, 4, 0});
  CHECK(answer.error.rfind("break row=4: ", 0) == 0);
  CHECK(test_support::is_one_sentence(answer.error));
  answer = break_answer(session);  // it holds where it is
  CHECK(session.document->timeline.place() == Place{Stage::rows, 4, 0});
  apply(session, StepBy{});
  answer = break_answer(session);
  CHECK(answer.error.rfind("break stage=stitches: ", 0) == 0);

  apply(session, breaks({"row=400"}));
  answer = break_answer(session);
  CHECK(answer.exit_code == exit_no_break);
  CHECK(test_support::is_one_sentence(answer.error));
  CHECK(session.document->timeline.state().finished());
  CHECK(fault_of_break("row=x").has_value());
  CHECK_FALSE(fault_of_break("row=4").has_value());
}
