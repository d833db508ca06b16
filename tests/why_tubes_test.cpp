// Why a critical vertex is what it is: the step that deals there, or leaves out, its numbers and its words.
#include "knit/insight/why_tubes.h"

#include <algorithm>

#include "app/explain/why_words.h"
#include "app/script/queries.h"
#include "app/session/document.h"
#include "knit/insight/problems.h"
#include "knit/insight/why.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace knit;
using test_support::contains;

namespace {

Timeline run_of(const Mesh& mesh, AxisKind axis = AxisKind::y, std::int32_t smallest_limb = 1) {
  const auto input = make_input(mesh);
  Parameters parameters;
  give_width(parameters, 0.12);
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters.timing.axis = Axis{axis};
  parameters.tubes.smallest_limb = smallest_limb;
  Timeline timeline(input, resolved(parameters, *input));
  timeline.extend_to_end();
  return timeline;
}

const TubeEvent& event_of(const Timeline& timeline, EventKind kind) {
  const std::vector<TubeEvent>& events = timeline.furthest().tubes->events;
  const auto found =
      std::find_if(events.begin(), events.end(), [&](const TubeEvent& event) { return event.kind == kind; });
  REQUIRE(found != events.end());
  return *found;
}

std::string words_at(const Timeline& timeline, VertexId vertex) {
  return app::why_words(timeline, VertexElement{vertex});
}

}  // namespace

TEST_CASE("why: a saddle is told by the deal that it makes, with its steps and numbers") {
  const Timeline timeline = run_of(test_support::arch());
  const VertexId saddle = event_of(timeline, EventKind::join).vertex;
  const auto story = critical_story(timeline, saddle);
  REQUIRE(story);
  REQUIRE(story->found.size() == 1);
  CHECK(is<NodeFound>(timeline.step(story->found.front())));
  REQUIRE(story->deals == std::vector<std::int32_t>{1});
  REQUIRE(story->dealt.size() == 2);
  CHECK(is<GapsFound>(timeline.step(story->dealt[0])));
  CHECK(is<LoopsDealt>(timeline.step(story->dealt[1])));
  CHECK(story_of(timeline, saddle).decided == story->dealt[0]);
  const std::string words = words_at(timeline, saddle);
  CHECK(contains(words, "Tubes A and B join to C here."));
  CHECK(contains(words, "Step " + std::to_string(story->dealt[0] + 1) + ": "));
  const auto* dealt = get_if<LoopsDealt>(timeline.step(story->dealt[1]));
  CHECK(contains(words, "become one of " + std::to_string(dealt->whole) + " stitches"));
  CHECK_FALSE(contains(words, "handle"));
}

TEST_CASE("why: a tube's lowest and highest vertex tell of its first and its last row") {
  const Timeline timeline = run_of(test_support::arch());
  const TubeEvent& low = event_of(timeline, EventKind::cast_on);
  const TubeEvent& high = event_of(timeline, EventKind::bind_off);
  const Row& last = *timeline.furthest().fabric.rows().back();
  CHECK(contains(words_at(timeline, low.vertex),
                 "Tube A begins here. Its first row, row 1, is cast on with " +
                     std::to_string(timeline.furthest().fabric.row(1).stitches.size())));
  CHECK(contains(words_at(timeline, high.vertex), "Its last row, row " + std::to_string(last.id) + ", has " +
                                                      std::to_string(last.stitches.size()) + " stitches."));
  const auto step = story_of(timeline, low.vertex).decided;
  REQUIRE(step);
  CHECK(is<NodeFound>(timeline.step(*step)));
}

TEST_CASE("why: a join of tubes that hang together says that it closes a handle") {
  const Timeline timeline = run_of(torus(48, 24, 0.68, 0.32), AxisKind::x);
  const std::string words = words_at(timeline, event_of(timeline, EventKind::join).vertex);
  CHECK(contains(words, "this closes a handle."));
  CHECK_FALSE(contains(words_at(timeline, event_of(timeline, EventKind::split).vertex), "handle"));
}

TEST_CASE("why: both ends of what is left out say so, with its size and the stitch that would keep it") {
  const Timeline timeline = run_of(test_support::arch(), AxisKind::y, 100);
  const TubePlan& plan = *timeline.furthest().tubes;
  REQUIRE(plan.left_out.size() == 1);
  const LeftOut& limb = plan.left_out.front();
  for (const VertexId end : {limb.from, limb.to}) {
    const std::string words = words_at(timeline, end);
    CHECK(contains(words, "the limb from vertex " + std::to_string(limb.from) + " to vertex " +
                              std::to_string(limb.to) + ", "));
    CHECK(contains(words, "is left out; a stitch "));
    CHECK(contains(words, " wide would keep it."));
    const auto step = story_of(timeline, end).decided;
    REQUIRE(step);
    CHECK(is<TubeLeftOut>(timeline.step(*step)));
  }
}

TEST_CASE("why: what is no critical vertex has its time's step, as before") {
  const Timeline timeline = run_of(test_support::arch());
  const std::size_t vertices = timeline.input().mesh.positions.size();
  std::size_t critical = 0;
  for (VertexId v = 0; v < vertices; ++v) {
    if (critical_story(timeline, v))
      ++critical;
    else if (story_of(timeline, v).decided != timed_by(timeline, v))
      FAIL("vertex " << v);
  }
  CHECK(critical == 4);
}

TEST_CASE("the option --why prints the steps of a saddle with their numbers") {
  app::Session session;
  session.document = app::Document(run_of(test_support::arch()));
  const knit::VertexId saddle = event_of(session.document->timeline, EventKind::join).vertex;
  const std::string out = app::why_answer(session, "vertex:" + std::to_string(saddle)).out;
  for (const char* part :
       {"found\tstep ", "\tnode-found\n", "dealt\tstep ", "\tgaps-found\n", "  tried\t", "\tloops-dealt\n"}) {
    CAPTURE(part, out);
    CHECK(contains(out, part));
  }
}

TEST_CASE("problems: what is left out is a kind of its own, under a stop", "[problems]") {
  const Timeline timeline = run_of(test_support::arch(), AxisKind::y, 100);
  ProblemRanking ranking;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    if (const auto problem = problem_of(timeline.step(i), i, timeline.parameters_of_step(i)))
      ranking.take(*problem);
  }
  ranking.take({7, ProblemKind::row_resampled, 9.0});
  ranking.take({8, ProblemKind::stopped, 0.0});
  ranking.finish();
  CHECK(ranking[0].kind == ProblemKind::stopped);
  REQUIRE(ranking[1].kind == ProblemKind::left_out);
  const auto* left = get_if<TubeLeftOut>(timeline.step(ranking[1].step));
  REQUIRE(left != nullptr);
  CHECK(ranking[1].size == Approx(static_cast<double>(left->rows) * static_cast<double>(left->stitches)));
  CHECK(ranking[2].kind == ProblemKind::row_resampled);
}
