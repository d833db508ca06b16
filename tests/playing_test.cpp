// How playing moves: slow motion, the loop, and stopping at break conditions.
#include "app/actions/playing.h"

#include <algorithm>
#include <set>

#include "app/actions/navigate.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/quality/measures.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using test_support::finished_small_session;

namespace {

BreakHits hits_of(const Session& session, const std::vector<std::string>& texts) {
  std::vector<knit::BreakCondition> conditions;
  for (const std::string& text : texts)
    conditions.push_back(std::get<knit::BreakCondition>(knit::parse_break(text)));
  BreakHits hits;
  hits.refresh(session.document->timeline, conditions, BreakHits::all);
  return hits;
}

// One step after the other, straight from the definition.
Played plainly(const Course& course, const std::set<std::size_t>& hits, std::size_t position,
               std::size_t steps) {
  const std::size_t begin = position;
  for (; steps > 0; --steps) {
    if (course.loop && course.direction > 0 && position == course.loop->end) {
      position = course.loop->begin;
    } else if (course.loop && course.direction < 0 && position == course.loop->begin) {
      position = course.loop->end;
    } else if (course.direction > 0 ? position == course.end : position == 0) {
      break;
    } else {
      position = course.direction > 0 ? position + 1 : position - 1;
    }
    if (position != begin && hits.count(position) > 0) return {position, true};
  }
  return {position, false};
}

void seek(Session& session, std::size_t position) { apply(session, SeekTo{position}); }

}  // namespace

