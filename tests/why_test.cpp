// "Why" leads from a thing to the step after which it is there and before which it is not.
#include "knit/insight/why.h"

#include <map>
#include <random>

#include "app/session/document.h"
#include "knit/insight/candidates.h"
#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace knit;

namespace {

std::vector<Element> things_of(const State& run) {
  std::vector<Element> things;
  for (const auto& row : run.fabric.rows()) {
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(row->stitches.size()); ++i) {
      things.emplace_back(StitchElement{row->id, i});
      things.emplace_back(RowEdgeElement{row->id, i});
    }
  }
  for (const auto& join : run.fabric.joins()) {
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(join->labels.size()); ++i)
      things.emplace_back(LabelElement{join->to, i});
  }
  for (const auto& strip : run.fabric.strips()) {
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(strip->faces.size()); ++i) {
      things.emplace_back(FaceElement{strip->to, i});
      things.emplace_back(ColumnEdgeElement{strip->to, i});
    }
  }
  return things;
}

// Walks the whole run once and looks at each thing before and after the step that is said to have made it.
void check_whys(Timeline& timeline) {
  timeline.extend_to_end();
  std::multimap<std::size_t, Element> made;
  const std::vector<Element> things = things_of(timeline.furthest());
  std::size_t unexplained = 0;
  for (const Element& thing : things) {
    const auto step = made_by(timeline, thing);
    if (step) made.emplace(*step, thing);
    unexplained += step ? 0U : 1U;
  }
  CHECK(things.size() > 300);
  CHECK(unexplained == 0);
  std::size_t there_before = 0;
  std::size_t not_there_after = 0;
  std::size_t untouched = 0;
  timeline.seek(0);
  while (timeline.position() < timeline.known()) {
    const std::size_t step = timeline.position();
    const auto [begin, end] = made.equal_range(step);
    for (auto it = begin; it != end; ++it) there_before += exists(timeline.state(), it->second) ? 1U : 0U;
    timeline.forward();
    for (auto it = begin; it != end; ++it) {
      not_there_after += exists(timeline.state(), it->second) ? 0U : 1U;
      untouched += touches(timeline, it->second, step) ? 0U : 1U;
    }
  }
  CHECK(there_before == 0);
  CHECK(not_there_after == 0);
  CHECK(untouched == 0);
}

Timeline example(const std::string& name) {
  app::Session session = test_support::example_session(name);
  REQUIRE(session.document);
  return std::move(session.document->timeline);
}

Timeline small_run(const Parameters& parameters = test_support::small_parameters()) {
  Timeline timeline(test_support::small_sphere(), parameters);
  timeline.extend_to_end();
  return timeline;
}

std::vector<std::size_t> touching_steps(const Timeline& timeline, const Element& thing) {
  std::vector<std::size_t> steps;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    if (touches(timeline, thing, i)) steps.push_back(i);
  }
  return steps;
}

}  // namespace

TEST_CASE("why: a thing is there after the step that made it and not before, in every example") {
  const std::string name = GENERATE("thesis-sphere", "egg", "vase");
  CAPTURE(name);
  Timeline timeline = example(name);
  check_whys(timeline);
}

TEST_CASE("why: the same with rows from contours and labels at the nearest stitches") {
  Timeline timeline = example("vase");
  Parameters parameters = timeline.parameters();
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  timeline.tune(parameters);
  check_whys(timeline);
}

TEST_CASE("why: the same where rows are resampled, stall and share their gap in other ways") {
  Parameters parameters = test_support::small_parameters();
  give_epsilon(parameters, 0.02);
  parameters.rows.close = GENERATE(Closing::arc, Closing::none, Closing::thesis);
  parameters.rows.last_anchor = GENERATE(LastAnchor::keep, LastAnchor::drop);
  Timeline timeline(test_support::small_sphere(), parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.stop() == nullptr);
  check_whys(timeline);
}

