// What lies on the needle before and after the rounds of each piece, stitch by stitch, with where it comes from and where it
// goes. Worked out from the plan's deals alone: needle and holders are lists that the deals part and put together.
// Invariant: a needle has as many stitches as the deal says that it has after it. O(stitches of all loops).
#pragma once

#include <cstdint>
#include <vector>

#include "knit/limbs/limb_plan.h"

namespace knit {

enum class NeedleUse : std::uint8_t { kept, taken, cast_on, picked_up };

struct NeedleStitch {
  NeedleUse use = NeedleUse::kept;
  std::int32_t piece = -1;   // of whose last round it is (of a provisional cast on the first); -1: of a gap
  std::int32_t gap = 0;      // from 1; 0: of a piece
  std::int32_t stitch = 0;   // in that round from the marker, or in that gap; from 0
  std::int32_t holder = -1;  // taken: the piece that the holder goes by
  friend bool operator==(const NeedleStitch&, const NeedleStitch&) = default;
};

struct PieceNeedle {
  std::vector<NeedleStitch> begin;  // before its first round, from the marker; of a cast on empty
  std::vector<std::int32_t>
      set_aside;              // of each stitch of its last round: for whom it is held; -1: it is not
  std::int32_t held = 0;      // holders in use when its first round begins
  std::int32_t entered = -1;  // of its last round, if that is held: the stitch that is worked first
  std::int32_t next = -1;     // the piece that works its last round first; -1: it closes
  friend bool operator==(const PieceNeedle&, const PieceNeedle&) = default;
};

// One for each piece of the plan.
std::vector<PieceNeedle> needles_of(const LimbPlan& plan);
// Holders in use at once at most, also while stitches are dealt.
std::int32_t holders_needed(const LimbPlan& plan);

}  // namespace knit
