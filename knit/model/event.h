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

template <class T>
concept Counts = std::integral<T> && !std::same_as<T, bool>;

// One number, or word, of a step.
struct StepField {
  std::string_view name;  // "distance"
  std::variant<bool, std::int64_t, double, std::string> value;

  StepField(std::string_view called, Counts auto count)
      : name(called), value(static_cast<std::int64_t>(count)) {}
  StepField(std::string_view called, std::same_as<bool> auto yes) : name(called), value(yes) {}
  StepField(std::string_view called, double number) : name(called), value(number) {}
  StepField(std::string_view called, std::string_view word) : name(called), value(std::string(word)) {}
};
using StepFields = std::vector<StepField>;

// What ended with a step. The machine decides what follows; a stage knows only itself.
enum class Ended : std::uint8_t { step, row, stage };

// What a stage's smallest step did. When the stage has to stop, its work and its products are as before.
template <class StageEvent>
struct Advanced {
  std::variant<StageEvent, Stopped> what;
  Ended ended = Ended::step;

  template <class What>
    requires(!std::same_as<std::remove_cvref_t<What>, Advanced>)
  Advanced(What&& happened, Ended end = Ended::step) : what(std::forward<What>(happened)), ended(end) {}
};

}  // namespace knit