TEST_CASE("why: what is not there has no step") {
  const Timeline timeline = small_run();
  const auto rows = static_cast<std::int32_t>(timeline.furthest().fabric.rows().size());
  for (const Element& thing : std::vector<Element>{
           StitchElement{0, 0}, StitchElement{2, -1}, StitchElement{2, 100000}, StitchElement{rows + 1, 0},
           RowEdgeElement{rows + 7, 0}, RowEdgeElement{3, 5000}, FaceElement{1, 0}, FaceElement{2, 4000},
           ColumnEdgeElement{2, -1}, LabelElement{1, 0}, LabelElement{2, 900}, VertexElement{no_vertex}}) {
    CAPTURE(thing.index());
    CHECK_FALSE(made_by(timeline, thing));
    CHECK_FALSE(exists(timeline.furthest(), thing));
  }
}

TEST_CASE("why: with a run known in part, what is known is said and nothing else") {
  Timeline timeline(test_support::small_sphere(), test_support::small_parameters());
  CHECK_FALSE(made_by(timeline, StitchElement{1, 0}));
  CHECK(story_of(timeline, 5).fate == Fate::not_yet);
  std::size_t wrong = 0;
  while (timeline.extend(37)) {
    const State& run = timeline.furthest();
    for (const Element& thing :
         {Element(StitchElement{4, 3}), Element(FaceElement{3, 2}), Element(LabelElement{5, 1}),
          Element(LabelElement{5, 2}), Element(RowEdgeElement{4, 3})})
      wrong += exists(run, thing) == made_by(timeline, thing).has_value() ? 0U : 1U;
  }
  CHECK(wrong == 0);
}

TEST_CASE("why: every vertex of the mesh has a story that its steps bear out") {
  const Timeline timeline = small_run();
  std::map<Fate, int> fates;
  std::size_t wrong = 0;
  for (VertexId v = 0; v < timeline.input().mesh.positions.size(); ++v) {
    const VertexStory story = story_of(timeline, v);
    ++fates[story.fate];
    REQUIRE(story.decided);
    const Event& what = timeline.step(*story.decided).what;
    switch (story.fate) {
      case Fate::accepted: {
        const auto* s = knit::get_if<CandidateMeasured>(what);
        wrong += s != nullptr && s->candidate == v && s->verdict == Verdict::accepted ? 0U : 1U;
        // The stitch that it became was chosen there, and kept later.
        const StitchElement stitch{story.row, s != nullptr ? s->stitch : 0};
        const auto made = made_by(timeline, stitch);
        wrong += chosen_by(timeline, stitch) == story.decided && made && *made > *story.decided ? 0U : 1U;
        break;
      }
      case Fate::refused: {
        const auto* s = knit::get_if<CandidateMeasured>(what);
        wrong += s != nullptr && s->candidate == v && s->verdict != Verdict::accepted ? 0U : 1U;
        break;
      }
      case Fate::begins_row:
        wrong += knit::is<CycleOrdered>(what) ? 0U : 1U;
        break;
      case Fate::taken:
        wrong += knit::is<BandMissed>(what) ? 0U : 1U;
        break;
      case Fate::cast_on:
        wrong += knit::is<CycleFound>(what) ? 0U : 1U;
        break;
      default:
        wrong += get_if<VertexTimed>(what)->vertex == v ? 0U : 1U;
    }
  }
  CHECK(wrong == 0);
  CHECK(fates[Fate::accepted] > 50);
  CHECK(fates[Fate::refused] > 50);
  CHECK(fates[Fate::begins_row] > 5);
  CHECK(fates[Fate::no_row] >= 2);
  CHECK(fates[Fate::not_yet] == 0);
}

TEST_CASE("why: rows from contours have no candidates, and a vertex says so") {
  Parameters parameters = test_support::small_parameters();
  parameters.rows.source = RowSource::contours;
  const Timeline timeline = small_run(parameters);
  CHECK(story_of(timeline, 100).fate == Fate::cut_rows);
  CHECK(candidates_of(timeline, 3).none == NoCandidates::cut);
  CHECK(candidates_of(timeline, 1).none == NoCandidates::cut);
  CHECK(candidates_of(timeline, 300).none == NoCandidates::no_row);
}

