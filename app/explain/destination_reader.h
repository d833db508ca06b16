// Reads where a person wants to go: "row 7", "round 12 of Leg A", "third k2tog of round 24", "why row 7". Only the words;
// what they lead to in a run is destination.h. Case does not matter; all numbers count from 1, but for vertices, which
// count as everywhere in the program.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace app {

// Which one of many: the `count`-th of all, or from the end, from here, or by how bad it is.
struct WhichOne {
  enum class Kind : std::uint8_t { nth, last, next, previous, worst };
  Kind kind = Kind::nth;
  std::int32_t count = 1;
  friend bool operator==(const WhichOne&, const WhichOne&) = default;
};

enum class Goal : std::uint8_t {
  row,        // number, or none: the one shown; `which` without a number: first, last, next, previous
  round,      // likewise, of `piece`
  stitch,     // number in the row; none: the one selected
  vertex,     // likewise
  step,       // number
  widest,     // row
  narrowest,  // row
  longest_wale,
  shortest_wale,
  change,     // from number to second: the row where the count of stitches goes so
  problem,    // which
  operation,  // which, of a row, after a row, or of all
  stop,       // why the run stopped
  at          // a place as --at has it
};

// What an operation is to be: one of the four, or any that makes stitches more or fewer.
enum class Shaping : std::uint8_t { k2tog, ssk, m1l, m1r, increase, decrease };

struct PlaceWish {
  Goal goal = Goal::row;
  bool why = false;     // what is there is asked for, not the way
  bool rounds = false;  // "round" was said where "row" could be
  WhichOne which;
  Shaping shaping = Shaping::k2tog;
  std::optional<std::int64_t> number, second;
  std::optional<std::int64_t> row;    // of a stitch, or an operation
  std::optional<std::int64_t> after;  // an operation comes after this row
  // An operation of one half of the run: up to the widest row with it, or after it.
  bool until_widest = false, after_widest = false;
  std::string piece;  // as typed, in small letters; empty: not said
  std::string at;
};

// Nothing where no form fits.
std::optional<PlaceWish> read_place_wish(const std::string& typed);

}  // namespace app
