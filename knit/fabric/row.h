// A row of stitches. Stitch order is working order: counter-clockwise seen along the direction of knitting, which
// is clockwise seen from the needles, right side out (a right-handed knitter's order).
//
// A short row is worked over a stretch of its tube's loop and turned at its end; its stitches stand one on each of the
// stretch. They are kept in the loop's order whichever way they are worked, so that a column is a place in both; only the
// knitting path runs through a row worked back the other way.
#pragma once

#include <optional>
#include <vector>

#include "knit/fabric/edges.h"
#include "knit/fabric/live_stitches.h"
#include "knit/model/products.h"
#include "knit/model/shared.h"

namespace knit {

// What a row is besides when it is worked over a stretch.
struct ShortRow {
  StitchRef before,
      after;          // that hang beside the stretch while it is worked; the one its turn stands at is marked
  bool back = false;  // from the stretch's last stitch to its first, the wrong side facing
  [[nodiscard]] const StitchRef& marked() const { return back ? before : after; }
  [[nodiscard]] auto fields() const { return std::tie(before, after, back); }
  friend bool operator==(const ShortRow&, const ShortRow&) = default;
};

struct Row {
  TubeId tube = 0;  // that it belongs to; today there is one
  RowId id = 1;
  LiveStitches on;         // what it is worked on; none: it is cast on
  std::int32_t level = 0;  // of the levels, or of the cuts planned
  double time = 0.0;
  Shared<Ring> ring;               // the curve that the stitches stand on
  std::vector<Stitch> stitches;    // at least 3
  bool closed = true;              // to a ring
  std::optional<ShortRow> turned;  // a short row; then it is not closed
  [[nodiscard]] auto fields() const {
    return std::tie(tube, id, on, level, time, ring, stitches, closed, turned);
  }
  friend bool operator==(const Row&, const Row&) = default;
};

inline bool is_short(const Row& row) { return row.turned.has_value(); }

inline bool works_back(const Row& row) { return is_short(row) && row.turned->back; }

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
