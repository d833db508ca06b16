// Pieces as they are written: those made together, what a piece says by another one's rounds, and a piece as plain rounds.
#pragma once

#include <cstdint>
#include <vector>

#include "knit/limbs/limb_plan.h"
#include "knit/pattern/limb_words.h"
#include "knit/pattern/rounds.h"

namespace knit {

// A cast on is round 1, so the rounds after it begin with 2.
inline std::int32_t first_round_of(const LimbPiece& piece) { return piece.is_cast_on() ? 2 : 1; }
Rounds rounds_of(const LimbPiece& piece);
std::vector<std::uint8_t> slips_of(const LimbPiece& piece);  // of each round

// Cast on and nothing else before its rounds.
bool begins_alone(const LimbPiece& piece);
bool are_twins(const LimbPlan& plan, std::int32_t a, std::int32_t b);
bool same_operations(const LimbRound& a, const LimbRound& b);

// Pieces in working order; twins that follow each other, are cast on and have the same words and work are one group.
std::vector<std::vector<std::int32_t>> groups_of(const LimbPlan& plan, const LimbNames& names);

// Which rounds of a twin before it say what to do: from this number on; 0: none.
std::int32_t alike_from(const LimbPiece& twin, const LimbPiece& piece);
// The twin before a piece whose rounds say what to do from `from` on; none: -1 and 0.
struct LimbModel {
  std::int32_t twin = -1, from = 0;
};
LimbModel model_of(const LimbPlan& plan, std::int32_t piece);

std::int32_t widest_of(const LimbPiece& piece);  // the most stitches

}  // namespace knit
