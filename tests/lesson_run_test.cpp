// Beginning, turning, skipping and leaving lessons; what is kept.
#include "app/actions/navigate.h"
#include "app/lessons/lesson_truths.h"
#include "app/script/command_line.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/measures.h"
#include "tests/support/lesson.h"

using namespace app;
using namespace test_support;

namespace {

Session in_lesson(const std::string& key = "what-it-does") {
  Session session = example_session("torus");
  apply(session, StartLesson{key});
  REQUIRE(session.learning->lesson);
  return session;
}

}  // namespace

TEST_CASE("leaving a lesson puts everything back as it was") {
  Session session = example_session("egg");
  knit::Parameters parameters = session.document->timeline.parameters();
  knit::give_epsilon(parameters, 0.03);
  apply(session, Tune{parameters});
  apply(session, SeekPlace{{knit::Stage::rows, 7, 20}});
  apply(session, SetLayer{Layer::wire, true});
  apply(session, Orbit{0.3, 0.1});
  apply(session, ShowSide{SidePanel::report});
  const knit::Place place = session.document->timeline.place();
  const Camera camera = session.view->gaze.camera;
  const auto layers = session.view->layers;
  apply(session, StartLesson{"where-it-breaks"});
  CHECK(session.document->source.example == "torus");
  apply(session, StartLesson{"picking-a-row"});  // from one into the next
  apply(session, SetTheme{ThemeKind::light});
  apply(session, LeaveLesson{});
  CHECK(!session.learning->lesson);
  CHECK(session.document->source.example == "egg");
  CHECK(session.document->timeline.parameters().epsilon() == 0.03);
  CHECK(session.document->timeline.place() == place);
  CHECK(session.view->gaze.camera == camera);
  CHECK(session.view->layers == layers);
  CHECK(session.view->side == SidePanel::report);
  CHECK(session.program->preferences.theme == ThemeKind::light);  // the program's own stays
  apply(session, Undo{});
  CHECK(session.document->timeline.parameters().epsilon() == session.document->defaults.epsilon());
}

TEST_CASE("a lesson that cannot be had changes nothing") {
  Session session = example_session("egg");
  apply(session, StartLesson{"cooking"});
  CHECK(!session.learning->lesson);
  REQUIRE(session.outbox->notices.size() == 1);
  CHECK(is_one_sentence(session.outbox->notices[0].text));
  apply(session, TurnLesson{1});
  apply(session, AnswerLesson{"4"});
  apply(session, LeaveLesson{});
  CHECK(session.document->source.example == "egg");
}

TEST_CASE("skipping goes on, says what was right, and does not count") {
  Session session = in_lesson();
  apply(session, AnswerLesson{"skip"});
  CHECK(lesson_of(session).outcome() == PageOutcome::skipped);
  apply(session, TurnLesson{1});
  CHECK(lesson_of(session).page == 1);
  apply(session, AnswerLesson{"skip"});
  CHECK(contains(lesson_of(session).progress.judgement->words, "vertex 0"));
  apply(session, AnswerLesson{"vertex:0"});  // too late
  CHECK(lesson_of(session).outcome() == PageOutcome::skipped);
  CHECK(lesson_of(session).score().right == 0);
  apply(session, TurnLesson{-1});
  CHECK(lesson_of(session).page == 0);
  apply(session, TurnLesson{-1});
  CHECK(lesson_of(session).page == 0);
}

TEST_CASE("an answer that is none is not counted as a try") {
  Session session = in_lesson();
  REQUIRE(!go_to_lesson_page(session, 6));
  apply(session, AnswerLesson{"a few"});
  CHECK(lesson_of(session).progress.judgement->said == Said::unclear);
  CHECK(lesson_of(session).progress.tries == 0);
  apply(session, AnswerLesson{"0,07"});  // a decimal comma will do
  CHECK(lesson_of(session).outcome() == PageOutcome::first_try);
  CHECK(session.program->preferences.lessons.at("what-it-does").right == 1);
}

TEST_CASE("the best score is kept, a worse one does not replace it") {
  Session session = in_lesson();
  session.program->preferences.lessons["what-it-does"] = LessonScore{3, 6};
  go_to_lesson_page(session, 6);
  apply(session, AnswerLesson{"0.07"});
  CHECK(session.program->preferences.lessons.at("what-it-does") == LessonScore{3, 6});
}

TEST_CASE("a page is set up again as it was") {
  Session session = in_lesson("picking-a-row");
  REQUIRE(!go_to_lesson_page(session, 7));
  CHECK(session.document->timeline.parameters().epsilon() == 0.012);
  set_by_text(session, "epsilon", "0.05");
  apply(session, SetLayer{Layer::surface, false});
  apply(session, TurnLesson{0});
  CHECK(session.document->timeline.parameters().epsilon() == 0.012);
  CHECK(session.view->shows(Layer::surface));
  CHECK(lesson_of(session).page == 6);
  CHECK(session.document->timeline.place().stage == knit::Stage::rows);
  CHECK(session.document->timeline.place().row == 64);
}

