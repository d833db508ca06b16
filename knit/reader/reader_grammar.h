// One line of a pattern as a tree: its label, what is worked, the count that it states, how it closes.
//
// Recursive descent over tokens, at most two repeats deep. Nothing is worked here: `pattern_work.h` does that.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "knit/reader/reader_words.h"

namespace knit {

// "Rnds 8-12:"; "Next rnd:" has no number.
struct RoundLabel {
  std::optional<std::int64_t> first;
  std::int64_t last = 0;
  std::size_t tokens = 0;  // that it takes up
  std::string mistake;     // what is wrong with the label, if anything: ": the colon ... is missing."
};
// Nothing where the line does not begin like a round.
std::optional<RoundLabel> label_of(std::span<const Token> line);

// Which marker is meant: whichever comes next, or one that has a name, at or ahead.
enum class MarkerName : std::uint8_t { next, side, front, back };
inline constexpr std::array<std::string_view, 4> marker_names{"next", "side", "front", "back"};

// A stitch or a repeat, worked `times` times or over and over until `tail` stitches are left.
struct WorkNode {
  std::optional<StitchKind> stitch;  // none: `inside`
  std::vector<WorkNode> inside;
  bool open = false;
  bool to_marker = false;  // up to `tail` stitches before the next marker, not `times` times
  bool varies = false;     // something inside goes up to a marker, so that what it takes depends on markers
  MarkerName marker = MarkerName::next;  // where `to_marker`
  std::int64_t times = 1, tail = 0;
  std::int64_t takes = 0, makes = 0;  // one time through; at most `most_number`
  bool bare = false;                  // "knit" without a number
  std::string words;                  // for messages: "k2tog", "the repeat"
};

struct RoundWords {
  std::vector<WorkNode> nodes;
  std::optional<std::int64_t> stated;  // "(30 sts)"
  std::string mistake;                 // empty, or what cannot be read: ": the bracket "[" is not closed."
};
// Whether "k to next m" means something: where markers are placed.
enum class MarkerWords : std::uint8_t { unknown, known };
// Of what stands between label and closing words.
RoundWords round_words(std::span<const Token> line, MarkerWords markers = MarkerWords::unknown);

// "CO 6 sts", "cast on 6 stitches": the number.
std::optional<std::int64_t> cast_on_in(std::span<const Token> line);
// The count at the line's end.
std::optional<std::int64_t> stated_in(std::span<const Token> line);

// "BO all", "thread through remaining 6 sts", "draw yarn through".
struct ClosingWords {
  std::size_t at = 0;                  // the first token that belongs to it
  std::optional<std::int64_t> number;  // of stitches, where it says one
};
std::optional<ClosingWords> closing_in(std::span<const Token> line);

}  // namespace knit
