// The debugging story of docs/debugging.md, played as a script of actions: an epsilon that is too small, seen,
// understood and repaired.
#include <algorithm>

#include "app/actions/apply_parts.h"
#include "app/compare/sweep_work.h"
#include "app/session/document.h"
#include "app/session/run_figures.h"
#include "knit/insight/candidates.h"
#include "knit/insight/problems.h"
#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

namespace {

knit::ProblemRanking problems_of(const knit::Timeline& timeline) {
  knit::ProblemRanking ranking;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    if (const auto problem = knit::problem_of(timeline.step(i), i, timeline.parameters_of_step(i)))
      ranking.take(*problem);
  }
  ranking.finish();
  return ranking;
}

// The first value from which on no run has a problem.
std::size_t first_sound_run(const SweepWork& work) {
  std::size_t first = work.total();
  while (first > 0 && work.run(first - 1)->figures.problems.total() == 0 &&
         work.run(first - 1)->figures.finished)
    --first;
  return first;
}

}  // namespace

TEST_CASE("the story: from a stall to an epsilon without one, at the same place") {
  Session session = test_support::example_session("thesis-sphere");
  const auto act = [&](const Action& action) { app::apply(session, action); };
  knit::Parameters narrow = session.document->timeline.parameters();
  knit::give_epsilon(narrow, 0.012);
  act(Tune{narrow});
  act(ToLast{});

  // Something is wrong: the list says what, worst first.
  const knit::ProblemRanking problems = problems_of(session.document->timeline);
  REQUIRE(problems.size() > 0);
  for (std::size_t i = 1; i < problems.size(); ++i) CHECK(problems[i - 1].kind <= problems[i].kind);

  // To the first stall.
  act(ToFirst{});
  act(SetBreaks{{std::get<knit::BreakCondition>(knit::parse_break("stall"))}});
  act(RunToBreak{1});
  const knit::Step* step = last_step(session);
  REQUIRE(step != nullptr);
  const auto* stall = knit::get_if<knit::BandMissed>(*step);
  REQUIRE(stall != nullptr);
  const knit::Place place = step->place;
  INFO(sentence(session));

  // The candidates show the gap: the band lies between two neighbours.
  const knit::CandidateTable table = knit::candidates_of(session.document->timeline, place.row);
  CHECK(table.band.low == Approx(0.1 - 0.012));
  const auto& taken = table.candidates.at(static_cast<std::size_t>(stall->taken_order));
  CHECK(taken.verdict == knit::CandidateVerdict::taken);
  CHECK((taken.distance < table.band.low || taken.distance > table.band.high));
  const auto in_the_band = [&](const knit::Candidate& c) {
    return c.stitch == stall->stitch && c.distance >= table.band.low && c.distance <= table.band.high;
  };
  CHECK(std::none_of(table.candidates.begin(), table.candidates.end(), in_the_band));

  // Why not the one on the other side of the band? What decided on it comes later; the step that touched it
  // before is the one that found it too far. And back again.
  const knit::Step& before = session.document->timeline.step(session.document->timeline.position() - 2);
  const auto refused = *knit::get_if<knit::CandidateMeasured>(before);
  CHECK(refused.verdict == knit::Verdict::too_far);
  CHECK(refused.distance > table.band.high);
  act(ShowWhy{knit::VertexElement{refused.candidate}});
  CHECK(session.document->timeline.place() > place);
  act(ToTouch{-1});
  while (session.document->timeline.place() > before.place) act(ToTouch{-1});
  CHECK(session.document->timeline.place() == before.place);
  while (session.document->timeline.place() != place && !session.document->travel.history.behind.empty())
    act(GoBack{});
  CHECK(session.document->timeline.place() == place);

  // From which epsilon on is there none?
  act(StartSweep{{{"epsilon", 0.005, 0.05, 46}, std::nullopt}});
  REQUIRE(session.document->sweep);
  session.document->sweep->work->wait();
  const std::size_t sound = first_sound_run(*session.document->sweep->work);
  REQUIRE(sound > 0);
  REQUIRE(sound < session.document->sweep->work->total());
  const double epsilon = session.document->sweep->work->run(sound)->values.front();
  CHECK(epsilon > 0.012);
  CHECK(session.document->sweep->work->run(sound - 1)->figures.problems.total() > 0);

  // Take it: the same place is shown, and no problem is left.
  act(TakeSweepValue{sound});
  act(PassTime{});
  CHECK(session.document->timeline.parameters().epsilon() == Approx(epsilon));
  CHECK(session.document->timeline.place().row == place.row);
  CHECK(session.document->timeline.place().stage == place.stage);
  act(ToLast{});
  CHECK(session.document->timeline.furthest().finished());
  CHECK(problems_of(session.document->timeline).size() == 0);
  CHECK(stop_shown(session) == nullptr);

  // And back: undo leads to the run with the stall.
  act(Undo{});
  CHECK(session.document->timeline.parameters().epsilon() == 0.012);
}
