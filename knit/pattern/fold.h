// A round's operations as a person reads them: runs counted, patterns that come again folded into repeats.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "knit/pattern/rounds.h"

namespace knit {

// `count` times the same operation: K4. Increases and decreases stand alone unless repeated.
struct Run {
  Hand hand = Hand::knit;
  std::int32_t count = 1;
  bool marker = false;  // a marker is slipped before it
  friend bool operator==(const Run&, const Run&) = default;
};
// [K4, m1l] 6 times. Not nested: a repeat holds runs only.
struct Repeat {
  std::vector<Run> runs;
  std::int32_t times = 2;
  friend bool operator==(const Repeat&, const Repeat&) = default;
};
using Phrase = std::variant<Run, Repeat>;

struct FoldOptions {
  bool markers = false;  // a marker before every main stitch; runs then never cross one
};

// The shortest way to write the operations, counted in words: a run is one word and its marker another, a
// repeat is its runs and one more. Of equally short ones the one with the fewest repeats, then the one whose
// repeats begin earliest. A knit run may be cut where a repeat begins, ends or meets itself
// (K2, [K4, m1l] 5 times, K2); in a round with markers none is. Only knit runs have a count above 1; a repeat
// takes in at most 16 runs. Written out they give the operations back (but for at_main).
std::vector<Phrase> fold(std::span<const Operation> operations, const FoldOptions& options = {});

}  // namespace knit
