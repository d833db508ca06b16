// Entries about learning: lessons, guessing, and every word of the glossary.
#include <array>

#include "app/core/action_entries_parts.h"
#include "app/core/glossary.h"

namespace app {

namespace {

using Read = std::variant<Action, std::string>;

constexpr const char* learning = "Learning";
constexpr const char* the_glossary = "The glossary";

void add_lessons(EntryList& list, const ActionSources& sources) {
  for (const ActionSources::Lesson& lesson : sources.lessons) {
    list.add({"Lesson: " + lesson.title, learning, "", StartLesson{lesson.key}});
  }
  const std::string none = list.session.lesson ? "" : "No lesson is under way.";
  list.add({"Next page of the lesson", learning, "", TurnLesson{1}, none});
  list.add({"Page before in the lesson", learning, "", TurnLesson{-1}, none});
  list.add({"Answer the lesson's question...", learning, "",
            ActionPrompt{"Answer", "12",
                         [](const Session& /*session*/, const std::string& typed) -> Read {
                           if (typed.empty()) return "Give an answer.";
                           return AnswerLesson{typed};
                         }},
            none});
  list.add({"Leave the lesson", learning, "", LeaveLesson{}, none});
}

void add_guessing(EntryList& list) {
  const bool on = list.session.prediction != nullptr;
  list.add({"Guess before each verdict: on or off", learning,
            "Predict mode: playing pauses before each verdict, and you say what it will be.",
            SetPredicting{!on}, list.unless_open()});
}

}  // namespace

void add_learning_entries(EntryList& list, const ActionSources& sources) {
  add_lessons(list, sources);
  add_guessing(list);
  for (const Term& term : glossary()) {
    const std::string word(term.word);
    list.add({"What is meant by: " + word, the_glossary, "", ShowGlossary{true, word}, "", "", true});
  }
}

}  // namespace app
