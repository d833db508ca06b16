// A round and the short rows before it in the order of the yarn: passes, each from turn to turn.
//
// Pairs over the beginning of the round (BOR) come first, the widest last. They stand alone: out from the BOR, back past it,
// and in the end out to the BOR again. The others follow by their rising first stitch, within the round. A pass takes the
// next thing that its column still lacks: a short row's stitch while there is one, then the round's own. So before the first
// short row of those the round is worked already, with its shaping, and the rest of it after the last turn.
// Columns are the stitches of the round below, from 0; before the BOR they are counted from -1 down.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "knit/pattern/rounds.h"

namespace knit {

struct PassStitch {
  std::int32_t column = 0;  // that it stands on; of an increase, the one it follows
  bool in_short_row = true;
  Operation operation;  // of the round
};

struct Pass {
  // Where it ends: turned on the right side, or on the wrong side; at the BOR; with the round.
  enum class End : std::uint8_t { right_side, wrong_side, home, round };
  End end = End::round;
  std::vector<PassStitch> stitches;  // in working order
  std::int32_t change = 0;           // stitches on the needles afterwards, less those before the round
  [[nodiscard]] bool wrong_side() const { return end == End::wrong_side; }
  [[nodiscard]] bool turns() const { return end == End::right_side || end == End::wrong_side; }
};

// Whether every pair has 3 stitches and leaves 2, lies over the BOR or a stitch away from it, and turns between two plain
// stitches of the round.
bool can_be_worked(const Round& round);
// Whether columns are plain: knitted, with no increase before or after.
std::vector<bool> plain_columns(std::span<const Operation> operations);

// Requires can_be_worked. O(stitches of the round and of its short rows).
std::vector<Pass> passes_of(const Round& round);

}  // namespace knit