TEST_CASE("playing goes as far as its steps, to a hit, and round its loop, both ways", "[playing]") {
  const Session session = finished_small_session();
  const BreakHits hits = hits_of(session, {"row=3", "row=4", "label=main"});
  std::set<std::size_t> positions;
  for (const knit::BreakHit& hit : hits.hits()) positions.insert(hits.position_of(hit));
  REQUIRE(positions.size() > 20);
  const std::size_t first = *positions.begin();
  const std::size_t second = *std::next(positions.begin());
  const std::size_t end = session.document->timeline.known();
  std::size_t wrong = 0;
  for (const int direction : {1, -1}) {
    for (const auto& loop : {std::optional<Stretch>(), std::optional(Stretch{first - 5, first + 3}),
                             std::optional(Stretch{10, 17}), std::optional(Stretch{first, second}),
                             std::optional(Stretch{end - 4, end})}) {
      const Course course{end, direction, loop};
      for (std::size_t i = 0; i <= (loop ? loop->end - loop->begin : 400); ++i) {
        const std::size_t position = loop ? loop->begin + i : (first + i) % (end + 1);
        for (const std::size_t steps : std::vector<std::size_t>{0, 1, 2, 3, 7, 8, 9, 40, 1000}) {
          const Played now = played(course, hits, position, steps);
          const Played plain = plainly(course, positions, position, steps);
          wrong += now.position == plain.position && now.broke == plain.broke ? 0U : 1U;
        }
      }
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("from outside its loop playing jumps in", "[playing]") {
  const BreakHits none;
  CHECK(played({100, 1, Stretch{40, 50}}, none, 70, 5).position == 40);
  CHECK(played({100, 1, Stretch{40, 50}}, none, 3, 1).position == 40);
  CHECK(played({100, -1, Stretch{40, 50}}, none, 3, 1).position == 50);
  CHECK(played({100, 1, Stretch{40, 50}}, none, 70, 0).position == 70);
}

TEST_CASE("slow motion is a few steps a second where it matters and full speed away from it", "[playing]") {
  CHECK(slow_pace(300.0, 0) == Approx(3.0));
  CHECK(slow_pace(300.0, 1000) == Approx(300.0));
  CHECK(slow_pace(1.0, 0) == Approx(1.0));
  for (std::size_t d = 0; d < 60; ++d) {
    CHECK(slow_pace(100000.0, d + 1) >= slow_pace(100000.0, d));
    CHECK(slow_pace(100000.0, d + 1) <= 1.5001 * slow_pace(100000.0, d));  // smoothly
  }
}

TEST_CASE("in slow motion the last step of a row stays for a while, however time is cut up", "[playing]") {
  Session session = finished_small_session();
  apply(session, SetSlowMotion{true});
  apply(session, SetSpeed{200.0});
  const std::size_t closing = position_at(session.document->timeline, {knit::Stage::rows, 5, INT32_MAX});
  for (const int direction : {1, -1}) {
    INFO(direction);
    seek(session, direction > 0 ? closing - 10 : closing + 10);
    apply(session, SetPlaying{true, direction});
    double at_closing = 0.0;
    double all = 0.0;
    while (direction > 0 ? session.document->timeline.position() <= closing + 9
                         : session.document->timeline.position() >= closing - 9) {
      apply(session, PassTime{0.005});
      all += 0.005;
      REQUIRE(all < 30.0);
      if (session.document->timeline.position() == closing) at_closing += 0.005;
    }
    CHECK(at_closing == Approx(1.0 / 3.0).margin(0.02));
    CHECK(all > 1.5);  // 20 steps at full speed take 0.1 s
    apply(session, SetPlaying{false});
  }
  apply(session, SetSlowMotion{false});
  seek(session, closing - 10);
  apply(session, SetPlaying{});
  apply(session, PassTime{0.1});
  CHECK(session.document->timeline.position() == closing + 10);
}

TEST_CASE(
    "the times take two seconds at the usual speed and a tenth of the bar, and a step by hand is one step",
    "[playing]") {
  Session session = test_support::example_session("thesis-sphere");
  apply(session, ToLast{});
  const knit::Timeline& timeline = session.document->timeline;
  const Prelude prelude = prelude_of(timeline);
  CHECK(timeline.step(prelude.steps).place.stage == knit::Stage::cast_on);
  CHECK(timeline.step(prelude.steps - 1).place.stage == knit::Stage::timing);
  REQUIRE(prelude.steps > 900);  // three seconds of single steps
  CHECK(prelude.share(timeline.known()) <= 0.1);
  apply(session, ToFirst{});
  apply(session, SetSpeed{Playback{}.steps_per_second});
  apply(session, SetPlaying{});
  double seconds = 0.0;
  while (timeline.position() <= prelude.steps) {
    apply(session, PassTime{0.01});
    seconds += 0.01;
    REQUIRE(seconds < 10.0);
  }
  CHECK(seconds == Approx(2.0).margin(0.03));
  const std::size_t there = timeline.position();
  apply(session, PassTime{0.1});
  CHECK(timeline.position() == there + 30);
  apply(session, SetPlaying{true, -1});  // and back, across the border
  apply(session, PassTime{0.2});
  CHECK(timeline.position() < prelude.steps);
  apply(session, ToFirst{});
  apply(session, StepBy{});
  CHECK(timeline.position() == 1);
}

TEST_CASE("a short run's times are played step for step", "[playing]") {
  const Session session = finished_small_session();
  const Prelude prelude = prelude_of(session.document->timeline);
  CHECK(prelude.steps > 0);
  CHECK(prelude.stride >= 1.0);
  CHECK(Prelude{}.share(100) == 0.0);
  CHECK(Prelude{100, 10.0}.share(190) == Approx(0.1));
}

TEST_CASE("as fast as it goes is as many steps as a tick works out", "[playing]") {
  Session session = test_support::small_session();
  session.document->timeline =
      knit::Timeline(knit::make_input(knit::sphere(256, 129)), test_support::thesis_parameters());
  apply(session, SetSpeed{fastest_steps_per_second});
  apply(session, SetPlaying{});
  apply(session, PassTime{0.001});
  CHECK(session.document->timeline.known() == steps_per_tick);
  CHECK(session.document->timeline.position() == steps_per_tick);
  apply(session, SetSpeed{100.0});  // changed while it plays
  apply(session, PassTime{0.1});
  CHECK(session.document->timeline.position() == steps_per_tick + 10);
  CHECK(session.view->playback.playing);
}

TEST_CASE("playing stops at a hit, forwards and backwards, and goes on from it", "[playing]") {
  Session session = finished_small_session();
  apply(session, ToFirst{});
  apply(session, SetBreaks{{std::get<knit::BreakCondition>(knit::parse_break("row=4"))}});
  const BreakHits hits = session.document->travel.hits;
  REQUIRE(hits.hits().size() == 4);
  const auto play_on = [&](int direction) {
    apply(session, SetPlaying{true, direction});
    for (int i = 0; i < 10000 && session.view->playback.playing; ++i) apply(session, PassTime{0.25});
    CHECK_FALSE(session.view->playback.playing);
    return session.document->timeline.position();
  };
  for (const knit::BreakHit& hit : hits.hits()) {
    CHECK(play_on(1) == hit.step + 1);
    CHECK(session.document->timeline.place().row == 4);
    CHECK(session.document->place_note == "Break: row 4 begins.");
  }
  CHECK(play_on(1) == session.document->timeline.known());
  CHECK(session.document->place_note.empty());
  for (std::size_t i = 4; i-- > 0;) CHECK(play_on(-1) == hits.hits()[i].step + 1);
  CHECK(play_on(-1) == 0);
}

TEST_CASE("the loop is played round and round, and follows its row when the run is tuned", "[playing]") {
  Session session = finished_small_session();
  apply(session, SeekPlace{{knit::Stage::rows, 6, 3}});
  const Stretch row = stretch_of_row(session).value();
  apply(session, SetLoop{row});
  apply(session, SetPlaying{});
  apply(session, SetSpeed{50.0});
  std::size_t turns = 0;
  std::size_t last = session.document->timeline.position();
  for (int i = 0; i < 200; ++i) {
    apply(session, PassTime{0.05});
    const std::size_t now = session.document->timeline.position();
    CHECK((now >= row.begin && now <= row.end));
    turns += now < last ? 1U : 0U;
    last = now;
  }
  CHECK(turns >= 3);
  knit::Parameters other = session.document->timeline.parameters();
  other.rows.cast_on = 9;  // other rows before it
  apply(session, Tune{other});
  for (int i = 0; i < 3; ++i) apply(session, PassTime{0.0});
  REQUIRE(session.document->travel.loop.has_value());
  CHECK(session.document->timeline.step(session.document->travel.loop->begin).place.row == 6);
  CHECK(session.document->timeline.step(session.document->travel.loop->begin - 1).place.row == 5);
  CHECK(session.document->timeline.step(session.document->travel.loop->end - 1).place.row == 6);
  CHECK(session.document->timeline.step(session.document->travel.loop->end).place.row == 7);
  apply(session, SetLoop{});
  CHECK_FALSE(session.document->travel.loop);
  for (int i = 0; i < 3; ++i) apply(session, PassTime{0.0});
  CHECK_FALSE(session.document->travel.loop);
}

TEST_CASE("a loop up to the end of the run goes round too", "[playing]") {
  Session session = finished_small_session();
  const std::size_t end = session.document->timeline.known();
  apply(session, SeekTo{end - 3});
  apply(session, SetLoop{Stretch{end - 5, end}});
  apply(session, SetPlaying{});
  apply(session, SetSpeed{20.0});
  for (int i = 0; i < 50; ++i) apply(session, PassTime{0.05});
  CHECK(session.view->playback.playing);
  CHECK(session.document->timeline.position() >= end - 5);
}
