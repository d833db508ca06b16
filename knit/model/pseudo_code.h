// The algorithm as short lines of pseudo-code: what a listing, a line and a variable are. The listings stand in
// the rooms of the stages that they tell of, as tables: a row says its words, its variables and which events
// were this line. Nothing else knows a line by its number or a variable by its name.
//
// In a line's text {} stands for its next variable, shown by its symbol. A shown line is at most
// `most_code_columns` wide.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "knit/model/event.h"

namespace knit {

inline constexpr std::size_t most_code_columns = 44;

// --- Which events a line is ---------------------------------------------------------------------------------

// Says whether an event was this line. A step was all lines from the first to the last of those.
using Lit = bool (*)(const AnyEvent&);

inline bool never(const AnyEvent& /*event*/) { return false; }

template <class... Kinds>
bool lit_by(const AnyEvent& event) {
  return ((event.get_if<Kinds>() != nullptr) || ...);
}

namespace code_parts {
template <class What, class Field>
What class_of(Field What::*);
}  // namespace code_parts

// By events whose member has one of these values.
template <auto member, auto... values>
bool lit_if(const AnyEvent& event) {
  const auto* what = event.get_if<decltype(code_parts::class_of(member))>();
  return what != nullptr && ((what->*member == values) || ...);
}

template <StopReason... reasons>
bool lit_by_stop(const AnyEvent& event) {
  return lit_if<&Stopped::reason, reasons...>(event);
}

template <Lit... each>
bool lit_or(const AnyEvent& event) {
  return (each(event) || ...);
}

// --- Lines and listings -------------------------------------------------------------------------------------

struct CodeLine {
  std::string_view text;
  std::array<const CodeVariable*, 5> variables;  // one a {}, in reading order, then null
  const CodeVariable* value;                     // whose value stands at the line's end; null: none
  std::string_view meaning;                      // a sentence or two
  std::string_view source;                       // where it comes from: "Thesis 3.2.1, Algorithm 1, line 7"
  Lit lit = never;
  bool structural = false;  // a head that no step ends at: "for each ..."
};

// A listing a stage and way of doing it.
struct PseudoCode {
  std::array<Stage, 2> stages;                 // that it tells of; mostly the same twice
  bool (*chosen)(const Parameters&);           // whether the stage is done this way
  std::string_view title;                      // "Algorithm 2: a row from a ring"
  std::span<const CodeLine> lines;             // counted from 0
  std::span<const CodeVariable* const> aside;  // variables that stand in no line

  [[nodiscard]] bool tells_of(Stage stage) const { return stages[0] == stage || stages[1] == stage; }
};

inline bool always(const Parameters& /*parameters*/) { return true; }

}  // namespace knit
