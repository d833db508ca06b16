#include "knit/rows/rows.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/mesh/surface_distance.h"
#include "knit/rows/ring.h"

namespace knit {

namespace {

VertexId vertex(const Ring& ring, std::int32_t order) {
  return ring.vertices[static_cast<std::size_t>(order)];
}
const glm::dvec3& position(const Ring& ring, std::int32_t order) {
  return ring.points[static_cast<std::size_t>(order)];
}
double arc(const Ring& ring, std::int32_t order) { return ring.arc[static_cast<std::size_t>(order)]; }

void move_anchor(Walk& walk, std::int32_t to) {
  walk.kept.push_back(walk.anchor);
  walk.anchor = to;
  walk.nearest_order = -1;
  walk.nearest_distance = 0.0;
  walk.jumped = false;
  walk.reach = {};
}

double gap_of(const std::vector<Stitch>& stitches) {
  return glm::distance(stitches.back().position, stitches.front().position);
}

// Along the surface from one place of the ring to another, however far.
double surface_distance(const Ring& ring, const Input& input, std::int32_t from, std::int32_t to) {
  const VertexId target = vertex(ring, to);
  return surface_distances(input, vertex(ring, from), std::span(&target, 1)).front();
}

// As many candidates as a stitch is likely to pass over, in one go.
Reach reach_from(const Ring& ring, const Input& input, std::int32_t anchor, double far) {
  std::vector<VertexId> targets;
  const auto size = static_cast<std::int32_t>(ring.vertices.size());
  for (std::int32_t order = anchor; order < size; ++order) {
    targets.push_back(vertex(ring, order));
    if (arc(ring, order) - arc(ring, anchor) > 2.0 * far) break;
  }
  targets.push_back(ring.vertices.front());
  Reach reach{surface_distances(input, vertex(ring, anchor), targets, far), 0.0};
  reach.to_first = reach.to_next.back();
  reach.to_next.pop_back();
  return reach;
}

// From the anchor to a place after it, by the metric. To the first place, across the closing gap: order 0.
double measured(Walk& walk, const Ring& ring, const Input& input, const RowsSettings& rows,
                const StitchSize& stitch, std::int32_t order) {
  const bool across_gap = order == 0 && walk.anchor != 0;
  switch (rows.metric) {
    case Metric::euclidean:
      return glm::distance(position(ring, walk.anchor), position(ring, order));
    case Metric::arc:
      return (across_gap ? ring.length : arc(ring, order)) - arc(ring, walk.anchor);
    case Metric::geodesic:
      break;
  }
  if (!walk.reach) {
    const double far = 1.5 * band_of(rows, stitch).high;
    walk.reach = Shared(reach_from(ring, input, walk.anchor, far));
  }
  const auto reach = walk.reach.pointer();
  const auto ahead = static_cast<std::size_t>(order - walk.anchor);
  const double known = reach == nullptr                ? not_reached
                       : across_gap                    ? reach->to_first
                       : ahead < reach->to_next.size() ? reach->to_next[ahead]
                                                       : not_reached;
  return known < not_reached ? known : surface_distance(ring, input, walk.anchor, order);
}

// The closing gap, from the place `last` to the first, by the metric.
double closing_gap(const Ring& ring, const Input& input, const RowsSettings& rows, const StitchSize& stitch,
                   std::int32_t last) {
  Walk at_last;
  at_last.anchor = last;
  return last == 0 ? 0.0 : measured(at_last, ring, input, rows, stitch, 0);
}

}  // namespace

CandidateMeasured measure_next(Walk& walk, const Ring& ring, const Input& input, const RowsSettings& rows,
                               const StitchSize& stitch) {
  const Band band = band_of(rows, stitch);
  const std::int32_t candidate = walk.next++;
  const double d = candidate == walk.anchor ? 0.0 : measured(walk, ring, input, rows, stitch, candidate);
  const Verdict verdict = verdict_on(d, band);
  const CandidateMeasured step{vertex(ring, walk.anchor),
                               vertex(ring, candidate),
                               walk.anchor,
                               candidate,
                               static_cast<std::int32_t>(walk.kept.size()) + 1,
                               verdict,
                               d};
  if (verdict == Verdict::accepted) {
    move_anchor(walk, candidate);
    return step;
  }
  const double w = stitch.width;
  const bool nearer =
      walk.nearest_order < 0 || clearly_less(std::abs(d - w), std::abs(walk.nearest_distance - w), w);
  if (d > 0.0 && nearer) {
    walk.nearest_order = candidate;
    walk.nearest_distance = d;
  }
  walk.jumped = walk.jumped || verdict == Verdict::too_far;
  return step;
}

BandMissed take_nearest(Walk& walk, const Ring& ring, const Input& input, const RowsSettings& rows,
                        const StitchSize& stitch) {
  // Only the candidate just measured was too far. It and the one before stand on either side of the band.
  const std::int32_t far = walk.next - 1;
  const double w = stitch.width;
  std::int32_t near = far - 1;
  while (near > walk.anchor && arc(ring, near) <= arc(ring, walk.anchor)) --near;
  const double far_distance = measured(walk, ring, input, rows, stitch, far);
  const double near_distance = near > walk.anchor ? measured(walk, ring, input, rows, stitch, near) : -1.0;

  const bool far_too_long = arc(ring, far) - arc(ring, walk.anchor) > 0.5 * ring.length;
  const bool take_near =
      near > walk.anchor && (far_too_long || !clearly_less(far_distance - w, w - near_distance, w));
  const std::int32_t taken = take_near ? near : far;
  const BandMissed missed{vertex(ring, walk.anchor),
                          vertex(ring, taken),
                          static_cast<std::int32_t>(walk.kept.size()) + 1,
                          taken,
                          take_near ? near_distance : far_distance,
                          take_near ? far_distance : near_distance};
  move_anchor(walk, taken);
  walk.next = taken + 1;
  return missed;
}

std::optional<BandMissed> take_before_end(Walk& walk, const Ring& ring, const Input& input,
                                          const RowsSettings& rows, const StitchSize& stitch) {
  auto last = static_cast<std::int32_t>(ring.vertices.size()) - 1;
  while (last > walk.anchor && position(ring, last) == position(ring, 0)) --last;  // copies of the first
  Walk looking = walk;  // what is measured on the way must not stay behind when nothing is taken
  const double gap = walk.anchor == 0 ? 0.0 : measured(looking, ring, input, rows, stitch, 0);
  const double near = last == walk.anchor ? 0.0 : measured(looking, ring, input, rows, stitch, last);
  const double w = stitch.width;
  if (near == 0.0 || verdict_on(gap, band_of(rows, stitch)) != Verdict::too_far) return std::nullopt;
  if (clearly_less(gap - w, std::abs(near - w), w)) return std::nullopt;
  const BandMissed missed{vertex(ring, walk.anchor),
                          vertex(ring, last),
                          static_cast<std::int32_t>(walk.kept.size()) + 1,
                          last,
                          near,
                          gap};
  move_anchor(walk, last);
  return missed;
}

bool stalled(const Walk& walk) { return walk.jumped || walk.kept.size() + 1 < 3; }

ClosedRow close_row(const Walk& walk, const Ring& ring, const Input& input, const RowsSettings& rows,
                    const StitchSize& stitch) {
  ClosedRow row;
  row.orders = walk.kept;
  row.orders.push_back(walk.anchor);
  const auto gap = [&] { return closing_gap(ring, input, rows, stitch, row.orders.back()); };
  if (rows.last_anchor == LastAnchor::drop && row.orders.size() > 3 && gap() < 0.5 * stitch.width) {
    row.orders.pop_back();
    row.dropped_last = true;
  }
  row.gap = gap();
  for (const std::int32_t order : row.orders)
    row.stitches.push_back({position(ring, order), vertex(ring, order)});
  return row;
}

std::optional<NeededCount> needed_count(std::int32_t picked, std::int32_t below, double ring_length,
                                        double stitch_width) {
  const std::int32_t most = 2 * below;
  const std::int32_t least = std::max(3, (below + 1) / 2);
  if (picked < 3) {
    const double ideal = rounded(ring_length / stitch_width);
    const auto count = static_cast<std::int32_t>(std::clamp(ideal, double(least), double(most)));
    return NeededCount{count, ResampleReason::too_few};
  }
  if (picked > most) return NeededCount{most, ResampleReason::more_than_double};
  if (picked < least) return NeededCount{least, ResampleReason::less_than_half};
  return std::nullopt;
}

SharedGap share_gap(const ClosedRow& row, const Ring& ring, const RowsSettings& rows,
                    const StitchSize& stitch) {
  SharedGap result{row.stitches, false, 0.0, row.gap};
  if (row.resampled) return result;
  const auto n = static_cast<std::int32_t>(row.stitches.size());
  if (rows.close == Closing::arc) {
    result.stitches = spread_evenly(ring, n);
    result.per_stitch = ring.length / n;
    result.shared = true;
  } else if (rows.close == Closing::thesis) {
    if (verdict_on(row.gap, band_of(rows, stitch)) == Verdict::accepted) return result;
    result.per_stitch = (row.gap - stitch.width) / n;
    for (std::int32_t i = 1; i < n; ++i) {
      const double from = arc(ring, row.orders[static_cast<std::size_t>(i)]);
      result.stitches[static_cast<std::size_t>(i)] = {point_at(ring, from + i * result.per_stitch),
                                                      no_vertex};
    }
    result.shared = true;
  }
  result.gap = gap_of(result.stitches);
  return result;
}

}  // namespace knit
