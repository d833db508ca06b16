// Each shipped lesson, played to its end: what its pages wait for is done, and each question is answered by what its
// judge holds to be right, once at the first try and once after a wrong answer.
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "tests/support/lesson.h"
#include "tests/support/repeated.h"

using namespace app;
using namespace test_support;

namespace {

enum class Style { first_try, wrong_first };

void answer(Session& session, const Question& question, Style style) {
  const Truth truth = truth_of(session, question);
  INFO(truth.reason);
  REQUIRE(!truth.answers.empty());
  if (style == Style::wrong_first) {
    const std::string wrong = wrong_answer(session, question);
    apply(session, AnswerLesson{wrong});
    INFO(wrong);
    REQUIRE(lesson_of(session).progress.judgement);
    CHECK(lesson_of(session).progress.judgement->said == Said::wrong);
    CHECK(is_one_sentence(lesson_of(session).progress.judgement->words));
    CHECK(lesson_of(session).outcome() == PageOutcome::open);
  }
  apply(session, AnswerLesson{truth.answers.front()});
  REQUIRE(lesson_of(session).progress.judgement);
  CHECK(lesson_of(session).progress.judgement->said == Said::right);
  CHECK(is_one_sentence(truth.reason));
}

void do_page(Session& session, Style style) {
  const LessonPage& page = *lesson_of(session).shown();
  INFO("page " << lesson_of(session).page + 1 << ", " << page.title);
  CHECK(session.outbox->notices.empty());
  session.document->timeline.extend_to_end();
  const bool asks = page.wait || page.question;
  CHECK((lesson_of(session).outcome() == PageOutcome::open) == asks);
  const std::size_t number = lesson_of(session).page;
  if (asks) {
    apply(session, TurnLesson{1});
    REQUIRE(lesson_of(session).page == number);  // not without doing it
  }
  if (page.wait) do_wait(session, *page.wait);
  if (page.question) answer(session, *page.question, style);
  REQUIRE(lesson_of(session).outcome() != PageOutcome::open);
  apply(session, TurnLesson{1});
  REQUIRE(lesson_of(session).page == number + 1);
}

void play(const std::string& key, Style style) {
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  apply(session, StartLesson{key});
  INFO(key);
  REQUIRE(session.learning->lesson);
  const std::shared_ptr<const Lesson> lesson = session.learning->lesson->lesson;
  while (!lesson_of(session).at_end()) do_page(session, style);
  const std::int32_t right = style == Style::first_try ? lesson->questions() : 0;
  CHECK(lesson_of(session).score() == LessonScore{right, lesson->questions()});
  CHECK(session.program->preferences.lessons.at(key) == LessonScore{right, lesson->questions()});
}

void play_both(const std::string& key) {
  if (test_support::whole()) play(key, Style::first_try);
  play(key, Style::wrong_first);  // answers right too
}

}  // namespace

TEST_CASE("lesson: what the algorithm does, to its end") { play_both("what-it-does"); }
TEST_CASE("lesson: timing and axis, to its end") { play_both("timing-and-axis"); }
TEST_CASE("lesson: picking a row, to its end") { play_both("picking-a-row"); }
TEST_CASE("lesson: why the row closes badly, to its end") { play_both("closing-a-row"); }
TEST_CASE("lesson: increases and decreases, to its end") { play_both("increases-and-decreases"); }
TEST_CASE("lesson: where it breaks, to its end") { play_both("where-it-breaks"); }

TEST_CASE("lesson: where a tube parts and meets, to its end") { play_both("where-a-tube-parts"); }
TEST_CASE("lesson: why a handle needs a split and a join, to its end") { play_both("why-a-handle"); }
TEST_CASE("lesson: what a level set cannot know, to its end") { play_both("what-a-level-set-cannot-know"); }
TEST_CASE("lesson: what on a holder means, to its end") { play_both("on-a-holder"); }
TEST_CASE("lesson: why a heel needs short rows, to its end") { play_both("why-a-heel"); }
TEST_CASE("lesson: what the ideal mesh hides, to its end") { play_both("off-the-needles"); }

TEST_CASE("the shipped lessons can be read, are short, and ask") {
  const auto entries = list_lessons(KNIT_ASSETS_DIR);
  REQUIRE(entries.size() == 12);
  for (const LessonEntry& entry : entries) {
    INFO(entry.title << ": " << entry.about);
    REQUIRE(!entry.key.empty());
    const auto lesson = std::get<Lesson>(find_lesson(KNIT_ASSETS_DIR, entry.key));
    CHECK(lesson.pages.size() >= 6);
    CHECK(lesson.pages.size() <= 12);
    CHECK(lesson.questions() >= 2);
    for (const LessonPage& page : lesson.pages) {
      INFO(page.title);
      CHECK(page.text.size() <= 240);
      CHECK(page.title.size() <= 40);
      if (page.question) CHECK(!page.question->hint.empty());
      const bool begins = !page.deeds.empty() && std::holds_alternative<OpenAsItComes>(page.deeds.front());
      CHECK(begins);  // so that each page stands on its own
    }
  }
}

TEST_CASE("a lesson answers for what the person has made of the run, not for what its author saw") {
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  apply(session, StartLesson{"increases-and-decreases"});
  set_by_text(session, "stitch-width", "0.2");
  set_by_text(session, "epsilon", "0.1");
  const auto& rows = session.document->timeline.furthest().fabric.rows();
  const std::size_t now = rows[4]->stitches.size() - rows[3]->stitches.size();
  apply(session, AnswerLesson{"4"});
  const bool still = now == 4;
  CHECK((lesson_of(session).outcome() != PageOutcome::open) == still);
  apply(session, AnswerLesson{std::to_string(now)});
  CHECK(lesson_of(session).outcome() != PageOutcome::open);
}
