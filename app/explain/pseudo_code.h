// The algorithm as short lines of pseudo-code, one listing a stage and way of doing it, and which line a step
// was. Plain data: the panel, --explain and tests read the same.
//
// In a line's text {name} stands for a variable of code_variables.h, shown by its symbol. A shown line is at
// most `most_code_columns` wide.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/session.h"

namespace app {

inline constexpr std::size_t most_code_columns = 44;

enum class Listing : std::uint8_t {
  timing_linear,
  timing_arc_length,
  timing_geodesic,
  timing_harmonic,
  cast_on,
  rows_rings,
  rows_contours,  // its first row, the cast on, too
  index_thesis,
  index_even,
  index_nearest,
  faces,
  pattern,
  count_
};
inline constexpr std::size_t listing_count = static_cast<std::size_t>(Listing::count_);

struct CodeLine {
  std::string_view text;
  std::string_view value;    // the variable whose value stands at the line's end; empty: none
  std::string_view meaning;  // a sentence or two
  std::string_view source;   // where it comes from: "Thesis 3.2.1, Algorithm 1, line 7"
  bool structural = false;   // a head that no step ends at: "for each ..."
};

struct PseudoCode {
  std::string_view title;                   // "Algorithm 2: a row from a ring"
  std::span<const CodeLine> lines;          // counted from 0
  std::span<const std::string_view> aside;  // variables that stand in no line
};

const PseudoCode& code_of(Listing listing);

// `parameters`: those in force for the step.
Listing listing_of(const knit::Step& step, const knit::Parameters& parameters);

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
  std::string_view text;  // of a variable: its name
};
std::vector<CodePart> parts_of(const CodeLine& line);
std::string shown_text(const CodeLine& line);  // with symbols

// The names of all variables of a listing, in reading order, each once.
std::vector<std::string_view> variable_names_of(Listing listing);

// What is explained at this place: the step shown, or why the run stopped; before the first step what comes.
struct Explained {
  const knit::Step* step = nullptr;  // null: nothing was done so far
  Listing listing = Listing::timing_linear;
  std::optional<LinesRun> lines;  // that just ran
  bool stopped = false;
};
// Nothing with nothing open.
std::optional<Explained> explained(const Session& session);

}  // namespace app
