// Short rows in words: `Short row 1 (RS): K5, turn. (5 sts after BOR)`, and what of a round is worked after them.
//
// German short rows: the stitch beyond the row is worked too, turned, and pulled up to a double stitch (DS), which counts
// one. Wrap and turn (w&t): that stitch is wrapped. Both make the same fabric.
#pragma once

#include <vector>

#include "knit/pattern/written_pattern.h"

namespace knit {

// All lines of a round that has pairs: its short rows, the way home to the beginning of the round, and the round or the rest of
// it. Nothing where pairs stand alone before the round: then its own line is an ordinary one, which `round_lines` adds.
struct ShortRowLines {
  std::vector<RoundLine> lines;
  bool rest_is_told = false;  // the last line is "Rnd 8 (cont.)"
};
ShortRowLines short_row_lines(const Round& round, ShortRowTurns turns);

}  // namespace knit
