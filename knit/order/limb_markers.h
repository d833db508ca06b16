// Where rounds begin. The yarn decides it: the marker stays where the yarn hangs, deals do not move it. It can be chosen only
// where a yarn begins: at a cast on before any stitch of the first row, at a rejoin before any held stitch.
//
// For each such start of a yarn the gap is climbed (limb_tubes.h) through all rows and deals that it is worked in, and summed:
//   60   short rows turn at it: they cannot be told from there
//   6    a split leaves it with the child that is held: the yarn is broken and rejoined
//   4    a tube in rhythm begins elsewhere than at a main: its repeats are cut in two
//   2    a rejoin elsewhere than at the first held stitch, or at the marker of a held piece
//   1.5  the loop waits for a join and is entered elsewhere than at its marker
//   1    a decrease across the marker: the last stitch is slipped back
// The least is taken, the first of equals. O(starts x (deals x stitches + pieces)).
#pragma once

#include <optional>
#include <vector>

#include "knit/order/limb_runs.h"

namespace knit {

struct LimbMarkers {
  // Of each tube, -1 where there is none: the gap in what it begins on, in its first row and in its last.
  std::vector<std::int32_t> base, first, last;
  // Of each step of each piece: the gap in the loop that is rejoined, or that is split; else -1.
  std::vector<std::vector<std::int32_t>> entered;
  std::vector<std::vector<std::uint8_t>> moved;  // of each step: the yarn is broken and rejoined there
  std::int32_t slips = 0, moves = 0;
};

// Nothing where no start keeps the marker.
std::optional<LimbMarkers> markers_of(const LimbTubes& tubes, const LimbRuns& runs);

// A tube's live loop as it waits on a holder: its last row, or what it begins on while it is not worked.
const Places& waiting_loop(const LimbTubes& tubes, std::int32_t tube, bool worked);

}  // namespace knit
