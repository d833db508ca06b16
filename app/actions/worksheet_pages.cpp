#include "app/actions/worksheet_pages.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/actions/hosting.h"
#include "app/actions/navigate.h"
#include "app/base/text.h"
#include "app/lessons/lesson_judge.h"
#include "app/session/action.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/program.h"

namespace app {

namespace {

std::string with_colons_spaced(const std::string& thing) {
  std::string words;
  for (const std::string_view part : split(thing, ':'))
    words += (words.empty() ? "" : " ") + std::string(part);
  return words;
}

// In the words of the choices; "stitch:5:3" as the program's text of a thing.
std::string answer_words(const Question& question, const Truth& truth) {
  if (truth.answers.empty()) return "";
  const std::string& answer = truth.answers.front();
  const auto chosen = std::find_if(question.choices.begin(), question.choices.end(),
                                   [&](const AnswerChoice& choice) { return choice.key == answer; });
  if (chosen != question.choices.end()) return chosen->words;
  return is_clicked(question.kind) ? with_colons_spaced(answer) : answer;
}

std::string said_after(const std::string& first, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + " " + second;
}

SheetQuestion sheet_question(const Session& session, const Question& question) {
  SheetQuestion sheet;
  sheet.ask = question.ask;
  for (const AnswerChoice& choice : question.choices) sheet.choices.push_back(choice.words);
  sheet.marked = is_clicked(question.kind);
  const Truth truth = truth_of(session, question);
  sheet.answer = answer_words(question, truth);
  sheet.reason = said_after(truth.reason, question.after);
  return sheet;
}

// Nobody's own: what it opens, seeks and draws is of the sheet.
Session session_for_sheet(const Session& session) {
  Session own = new_session(session.program->assets);
  own.program->preferences.theme = ThemeKind::light;  // paper is white
  own.program->preferences.scale = 2.0;               // and the pictures are small
  apply(own, SetAspect{sheet_picture_aspect});
  own.learning->lesson = session.learning->lesson;
  return own;
}

}  // namespace

Worksheet worksheet_of(const Session& session, const TakePicture& take_picture) {
  const Lesson& lesson = *session.learning->lesson->lesson;
  Session own = session_for_sheet(session);
  Worksheet sheet{lesson.title, lesson.about, {}};
  for (std::size_t i = 0; i < lesson.pages.size(); ++i) {
    const LessonPage& page = lesson.pages[i];
    go_to_lesson_page(own, static_cast<std::int32_t>(i) + 1);
    make_whole(own);
    SheetPage one{page.title, page.text, page.wait ? page.wait->ask : "", std::nullopt, {}};
    if (page.question) one.question = sheet_question(own, *page.question);
    if (own.document) one.picture_png = take_picture(own);
    sheet.pages.push_back(std::move(one));
  }
  return sheet;
}

}  // namespace app
