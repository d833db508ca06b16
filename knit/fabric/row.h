// A row of stitches. Stitch order is working order: counter-clockwise seen along the direction of knitting, which
// is clockwise seen from the needles, right side out (a right-handed knitter's order).
#pragma once

#include <vector>

#include "knit/fabric/edges.h"
#include "knit/fabric/live_stitches.h"
#include "knit/model/products.h"
#include "knit/model/shared.h"

namespace knit {

struct Row {
  TubeId tube = 0;  // that it belongs to; today there is one
  RowId id = 1;
  LiveStitches on;         // what it is worked on; none: it is cast on
  std::int32_t level = 0;  // of the levels, or of the cuts planned
  double time = 0.0;
  Shared<Ring> ring;             // the curve that the stitches stand on
  std::vector<Stitch> stitches;  // at least 3
  bool closed = true;            // to a ring
  [[nodiscard]] auto fields() const { return std::tie(tube, id, on, level, time, ring, stitches, closed); }
  friend bool operator==(const Row&, const Row&) = default;
};

inline std::int32_t size_of(const Row& row) { return static_cast<std::int32_t>(row.stitches.size()); }

// All of a row, as it hangs on the needle when it is worked.
inline LiveStitches all_of(const Row& row) { return {{{row.id, 0, size_of(row)}}, row.closed}; }

inline Edges edges_of(const Row& row) { return {row.stitches.size(), row.closed}; }

// The stitch beside one of a row; at the end of a row that is not closed, the stitch itself.
inline const Stitch& after(const Row& row, std::size_t i) {
  const bool last = i + 1 == row.stitches.size();
  return row.stitches[!last ? i + 1 : row.closed ? 0 : i];
}
inline const Stitch& before(const Row& row, std::size_t i) {
  return row.stitches[i > 0 ? i - 1 : row.closed ? row.stitches.size() - 1 : i];
}

}  // namespace knit
