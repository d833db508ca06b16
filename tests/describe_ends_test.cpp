// What of the surface is drawn beside the faces: where it goes on beyond the ends of limbs, each at a time of its own.
#include "app/describe/describe_ends.h"

#include <algorithm>

#include "app/describe/describe.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

namespace {

// The arms of this one end at different times: the lower one's tip lies beside rows of the other.
Session finished_y() {
  Session session = test_support::example_session("y");
  apply(session, ToLast{});
  return session;
}

}  // namespace

TEST_CASE("beyond the ends of limbs the surface goes on, whatever the time there") {
  const Session session = finished_y();
  const knit::State& state = session.document->timeline.state();
  const Scene scene = Describer().describe(session);
  REQUIRE(scene.covered);
  REQUIRE(scene.covered_by);
  const std::vector<float>& told = *scene.covered_by;
  REQUIRE(told.size() == session.document->timeline.input().mesh.positions.size());
  for (const knit::TubeEvent& event : state.tubes->events) {
    INFO("event at vertex " << event.vertex);
    const bool is_end = event.kind == knit::EventKind::cast_on || event.kind == knit::EventKind::bind_off;
    CHECK((told[event.vertex] < scene.covered->from) == is_end);
  }
  CHECK(std::ranges::count_if(state.tubes->events, [](const knit::TubeEvent& event) {
          return event.kind == knit::EventKind::bind_off;
        }) == 2);
  const auto beyond = std::ranges::count(told, beyond_an_end);
  CHECK(beyond > 3);
  CHECK(beyond < static_cast<std::ptrdiff_t>(told.size() / 10));
}

TEST_CASE("nothing beyond an end is told while faces of a shape that branches are missing") {
  Session session = finished_y();
  apply(session, SeekPlace{{knit::Stage::faces, 4, 1}});
  const Scene scene = Describer().describe(session);
  CHECK_FALSE(scene.covered);
  CHECK_FALSE(scene.covered_by);
}
