// What hands do, round by round, read from a join's labels: the words of the thesis's pattern (3.2.5) without their
// spelling. Stage pattern counts them; knit/pattern folds and writes them.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "knit/fabric/join.h"

namespace knit {

enum class Hand : std::uint8_t { knit, m1r, m1l, k2tog, ssk };

// The hand that works a cell of this label, a decrease's partner apart.
Hand hand_of(Label label);

// Stitches of the round before that one operation takes, and stitches that it makes.
std::int32_t consumed_by(Hand hand);
std::int32_t made_by(Hand hand);

struct Operation {
  Hand hand = Hand::knit;
  bool at_main = false;  // it works a main stitch
  friend bool operator==(const Operation&, const Operation&) = default;
};

// Two short rows between a round and the next: from stitch `first` to stitch `last` of the round below, there and back, each
// stitch on one. `first` < 0: from so many stitches before the beginning of the round (BOR) to `last` >= 0 behind it.
struct ShortRowPair {
  std::int32_t first = 0, last = 0;
  friend auto operator<=>(const ShortRowPair&, const ShortRowPair&) = default;
};

// In working order. The cell that a decrease takes in is part of the decrease.
std::vector<Operation> operations_of(const Join& join);

// What the operations take and make, summed one by one: for a sound join its `below` and `above`.
struct OperationCount {
  std::int32_t consumed = 0, produced = 0;
};
OperationCount count(std::span<const Operation> operations);

}  // namespace knit
