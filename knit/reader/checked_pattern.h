// What the checker says of a written pattern, line by line. Three verdicts that are never mixed:
//
//   holds           every line of work was worked, and every count that is stated is the one that comes out
//   does_not_add_up a line makes something else than it says, or cannot be worked on what is there
//   not_understood  a line of work, or a word of it, is unknown: nothing is claimed about what depends on it
//
// A pattern does not add up if one line does not, whatever else is unknown; it holds only if nothing is unknown.
// Lines count from 1, bytes within a line from 0. Errors are values; any text may be given.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knit {

enum class PatternVerdict : std::uint8_t { holds, does_not_add_up, not_understood };

enum class LineVerdict : std::uint8_t {
  holds,
  does_not_add_up,
  not_understood,
  not_claimed,  // work that hangs on a line which is not understood, and states nothing that could be held against it
  no_instruction,  // a title, a note, a gauge, a blank line
};

struct CheckedLine {
  std::size_t number = 1;
  LineVerdict verdict = LineVerdict::no_instruction;
  std::optional<std::int64_t>
      stitches;  // on the needles after it, of the size at hand, as worked whatever it says; none: not known, or no work
  std::string sentence;  // what is wrong or unknown: "line 12: Rnd 7 makes 29 stitches, the line says 30."
  std::size_t word_at = 0,
              word_length = 0;  // the place in the line that the sentence is about; length 0: all of it
  friend bool operator==(const CheckedLine&, const CheckedLine&) = default;
};

// A round or row as it came out, for a picture of the shape: the live stitches after it.
struct CheckedRound {
  std::size_t line = 1;
  std::int64_t stitches = 0;
  friend bool operator==(const CheckedRound&, const CheckedRound&) = default;
};

// From a cast on, or stitches taken again, to where its stitches are bound off or put aside.
struct CheckedPiece {
  std::string name;  // "Thumb"; empty: it has none
  std::int64_t made = 1;
  std::vector<CheckedRound> rounds;  // the cast on first
  bool flat = false;                 // worked in rows, to and fro
  friend bool operator==(const CheckedPiece&, const CheckedPiece&) = default;
};

// One of the sizes of "CO 80 (88, 96)"; a pattern without sizes has one, without a name.
struct CheckedSize {
  std::string name;  // "80", "88": its number where sizes first part
  PatternVerdict verdict = PatternVerdict::holds;
  std::vector<CheckedLine> lines;  // every line of the text
  std::vector<CheckedPiece> pieces;
  friend bool operator==(const CheckedSize&, const CheckedSize&) = default;
};

struct CheckedPattern {
  PatternVerdict verdict =
      PatternVerdict::holds;  // the worst of its sizes: does_not_add_up before not_understood before holds
  std::vector<CheckedSize> sizes;  // at least one
  std::size_t worked = 0, not_understood = 0,
              no_instructions = 0;  // lines; not_understood has those not claimed too
  std::size_t rounds = 0;           // rounds and rows worked, without cast ons, of the first size
  std::string
      remark;  // what it is instead of knitting ("This is crochet: ..."), or on what repeat it was worked
  bool is_pattern = true;  // false: no line of work is in it
  friend bool operator==(const CheckedPattern&, const CheckedPattern&) = default;
};

// This program's own words are worked to the graph of stitches where they tell pieces or short rows. Those of one tube are
// held to their counts here as the world's are; that they lead to the very graph is read_pattern's to hold, which the round
// trips of tests do for each form (words and short form, stars, Markdown, page, knitspeak).
//
// Any text: plain, Markdown, HTML or knitspeak, of this program or of the world. O(tokens and stitches).
CheckedPattern check_pattern(std::string_view text);

}  // namespace knit
