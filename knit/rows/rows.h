// Stage 3, rows: Algorithm 2 picks a row's stitches from the ring's vertices by distance. Thesis 3.2.3.
//
// The anchor starts at the ring's first vertex. Each following vertex is measured against it; the first
// within [w - epsilon, w + epsilon] becomes the next anchor, and the old one is kept as a stitch. The printed
// lines never keep the last anchor; here it is kept. The metric says how distances are measured: straight
// through the air, along the ring, or along the surface; the walk is the same.
#pragma once

#include <tuple>
#include <vector>

#include "knit/fabric/stitch.h"
#include "knit/mesh/mesh.h"
#include "knit/model/products.h"
#include "knit/model/settings.h"
#include "knit/model/ties.h"
#include "knit/rows/ring_events.h"

namespace knit {

struct Band {
  double low, high;
};
inline Band band_of(const RowsSettings& rows, const StitchSize& stitch) {
  const double epsilon = rows.epsilon.of(stitch.width);
  return {stitch.width - epsilon, stitch.width + epsilon};
}

// Distances along the surface from an anchor to the places that follow it in the ring, the anchor first, and
// to the ring's first place.
struct Reach {
  std::vector<double> to_next;
  double to_first = 0.0;
  [[nodiscard]] auto fields() const { return std::tie(to_next, to_first); }
  friend bool operator==(const Reach&, const Reach&) = default;
};

// Algorithm 2 between two candidates. Orders are places in the ring.
struct Walk {
  std::vector<std::int32_t> kept;  // anchors left behind, so far
  std::int32_t anchor = 0;
  std::int32_t next = 0;  // the candidate to measure
  // Since the anchor was taken:
  std::int32_t nearest_order = -1;  // the candidate, not at the anchor itself, nearest to the stitch width
  double nearest_distance = 0.0;
  bool jumped = false;  // a candidate was too far, and none was accepted
  Shared<Reach> reach;  // geodesic metric: from the anchor, once something was measured
  [[nodiscard]] auto fields() const {
    return std::tie(kept, anchor, next, nearest_order, nearest_distance, jumped, reach);
  }
  friend bool operator==(const Walk&, const Walk&) = default;
};

// Measures walk.next against the anchor and moves on; requires walk.next to be in the ring.
CandidateMeasured measure_next(Walk& walk, const Ring& ring, const Input& input, const RowsSettings& rows,
                               const StitchSize& stitch);

// The robust continuation after a candidate that was too far: takes the one nearest to the stitch width since
// the anchor, within half the ring, and measures on from there.
BandMissed take_nearest(Walk& walk, const Ring& ring, const Input& input, const RowsSettings& rows,
                        const StitchSize& stitch);

// The same where the ring ends: its last vertex is too near the anchor, the way on to the first stitch too
// far. Nothing when the gap is no longer than the band, or nearer to the stitch width than that vertex.
std::optional<BandMissed> take_before_end(Walk& walk, const Ring& ring, const Input& input,
                                          const RowsSettings& rows, const StitchSize& stitch);

// What Algorithm 2 left: stitches as places in the ring.
struct ClosedRow {
  std::vector<std::int32_t> orders;
  std::vector<Stitch> stitches;  // at their vertices, or spread evenly where resampled
  double gap = 0.0;              // from the last stitch to the first, by the metric
  bool dropped_last = false;
  bool resampled = false;
  [[nodiscard]] auto fields() const { return std::tie(orders, stitches, gap, dropped_last, resampled); }
  friend bool operator==(const ClosedRow&, const ClosedRow&) = default;
};
ClosedRow close_row(const Walk& walk, const Ring& ring, const Input& input, const RowsSettings& rows,
                    const StitchSize& stitch);

// How many stitches the row must have instead: at least 3, at most twice and at least half the row below.
// Nothing when it may stay as it is.
struct NeededCount {
  std::int32_t count;
  ResampleReason reason;
};
std::optional<NeededCount> needed_count(std::int32_t picked, std::int32_t below, double ring_length,
                                        double stitch_width);

// Shares the closing gap g out, along the ring. none: as it is. thesis: when g lies outside the band, stitch
// i moves by i (g - w) / n; the printed formula moves every stitch alike, which only turns the row. arc:
// stitch i at i L / n.
struct SharedGap {
  std::vector<Stitch> stitches;
  bool shared = false;
  double per_stitch = 0.0;
  double gap = 0.0;  // afterwards
};
SharedGap share_gap(const ClosedRow& row, const Ring& ring, const RowsSettings& rows,
                    const StitchSize& stitch);

// Whether the walk ended with its anchor stuck: the rest of the ring skipped the band.
bool stalled(const Walk& walk);

// Whether a distance lies in the band; where rounding alone keeps it out, it is within.
inline Verdict verdict_on(double distance, const Band& band) {
  if (clearly_less(distance, band.low, band.high)) return Verdict::too_near;
  return clearly_less(band.high, distance, band.high) ? Verdict::too_far : Verdict::accepted;
}

}  // namespace knit
