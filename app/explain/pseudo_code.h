// The listings of all stages' rooms, which line of them a step was, and what is explained at a place of the run.
// Plain data: the panel, --explain and tests read the same.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/session.h"
#include "knit/model/pseudo_code.h"

namespace app {

using knit::CodeLine;
using knit::PseudoCode;

// By stages, in calling order.
std::span<const PseudoCode* const> listings();

// `parameters`: those in force for the step. What the step shows of how it was done counts for more than they do,
// because they may have been edited meanwhile.
const PseudoCode& listing_of(const knit::Step& step, const knit::Parameters& parameters);

// A step may be several lines: from the first of them to the one that it ended at.
struct LinesRun {
  std::size_t first = 0, last = 0;
  [[nodiscard]] bool holds(std::size_t line) const { return first <= line && line <= last; }
  friend bool operator==(const LinesRun&, const LinesRun&) = default;
};
LinesRun lines_of(const knit::Step& step, const knit::Parameters& parameters);
// The line that just ran.
std::size_t line_of(const knit::Step& step, const knit::Parameters& parameters);

// The pieces of a line, in reading order.
struct CodePart {
  enum class Kind : std::uint8_t { plain, keyword, variable } kind = Kind::plain;
  std::string_view text;  // of a variable: its symbol
  const knit::CodeVariable* variable = nullptr;
};
std::vector<CodePart> parts_of(const CodeLine& line);
std::string shown_text(const CodeLine& line);  // with symbols

// All variables of a listing, in reading order, each once.
std::vector<const knit::CodeVariable*> variables_in(const PseudoCode& code);

// What is explained at this place: the step shown, or why the run stopped; before the first step what comes.
struct Explained {
  const knit::Step* step = nullptr;  // null: nothing was done so far
  const PseudoCode* code = nullptr;
  std::optional<LinesRun> lines;  // that just ran
  bool stopped = false;
};
// Nothing with nothing open.
std::optional<Explained> explained(const Session& session);

}  // namespace app
