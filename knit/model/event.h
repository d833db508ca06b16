// What a kind of step says of itself beside its numbers, so that the program can tell of it without knowing it.
//
// A kind of step is a struct in its stage's room: plain data of at most 32 bytes, with ==, and
//   static constexpr std::string_view kind    its name in step logs: "band-missed"
//   std::string sentence(const Telling&) const what was done, with its numbers
//   StepFields numbers() const                the same numbers by name
//   bool unusual(const Parameters&) const     whether it is worth a person's attention; left out: never
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "knit/model/settings.h"
#include "knit/model/stage.h"
#include "knit/model/stopped.h"

namespace knit {

// What a sentence may read beside the step's own numbers.
struct Telling {
  const Place& place;
  const Parameters& parameters;  // in force for the step
  [[nodiscard]] std::string row() const { return "Row " + std::to_string(place.row); }
};

// A variable of the pseudo-code. Each has one place in memory, which stands for it.
struct CodeVariable {
  std::string_view key;      // "epsilon": what actions and scripts call it
  std::string_view symbol;   // "ε", as in the thesis where it has one
  std::string_view meaning;  // one sentence
};

template <class T>
concept Counts = std::integral<T> && !std::same_as<T, bool>;

// A number's value, or a word.
struct StepValue : std::variant<bool, std::int64_t, double, std::string> {
  StepValue(std::same_as<bool> auto yes) : variant(yes) {}
  StepValue(Counts auto count) : variant(static_cast<std::int64_t>(count)) {}
  StepValue(double number) : variant(number) {}
  StepValue(std::string_view word) : variant(std::string(word)) {}
  StepValue(const char* word) : variant(std::string(word)) {}
};

// One number, or word, of a step, and the variable that has this value then.
struct StepField {
  std::string_view name;  // "distance", in step logs
  const CodeVariable* variable;
  StepValue value;

  StepField(const CodeVariable& is, StepValue number)
      : name(is.key), variable(&is), value(std::move(number)) {}
  // `is` null: the value of none.
  StepField(std::string_view called, const CodeVariable* is, StepValue number)
      : name(called), variable(is), value(std::move(number)) {}
};
using StepFields = std::vector<StepField>;

// An event of any stage, for what tells of all. Valid as long as its step.
struct AnyEvent {
  const Place& place;
  std::string_view kind;
  const void* event;

  // Null when something else happened.
  template <class What>
  [[nodiscard]] const What* get_if() const {
    return kind == What::kind ? static_cast<const What*>(event) : nullptr;
  }
};

// What ended with a step. The machine decides what follows; a stage knows only itself.
enum class Ended : std::uint8_t { step, row, stage };

// What a stage's smallest step did. When the stage has to stop, its work and its products are as before.
template <class StageEvent>
struct Advanced {
  std::variant<StageEvent, Stopped> what;
  Ended ended = Ended::step;

  template <class What>
    requires(!std::same_as<std::remove_cvref_t<What>, Advanced>)
  // NOLINTNEXTLINE(bugprone-forwarding-reference-overload): the constraint leaves copies to the others
  Advanced(What&& happened, Ended end = Ended::step) : what(std::forward<What>(happened)), ended(end) {}
};

}  // namespace knit
