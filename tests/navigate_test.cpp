// Forward and back by item, row and stage, from everywhere in a small run.
#include "app/actions/navigate.h"
#include "app/session/document.h"

#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using knit::Place;
using knit::Stage;
using knit::Timeline;

namespace {

Timeline small_run() {
  Timeline timeline(test_support::small_sphere(), test_support::small_parameters());
  timeline.extend_to_end();
  return timeline;
}

// Whether two steps belong to one stretch of the unit.
bool together(const knit::Step& a, const knit::Step& b, Unit unit) {
  return a.place.stage == b.place.stage && (unit == Unit::stage || a.place.row == b.place.row);
}

// Straight from the definition: past the rest of the stretch that the next step begins or continues.
std::size_t plain_forward(const Timeline& timeline, std::size_t position, Unit unit) {
  if (position == timeline.known()) return position;
  std::size_t after = position + 1;
  while (after < timeline.known() && together(timeline.step(after), timeline.step(position), unit)) ++after;
  return after;
}

// To before the stretch of the last step taken.
std::size_t plain_backward(const Timeline& timeline, std::size_t position, Unit unit) {
  if (position == 0) return 0;
  std::size_t before = position - 1;
  while (before > 0 && together(timeline.step(before - 1), timeline.step(position - 1), unit)) --before;
  return before;
}

}  // namespace

TEST_CASE("an item forward and back is one step, and stays at both ends") {
  Timeline timeline = small_run();
  CHECK(position_after(timeline, Unit::item, 1) == 1);
  CHECK(position_after(timeline, Unit::item, -1) == 0);
  timeline.seek(1000);
  CHECK(position_after(timeline, Unit::item, 1) == 1001);
  CHECK(position_after(timeline, Unit::item, -1) == 999);
  timeline.seek(timeline.known());
  CHECK(position_after(timeline, Unit::item, 1) == timeline.known());
  CHECK(position_after(timeline, Unit::item, -1) == timeline.known() - 1);
}

TEST_CASE("rows and stages, forward and back, from every position") {
  Timeline timeline = small_run();
  for (const Unit unit : {Unit::row, Unit::stage}) {
    std::size_t wrong = 0;
    for (std::size_t position = 0; position <= timeline.known(); ++position) {
      timeline.seek(position);
      wrong += position_after(timeline, unit, 1) == plain_forward(timeline, position, unit) ? 0U : 1U;
      wrong += position_after(timeline, unit, -1) == plain_backward(timeline, position, unit) ? 0U : 1U;
      CHECK(timeline.position() == position);
    }
    CAPTURE(static_cast<int>(unit));
    CHECK(wrong == 0);
  }
}

TEST_CASE("going by stages visits all that the run has, forward and back") {
  Timeline timeline = small_run();
  timeline.seek(0);
  std::vector<Stage> forward;
  for (std::size_t last = timeline.known() + 1; timeline.position() != last;) {
    last = timeline.position();
    timeline.seek(position_after(timeline, Unit::stage, 1));
    if (timeline.position() != last) forward.push_back(timeline.place().stage);
  }
  std::vector<Stage> stages(knit::machine_stages.begin(), knit::machine_stages.end());
  std::erase(stages, Stage::tubes);  // rings make none, and do not settle
  std::erase(stages, Stage::settle);
  std::erase(stages, Stage::relax);
  CHECK(forward == stages);
  CHECK(timeline.position() == timeline.known());

  std::size_t jumps = 0;
  while (timeline.position() > 0) {
    timeline.seek(position_after(timeline, Unit::stage, -1));
    ++jumps;
  }
  CHECK(jumps == stages.size());
}

TEST_CASE("forward works a run out as far as needed, and no further than a slice") {
  Timeline timeline(knit::make_input(knit::sphere(128, 65, true)), test_support::thesis_parameters());
  CHECK(timeline.known() == 0);
  timeline.seek(position_after(timeline, Unit::item, 1));
  CHECK(timeline.position() == 1);
  CHECK(timeline.known() == 1);
  timeline.seek(position_after(timeline, Unit::stage, 1));
  CHECK(timeline.place().stage == Stage::timing);
  CHECK(timeline.state().stage() == Stage::cast_on);
  CHECK_FALSE(timeline.complete());
  timeline.seek(position_after(timeline, Unit::stage, 1));
  CHECK(timeline.state().fabric.rows().size() == 1);
  timeline.seek(position_after(timeline, Unit::row, 1));
  CHECK(timeline.state().fabric.rows().size() == 2);
  CHECK_FALSE(timeline.complete());
}

TEST_CASE("from the end of an unfinished run nothing moves, by any unit") {
  Session torus = test_support::torus_from_rings();
  apply(torus, ToLast{});
  REQUIRE(torus.document->timeline.stop() != nullptr);
  for (const Unit unit : {Unit::item, Unit::row, Unit::stage}) {
    CHECK(position_after(torus.document->timeline, unit, 1) == torus.document->timeline.known());
  }
}

TEST_CASE("a place is found, or the nearest before it") {
  Timeline timeline(test_support::small_sphere(), test_support::small_parameters());
  const Place place{Stage::rows, 4, 6};
  timeline.seek(position_at(timeline, place));
  CHECK(timeline.place() == place);
  timeline.seek(position_at(timeline, {Stage::rows, 4, 100000}));
  CHECK(timeline.place().stage == Stage::rows);
  CHECK(timeline.place().row == 4);
  CHECK(timeline.state().next == Place{Stage::rows, 5, 0});
  CHECK(position_at(timeline, {Stage::done, 0, 0}) == timeline.known());
  CHECK(timeline.complete());
}