TEST_CASE("why: the touching steps found by jumping are those found by walking the whole run") {
  Timeline timeline = small_run();
  std::mt19937 random(3);
  std::vector<Element> things = things_of(timeline.furthest());
  for (VertexId v = 0; v < 200; v += 7) things.emplace_back(VertexElement{v});
  std::size_t found = 0;
  for (int n = 0; n < 60; ++n) {
    const Element thing = things[random() % things.size()];
    CAPTURE(thing.index());
    const std::vector<std::size_t> walked = touching_steps(timeline, thing);
    std::vector<std::size_t> there;
    for (auto at = touch_from(timeline, thing, 0); at; at = touch_from(timeline, thing, *at + 1))
      there.push_back(*at);
    std::vector<std::size_t> back;
    for (auto at = touch_before(timeline, thing, timeline.known()); at;
         at = touch_before(timeline, thing, *at))
      back.insert(back.begin(), *at);
    CHECK(there == walked);
    CHECK(back == walked);
    CHECK_FALSE(walked.empty());
    found += walked.size();
  }
  CHECK(found > 200);
}

TEST_CASE("why: a stitch is touched by what measured, kept, labelled and joined it") {
  const Timeline timeline = small_run();
  const auto touching = touching_steps(timeline, StitchElement{5, 3});
  std::size_t measured = 0;
  std::size_t faces = 0;
  for (const std::size_t i : touching) {
    if (const auto* s = knit::get_if<CandidateMeasured>(timeline.step(i))) {
      ++measured;
      CHECK((s->stitch == 4 || (s->stitch == 3 && s->verdict == Verdict::accepted)));
    }
    faces += knit::is<FaceMade>(timeline.step(i)) ? 1U : 0U;
  }
  CHECK(measured >= 2);
  CHECK(faces >= 4);
}

TEST_CASE("candidates: one line a vertex of the ring, with the verdict of its last measuring") {
  Timeline timeline = small_run();
  for (std::int32_t row = 2; row <= static_cast<std::int32_t>(timeline.furthest().fabric.rows().size());
       ++row) {
    CAPTURE(row);
    const CandidateTable table = candidates_of(timeline, row);
    REQUIRE(table.none == NoCandidates::has_some);
    const Ring& ring = *ring_of_row(timeline.furthest(), row);
    REQUIRE(table.candidates.size() == ring.vertices.size());
    std::size_t chosen = 0;
    std::size_t wrong = 0;
    for (const Candidate& c : table.candidates) {
      wrong += ring.vertices[static_cast<std::size_t>(c.order)] == c.vertex ? 0U : 1U;
      wrong += c.verdict == CandidateVerdict::never_reached || c.step == no_step ? 1U : 0U;
      const bool inside = c.distance >= table.band.low && c.distance <= table.band.high;
      wrong += (c.verdict == CandidateVerdict::accepted) == inside ? 0U : 1U;
      wrong += c.verdict == CandidateVerdict::too_near && c.distance >= table.band.low ? 1U : 0U;
      const bool kept = c.verdict == CandidateVerdict::first || c.verdict == CandidateVerdict::accepted ||
                        c.verdict == CandidateVerdict::taken;
      chosen += kept ? 1U : 0U;
    }
    CHECK(wrong == 0);
    const auto closed = count_decided_by(timeline, row);
    REQUIRE(closed);
    if (const auto* s = knit::get_if<RowClosed>(timeline.step(*closed)))
      CHECK(static_cast<std::size_t>(s->stitches) == chosen);
  }
}

TEST_CASE("candidates: of a row in the making those not measured so far say so") {
  Timeline timeline(test_support::small_sphere(), test_support::small_parameters());
  while (!ring_of_row(timeline.furthest(), 4)) timeline.extend(1);
  timeline.extend(10);
  const CandidateTable table = candidates_of(timeline, 4);
  std::size_t reached = 0;
  for (const Candidate& c : table.candidates)
    reached += c.verdict == CandidateVerdict::never_reached ? 0U : 1U;
  CHECK(reached == 10);
  CHECK(candidates_of(timeline, 5).none == NoCandidates::no_row);
  CHECK(candidates_of(timeline, 1).none == NoCandidates::cast_on);
  Timeline fresh(test_support::small_sphere(), test_support::small_parameters());
  CHECK(candidates_of(fresh, 1).none == NoCandidates::cast_on);
}
