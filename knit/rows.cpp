#include "knit/rows.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/ring.h"

namespace knit {

namespace {

const glm::dvec3& position(const Ring& ring, const Mesh& mesh, std::int32_t order) {
  return mesh.positions[ring.vertices[static_cast<std::size_t>(order)]];
}

VertexId vertex(const Ring& ring, std::int32_t order) {
  return ring.vertices[static_cast<std::size_t>(order)];
}

void move_anchor(Walk& walk, std::int32_t to) {
  walk.kept.push_back(walk.anchor);
  walk.anchor = to;
  walk.nearest_order = -1;
  walk.nearest_distance = 0.0;
  walk.jumped = false;
}

double gap_of(const std::vector<Stitch>& stitches) {
  return glm::distance(stitches.back().position, stitches.front().position);
}

}  // namespace

CandidateMeasured measure_next(Walk& walk, const Ring& ring, const Mesh& mesh, const Parameters& parameters) {
  const Band band = band_of(parameters);
  const std::int32_t candidate = walk.next++;
  const double d = glm::distance(position(ring, mesh, walk.anchor), position(ring, mesh, candidate));
  const Verdict verdict = d < band.low    ? Verdict::too_near
                          : d > band.high ? Verdict::too_far
                                          : Verdict::accepted;
  const CandidateMeasured measured{vertex(ring, walk.anchor),
                                   vertex(ring, candidate),
                                   walk.anchor,
                                   candidate,
                                   static_cast<std::int32_t>(walk.kept.size()) + 1,
                                   verdict,
                                   d};
  if (verdict == Verdict::accepted) {
    move_anchor(walk, candidate);
    return measured;
  }
  const double w = parameters.stitch_width;
  const bool nearer = walk.nearest_order < 0 || std::abs(d - w) < std::abs(walk.nearest_distance - w);
  if (d > 0.0 && nearer) {
    walk.nearest_order = candidate;
    walk.nearest_distance = d;
  }
  walk.jumped = walk.jumped || verdict == Verdict::too_far;
  return measured;
}

BandMissed take_nearest(Walk& walk, const Ring& ring, const Mesh& mesh, const Parameters& parameters) {
  // Only the candidate just measured was too far. It and the one before stand on either side of the band.
  const std::int32_t far = walk.next - 1;
  const double w = parameters.stitch_width;
  const auto arc = [&](std::int32_t order) { return ring.arc[static_cast<std::size_t>(order)]; };
  std::int32_t near = far - 1;
  while (near > walk.anchor && arc(near) <= arc(walk.anchor)) --near;
  const glm::dvec3& anchor = position(ring, mesh, walk.anchor);
  const double far_distance = glm::distance(anchor, position(ring, mesh, far));
  const double near_distance = near > walk.anchor ? glm::distance(anchor, position(ring, mesh, near)) : -1.0;

  const bool far_too_long = arc(far) - arc(walk.anchor) > 0.5 * ring.length;
  const bool take_near = near > walk.anchor && (far_too_long || w - near_distance <= far_distance - w);
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

std::optional<BandMissed> take_before_end(Walk& walk, const Ring& ring, const Mesh& mesh,
                                          const Parameters& parameters) {
  const glm::dvec3& first = position(ring, mesh, 0);
  auto last = static_cast<std::int32_t>(ring.vertices.size()) - 1;
  while (last > walk.anchor && position(ring, mesh, last) == first) --last;  // copies of the first
  const glm::dvec3& anchor = position(ring, mesh, walk.anchor);
  const double gap = glm::distance(anchor, first);
  const double near = glm::distance(anchor, position(ring, mesh, last));
  if (near == 0.0 || gap <= band_of(parameters).high) return std::nullopt;
  if (std::abs(near - parameters.stitch_width) > gap - parameters.stitch_width) return std::nullopt;
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

ClosedRow close_row(const Walk& walk, const Ring& ring, const Mesh& mesh, const Parameters& parameters) {
  ClosedRow row;
  row.orders = walk.kept;
  row.orders.push_back(walk.anchor);
  const auto gap = [&] {
    return glm::distance(position(ring, mesh, row.orders.back()), position(ring, mesh, row.orders.front()));
  };
  if (parameters.last_anchor == LastAnchor::drop && row.orders.size() > 3 &&
      gap() < 0.5 * parameters.stitch_width) {
    row.orders.pop_back();
    row.dropped_last = true;
  }
  row.gap = gap();
  for (const std::int32_t order : row.orders)
    row.stitches.push_back({position(ring, mesh, order), vertex(ring, order)});
  return row;
}

std::optional<NeededCount> needed_count(std::int32_t picked, std::int32_t below, double ring_length,
                                        double stitch_width) {
  const std::int32_t most = 2 * below;
  const std::int32_t least = std::max(3, (below + 1) / 2);
  if (picked < 3) {
    const double ideal = std::round(ring_length / stitch_width);
    const auto count = static_cast<std::int32_t>(std::clamp(ideal, double(least), double(most)));
    return NeededCount{count, ResampleReason::too_few};
  }
  if (picked > most) return NeededCount{most, ResampleReason::more_than_double};
  if (picked < least) return NeededCount{least, ResampleReason::less_than_half};
  return std::nullopt;
}

SharedGap share_gap(const ClosedRow& row, const Ring& ring, const Mesh& mesh, const Parameters& parameters) {
  SharedGap result{row.stitches, false, 0.0, row.gap};
  if (row.resampled) return result;
  const auto n = static_cast<std::int32_t>(row.stitches.size());
  if (parameters.close == Closing::arc) {
    result.stitches = spread_evenly(ring, mesh, n);
    result.per_stitch = ring.length / n;
    result.shared = true;
  } else if (parameters.close == Closing::thesis) {
    const Band band = band_of(parameters);
    if (row.gap >= band.low && row.gap <= band.high) return result;
    result.per_stitch = (row.gap - parameters.stitch_width) / n;
    for (std::int32_t i = 1; i < n; ++i) {
      const double arc = ring.arc[static_cast<std::size_t>(row.orders[static_cast<std::size_t>(i)])];
      result.stitches[static_cast<std::size_t>(i)] = {point_at(ring, mesh, arc + i * result.per_stitch),
                                                      no_vertex};
    }
    result.shared = true;
  }
  result.gap = gap_of(result.stitches);
  return result;
}

std::optional<std::vector<Stitch>> build_row(const Ring& ring, const Mesh& mesh, const Parameters& parameters,
                                             std::int32_t below) {
  const bool robust = parameters.on_stall == OnStall::continue_;
  Walk walk;
  while (walk.next < static_cast<std::int32_t>(ring.vertices.size())) {
    const CandidateMeasured measured = measure_next(walk, ring, mesh, parameters);
    if (robust && measured.verdict == Verdict::too_far) take_nearest(walk, ring, mesh, parameters);
  }
  if (!robust && stalled(walk)) return std::nullopt;
  if (robust) take_before_end(walk, ring, mesh, parameters);
  ClosedRow row = close_row(walk, ring, mesh, parameters);
  const auto picked = static_cast<std::int32_t>(row.stitches.size());
  if (const auto needed = needed_count(picked, below, ring.length, parameters.stitch_width)) {
    row.stitches = spread_evenly(ring, mesh, needed->count);
    row.resampled = true;
    row.gap = gap_of(row.stitches);
  }
  return share_gap(row, ring, mesh, parameters).stitches;
}

}  // namespace knit