TEST_CASE("a page out of range is refused with the range") {
  Session session = in_lesson();
  for (const std::int32_t page : {0, -3, 12, 1000}) {
    const auto error = go_to_lesson_page(session, page);
    REQUIRE(error);
    CHECK(is_one_sentence(*error));
    CHECK(contains(*error, "1 to 11"));
  }
  CHECK(lesson_of(session).page == 0);
}

TEST_CASE("opening another mesh by hand ends the lesson and says so") {
  Session session = in_lesson();
  apply(session, OpenExample{"cone"});
  CHECK(!session.learning->lesson);
  CHECK(session.document->source.example == "cone");
  REQUIRE(!session.outbox->notices.empty());
  CHECK(contains(session.outbox->notices.back().text, "lesson"));
}

TEST_CASE("what a page waits for is seen when it happens, not before") {
  Session session = in_lesson("picking-a-row");
  const std::size_t from = session.document->timeline.position();
  for (int i = 0; i < 5; ++i) apply(session, StepBy{});
  CHECK(lesson_of(session).outcome() == PageOutcome::open);
  apply(session, StepBy{Unit::item, -1});
  apply(session, StepBy{});
  CHECK(lesson_of(session).outcome() == PageOutcome::open);
  apply(session, StepBy{});
  CHECK(session.document->timeline.position() == from + 6);
  CHECK(lesson_of(session).outcome() == PageOutcome::done);
}

TEST_CASE("in a window pages open while the run is worked out, and answers wait for it") {
  Session session = example_session("torus");
  session.jobs->beside = true;
  apply(session, StartLesson{"increases-and-decreases"});
  apply(session, AnswerLesson{"4"});
  CHECK(lesson_of(session).progress.judgement->said == Said::unclear);
  CHECK(lesson_of(session).progress.tries == 0);
  for (int i = 0; i < 5000 && (!session.document->timeline.complete() || session.document->timeline.sought());
       ++i)
    apply(session, PassTime{0.01});
  CHECK(session.document->timeline.place().stage == knit::Stage::stitches);
  apply(session, AnswerLesson{"4"});
  CHECK(lesson_of(session).outcome() == PageOutcome::first_try);
}

TEST_CASE("the command line begins a lesson at a page") {
  const auto parsed = parse_command_line(
      {"--example", "cone", "--lesson", "closing-a-row", "--lesson-page", "2"}, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<CommandLine>(parsed));
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  REQUIRE(!open_as_asked(session, std::get<CommandLine>(parsed)));
  CHECK(lesson_of(session).page == 1);
  apply(session, LeaveLesson{});
  CHECK(session.document->source.example == "cone");
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--lesson-page", "2"},
                                                {"--lesson", "closing-a-row", "--lesson-page", "no"}}) {
    const auto refused = parse_command_line(words, KNIT_ASSETS_DIR);
    REQUIRE(std::holds_alternative<Answer>(refused));
    CHECK(is_one_sentence(std::get<Answer>(refused).error));
  }
  const auto list = parse_command_line({"--list-lessons"}, KNIT_ASSETS_DIR);
  CHECK(lines_of(std::get<Answer>(list).out).size() == 12);
}

TEST_CASE("a what-if question asks what tuning would make of the run, changes on the way included") {
  Session session = small_session();
  apply(session, ToLast{});
  apply(session, SeekPlace{{knit::Stage::rows, 5, 0}});
  knit::Parameters edited = session.document->timeline.parameters();
  edited.rows.close = knit::Closing::none;
  apply(session, EditFromHere{edited});
  session.document->timeline.extend_to_end();
  REQUIRE(session.document->timeline.edits().size() == 1);
  const auto stitches_of = [](const knit::Timeline& timeline) {
    return std::to_string(timeline.furthest().fabric.stitch_count());
  };
  JudgeCall call;
  call.word = "stitches";
  call.settings = {{knit::find_parameter("stitch-width"), "0.4"}};
  const Truth truth = truths::what_if(session, call);

  knit::Timeline tuned = session.document->timeline;
  knit::Parameters wider = tuned.parameters();
  REQUIRE_FALSE(knit::set_values(call.settings, wider));
  tuned.tune(wider);
  tuned.extend_to_end();
  REQUIRE(stitches_of(tuned) != stitches_of(session.document->timeline));
  CAPTURE(truth.reason);
  CHECK(truth.reason.find(stitches_of(session.document->timeline) + " now, " + stitches_of(tuned) +
                          " with") != std::string::npos);
}
