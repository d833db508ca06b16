// The list of rows: what is said of each, in the window and as CSV.
//
// CSV: a header line and a line for each row that is worked out, whatever is shown: row (from 1), tube ("A"),
// stitches, change (against what the row is worked on; none: it is cast on), holds (its length in stitch widths: what
// it has room for), course (the mean length along it, in stitch widths), and with a pinned run pinned (its stitches).
// A value that is not there is empty.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "app/session/session.h"
#include "knit/fabric/fabric.h"
#include "knit/run/state.h"

namespace app {

struct RowFacts {
  std::int32_t stitches = 0;
  std::optional<std::int32_t> change;
  double holds = 0.0, course = 0.0;
  std::string tube;
};
// Cost: the row's stitches. A stitch width of 0, as a stopped run may have it: holds and course are 0.
RowFacts facts_of_row(const knit::Row& row, double stitch_width);

// Of the row in progress, with the anchor, which is a stitch from the moment that it is taken; 0: none is in progress.
std::size_t stitches_so_far(const knit::State& state);

// The stitches that the pinned run has in its row of this number; none: nothing is pinned, it is not known yet, or it
// has no such row.
std::optional<std::int32_t> pinned_stitches(const Session& session, std::int32_t row);

// Requires something open.
std::string rows_csv(const Session& session);

}  // namespace app
