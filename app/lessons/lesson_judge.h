// Who judges the answers of lessons: from the state and the steps of the current run.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/lessons/lesson.h"

namespace app {

// What a judge must be told in the file; tube: its letter.
enum class JudgeNeeds : std::uint8_t { nothing, row, word, row_and_word, change, tube };

// What is right here, or why that cannot be said.
struct Truth {
  std::vector<std::string> answers;  // any of them; empty: there is no answer here
  std::string reason;                // why they are right; without an answer: why there is none
  double slack = 0.0;                // numbers: how far off may be; vertices: how far away, in mesh units
};

struct JudgeInfo {
  std::string_view name;
  std::string_view about;  // for authors
  std::vector<AnswerKind> kinds;
  JudgeNeeds needs = JudgeNeeds::nothing;
  std::vector<std::string_view> words;  // that it knows: as its "of", or as keys of choices
  Truth (*truth)(const Session&, const JudgeCall&);
  // Why another answer is not right; empty: nothing more than the hint.
  std::string (*why_not)(const Session&, const JudgeCall&, const std::string& answer);
};
std::span<const JudgeInfo> judge_table();

// Of the current question in the current run.
Truth truth_of(const Session& session, const Question& question);
Judgement judge(const Session& session, const Question& question, const std::string& answer);

// The row of a thing, by its text ("stitch:5:3"), or of "row:5"; 0: it has none.
std::int32_t row_of_answer(const std::string& answer);

}  // namespace app
