// Guessing: playing and stepping pause before each verdict, rows do not, and a guess is held against the step.
#include "app/lessons/predict.h"

#include "app/describe/describe.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/model/words.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;

namespace {

// At the first place where a vertex is measured next.
Session at_a_verdict() {
  Session session = small_session();
  apply(session, SeekPlace{{knit::Stage::rows, 2, 1}});
  apply(session, SetPredicting{true});
  REQUIRE(asked_vertex(session));
  return session;
}

knit::Verdict coming(const Session& session) {
  return knit::get_if<knit::CandidateMeasured>(
             session.document->timeline.step(session.document->timeline.position()))
      ->verdict;
}

knit::Verdict another(knit::Verdict verdict) {
  return verdict == knit::Verdict::accepted ? knit::Verdict::too_near : knit::Verdict::accepted;
}

void play_on(Session& session, int ticks = 60) {
  for (int i = 0; i < ticks; ++i) apply(session, PassTime{0.05});
}

}  // namespace

TEST_CASE("guessing is off by default, and does nothing without a run") {
  Session session;
  CHECK(!session.learning->prediction);
  apply(session, SetPredicting{true});
  apply(session, Guess{knit::Verdict::accepted});
  CHECK(!asked_vertex(session));
  apply(session, PassTime{0.1});
  Session run = small_session();
  apply(run, SeekPlace{{knit::Stage::rows, 2, 1}});
  const std::size_t position = run.document->timeline.position();
  apply(run, Guess{knit::Verdict::too_near});
  CHECK(run.document->timeline.position() == position);
}

TEST_CASE("a guess takes the step and is told right or wrong with its sentence") {
  Session session = at_a_verdict();
  const std::size_t position = session.document->timeline.position();
  apply(session, Guess{coming(session)});
  CHECK(session.document->timeline.position() == position + 1);
  REQUIRE(session.learning->prediction->told);
  CHECK(session.learning->prediction->told->right);
  CHECK(session.learning->prediction->told->words == sentence(session));
  CHECK(session.learning->prediction->streak == 1);
  REQUIRE(asked_vertex(session));
  apply(session, Guess{another(coming(session))});
  CHECK(!session.learning->prediction->told->right);
  CHECK(session.learning->prediction->streak == 0);
  CHECK(session.learning->prediction->guessed == 2);
  CHECK(session.learning->prediction->right == 1);
  CHECK(session.program->preferences.longest_streak == 1);
}

TEST_CASE("the longest streak outlives the guessing") {
  Session session = at_a_verdict();
  for (int i = 0; i < 5; ++i) apply(session, Guess{coming(session)});
  CHECK(session.learning->prediction->streak == 5);
  apply(session, SetPredicting{false});
  CHECK(!session.learning->prediction);
  apply(session, SetPredicting{true});
  CHECK(session.learning->prediction->streak == 0);
  CHECK(session.program->preferences.longest_streak == 5);
}

TEST_CASE("playing pauses before each verdict and goes on after the guess") {
  Session session = small_session();
  apply(session, SetPredicting{true});
  apply(session, SetSpeed{fastest_steps_per_second});
  apply(session, SetPlaying{true});
  play_on(session);
  REQUIRE(asked_vertex(session));  // the first verdict of the run
  CHECK(session.document->timeline.place() == knit::Place{knit::Stage::rows, 2, 1});
  CHECK(!session.view->playback.playing);
  for (int guess = 0; guess < 200; ++guess) {
    REQUIRE(asked_vertex(session));
    apply(session, Guess{knit::Verdict::accepted});
    CHECK(session.view->playback.playing);
    play_on(session, 3);
  }
  // Every verdict on the way was asked for, and over the rows' ends it played by itself.
  std::size_t measured = 0;
  for (std::size_t i = 0; i < session.document->timeline.position(); ++i)
    measured += knit::is<knit::CandidateMeasured>(session.document->timeline.step(i)) ? 1U : 0U;
  CHECK(measured == 200);
  CHECK(session.learning->prediction->guessed == 200);
  CHECK(session.document->timeline.place().row > 2);
}

TEST_CASE("to step on lets a verdict go without counting it, rows and stages are not asked about") {
  Session session = at_a_verdict();
  const std::size_t position = session.document->timeline.position();
  apply(session, StepDeep{Depth::into, 1});
  CHECK(session.document->timeline.position() == position + 1);
  CHECK(session.learning->prediction->guessed == 0);
  REQUIRE(asked_vertex(session));
  apply(session, StepBy{Unit::row, 1});
  CHECK(session.document->timeline.place().row == 2);
  apply(session, StepDeep{Depth::over, 1});  // over a whole row
  CHECK(session.document->timeline.place().row == 3);
  apply(session, StepBy{Unit::stage, 1});
  CHECK(session.document->timeline.place().stage == knit::Stage::rows);
  CHECK(session.learning->prediction->guessed == 0);
  apply(session, ToLast{});
  CHECK(!asked_vertex(session));
}

TEST_CASE("what was told goes away with its step, and a person who steps is not played on") {
  Session session = at_a_verdict();
  apply(session, SetPlaying{true});
  play_on(session, 2);
  apply(session, StepBy{});
  apply(session, Guess{coming(session)});
  CHECK(!session.view->playback.playing);
  CHECK(session.learning->prediction->told);
  apply(session, StepBy{});
  CHECK(!session.learning->prediction->told);
}

TEST_CASE("playing backwards asks nothing") {
  Session session = at_a_verdict();
  apply(session, StepBy{Unit::row, 1});
  apply(session, SetPlaying{true, -1});
  play_on(session, 4);
  CHECK(session.document->timeline.place() < knit::Place{knit::Stage::rows, 2, 20});
}

TEST_CASE("the view marks the vertex that is asked about and does not say how far it is") {
  Session session = at_a_verdict();
  apply(session, Guess{coming(session)});
  apply(session, Guess{coming(session)});
  const AskedVertex asked = *asked_vertex(session);
  Describer describer;
  const Scene scene = describer.describe(session);
  const auto& step = *knit::get_if<knit::CandidateMeasured>(
      session.document->timeline.step(session.document->timeline.position()));
  const glm::vec3 at(session.document->timeline.input().mesh.positions[asked.candidate]);
  const std::string distance = knit::short_number(step.distance);
  int marks = 0;
  for (const Caption& caption : scene.captions) {
    CHECK(caption.text != distance);
    marks += caption.text == "?" && caption.position == at ? 1 : 0;
  }
  CHECK(marks == 1);
}

TEST_CASE("in a window the next verdict is known before it is asked about") {
  Session session = small_session();
  session.jobs->beside = true;
  apply(session, SetPredicting{true});
  apply(session, SeekPlace{{knit::Stage::rows, 3, 5}});
  for (int i = 0; i < 200 && session.document->timeline.sought(); ++i) apply(session, PassTime{0.01});
  REQUIRE(asked_vertex(session));
  apply(session, Guess{coming(session)});
  CHECK(session.learning->prediction->streak == 1);
}
