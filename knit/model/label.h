// The labels of the stitch index, those of short rows, and the rules by which they were placed.
#pragma once

#include <cstdint>

namespace knit {

// The thesis's integers, and on from them. turn_left: the last stitch of a short row on the right side; turn_right: of one on
// the wrong side; marked: worked as one with the double stitch or the wrap that a turn left on it.
enum class Label : std::uint8_t {
  knit = 0,
  m1r = 1,
  m1l = 2,
  k2tog = 3,
  ssk = 4,
  cast = 5,
  main = 6,
  turn_left = 7,
  turn_right = 8,
  marked = 9
};
inline bool is_increase(Label label) { return label == Label::m1r || label == Label::m1l; }
inline bool is_decrease(Label label) { return label == Label::k2tog || label == Label::ssk; }
inline bool is_turn(Label label) { return label == Label::turn_left || label == Label::turn_right; }
inline bool is_shaping(Label label) { return is_increase(label) || is_decrease(label); }

// How mains were spaced; names as in docs/algorithm.md.
enum class Rule : std::uint8_t {
  from_cast_on,
  plain,
  equal,
  follow,
  remainder_last,
  dense,
  even,
  nearest,
  repeat
};

}  // namespace knit
