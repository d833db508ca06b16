// What helps a person to learn: a lesson, guessing, the pseudo-code pointed at. Each is replaced whole when it
// changes; null: none.
#pragma once

#include <memory>
#include <string>

namespace app {

struct LessonRun;   // lesson.h
struct Prediction;  // predict.h

struct Learning {
  std::shared_ptr<const LessonRun> lesson;
  std::shared_ptr<const Prediction> prediction;
  std::string pointed_variable;  // of the pseudo-code, under the pointer; empty: none
  friend bool operator==(const Learning&, const Learning&) = default;
};

}  // namespace app
