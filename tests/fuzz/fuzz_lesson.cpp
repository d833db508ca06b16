// Lesson files: a lesson that can be held, or a sentence.
#include "app/lessons/lesson.h"
#include "app/lessons/lesson_judge.h"
#include "tests/fuzz/bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto read = app::read_lesson(fuzz::text_of(data, size));
  if (const auto* fault = std::get_if<std::string>(&read)) {
    fuzz::promise_sentence(*fault);
    return 0;
  }
  const auto& lesson = std::get<app::Lesson>(read);
  fuzz::promise(!lesson.key.empty() && !lesson.title.empty() && !lesson.pages.empty(), "a lesson has pages");
  std::int32_t questions = 0;
  for (const app::LessonPage& page : lesson.pages) {
    fuzz::promise(!page.title.empty() && !page.text.empty(), "a page has words");
    fuzz::promise(!(page.wait && page.question), "a page waits for one thing");
    if (!page.question) continue;
    ++questions;
    fuzz::promise(page.question->judge.judge < app::judge_table().size(), "a question has a judge");
    const std::size_t choices = page.question->choices.size();
    const bool chosen = page.question->kind == app::AnswerKind::choice;
    fuzz::promise(chosen ? choices >= 2 && choices <= 5 : choices == 0, "a choice has its answers");
  }
  fuzz::promise(questions == lesson.questions(), "questions are counted");
  return 0;
}
