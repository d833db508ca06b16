// Playing lessons as a person would: doing what a page waits for, and answering its questions.
#pragma once

#include <glm/geometric.hpp>

#include "app/lessons/lesson_judge.h"
#include "app/lessons/predict.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "knit/model/settings_table.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

namespace test_support {

inline const app::LessonRun& lesson_of(const app::Session& session) {
  REQUIRE(session.learning->lesson);
  return *session.learning->lesson;
}

inline void set_by_text(app::Session& session, const std::string& key, const std::string& value) {
  knit::Parameters parameters = session.document->timeline.parameters();
  REQUIRE(!knit::set_value(*knit::find_parameter(key), parameters, value));
  app::apply(session, app::Tune{parameters});
  session.document->timeline.extend_to_end();
  app::apply(session, app::PassTime{0.0});
}

inline void do_named(app::Session& session, const std::string& name) {
  REQUIRE(name == "orbit");
  app::apply(session, app::Orbit{0.2, 0.1});
}

// As a hand would find it: one value after another, until the page is content.
inline void try_settings(app::Session& session,
                         const std::vector<std::pair<std::string, std::string>>& tries) {
  for (const auto& [key, value] : tries) {
    if (lesson_of(session).outcome() != app::PageOutcome::open) return;
    set_by_text(session, key, value);
  }
}

inline void guess_on(app::Session& session) {
  for (int i = 0; i < 200 && lesson_of(session).outcome() == app::PageOutcome::open; ++i) {
    if (app::asked_vertex(session)) {
      app::apply(session, app::Guess{knit::Verdict::accepted});
    } else {
      app::apply(session, app::StepBy{});
    }
  }
}

inline void do_wait(app::Session& session, const app::Wait& wait) {
  switch (wait.kind) {
    case app::WaitKind::steps:
      for (std::int64_t i = 0; i < wait.count; ++i) app::apply(session, app::StepBy{});
      return;
    case app::WaitKind::reach:
      return app::apply(session, app::SeekPlace{wait.place});
    case app::WaitKind::did:
      return do_named(session, wait.word);
    case app::WaitKind::guesses:
      return guess_on(session);
    case app::WaitKind::at_end:
      return app::apply(session, app::ToLast{});
    case app::WaitKind::value:
      return set_by_text(session, std::string(wait.parameter->key), wait.word);
    case app::WaitKind::stopped:
      return try_settings(session, {{"on-stall", "continue"}, {"rows", "contours"}});
    case app::WaitKind::row_size:
    case app::WaitKind::problems:
      return try_settings(session, {{"epsilon", "0.045"}, {"epsilon", "0.04"}, {"epsilon", "0.06"}});
    case app::WaitKind::range:
    case app::WaitKind::changed:
      break;
  }
  FAIL("no shipped lesson waits for that");
}

inline std::string far_vertex(const app::Session& session, const std::string& right) {
  const auto& positions = session.document->timeline.input().mesh.positions;
  const std::size_t from = std::stoul(right.substr(7));
  std::size_t farthest = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (glm::distance(positions[v], positions[from]) > glm::distance(positions[farthest], positions[from]))
      farthest = v;
  }
  return "vertex:" + std::to_string(farthest);
}

// One that the judge must refuse.
inline std::string wrong_answer(const app::Session& session, const app::Question& question) {
  const auto truth = app::truth_of(session, question);
  REQUIRE(!truth.answers.empty());
  const auto is_right = [&](const std::string& answer) {
    return std::find(truth.answers.begin(), truth.answers.end(), answer) != truth.answers.end();
  };
  switch (question.kind) {
    case app::AnswerKind::choice:
      for (const app::AnswerChoice& choice : question.choices) {
        if (!is_right(choice.key)) return choice.key;
      }
      break;
    case app::AnswerKind::number:
      return std::to_string(std::stod(truth.answers.front()) + 1.0);
    case app::AnswerKind::vertex:
      return far_vertex(session, truth.answers.front());
    case app::AnswerKind::row:
      for (int row = 2; row < 64; ++row) {
        if (!is_right("row:" + std::to_string(row))) return "row:" + std::to_string(row);
      }
      break;
    case app::AnswerKind::stitch: {
      const std::string row = truth.answers.front().substr(0, truth.answers.front().rfind(':') + 1);
      for (int stitch = 1; stitch < 200; ++stitch) {
        if (!is_right(row + std::to_string(stitch))) return row + std::to_string(stitch);
      }
    }
  }
  FAIL("every answer is right");
  return "";
}

}  // namespace test_support
