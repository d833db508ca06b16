// What a round of the world's patterns says to work, as a tree, and the count it states.
//
// Recursive descent over atoms; at most `most_depth` brackets deep. A word that is not known ends the reading: it is
// told, and nothing is claimed of the round. Nothing is worked here: world_needle.h does that.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "knit/trade/world_words.h"

namespace knit {

struct WorldNode {
  enum class Kind : std::uint8_t {
    stitch,
    repeat,
    place_marker,
    slip_marker,
    remove_marker,
    shape,     // `makes` more stitches, or fewer, spread as one likes; all that is left is worked
    rest,      // all that is left, as it is
    hold,      // `times` stitches onto a holder; 0: all that are left
    take,      // off a holder, and worked
    add,       // cast on or picked up in the round
    bind_off,  // `times` stitches; 0: all that are left
    turn,      // the rest stays unworked
    insert     // `times` stitches with waste yarn, then slipped back; `makes` 1: and worked again
  };
  enum class Until : std::uint8_t { times, end, marker };
  Kind kind = Kind::stitch;
  Until until = Until::times;
  std::int64_t takes = 0, makes = 0, times = 1;
  std::optional<std::int64_t> tail;  // stitches left before the end or the marker; none: what the rest needs
  std::vector<WorldNode> inside;
  std::string name;                // of a holder
  bool next = false;               // up to the next marker, past one that is here
  bool plain = false;              // knit or purl without a number
  bool live = false;               // taken, but not told to be held: they may be on the needle already
  bool vague = false;              // "inc"
  bool numbered = false;           // "k1", not "k"
  std::size_t at = 0, length = 0;  // bytes of the line
};

// What a line says of the stitches at its end.
struct WorldCount {
  std::optional<std::int64_t> total, change;
  std::vector<std::int64_t> all;  // "(16, 24, 32 sts)"
};

struct WorldRound {
  std::vector<WorldNode> nodes;
  WorldCount count;
  std::string trouble;  // empty, or what is not understood: "the word "kint" is not known."
  std::size_t at = 0, length = 0;
  bool choice = false;  // "k1, kfb to end" can be meant in two ways
};

// The count is taken off the end of `line`.
WorldCount take_count(Atoms& line, const Lexicon& lexicon);
// `other`: the second way where there is a choice.
WorldRound world_round(std::span<const Atom> line, const Lexicon& lexicon, bool other);

// "first leg": without words for stitches and holders.
std::string world_name(std::span<const Atom> atoms);

}  // namespace knit
