// Algorithm 2 and its closing, on rings small enough to count by hand.
#include "knit/rows/rows.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "knit/model/stitch_size.h"
#include "knit/rows/ring.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

namespace {

// The whole of Algorithm 2 with its closing, for one ring, as the machine's steps do it; nothing when it stalls and
// on_stall is stop.
std::optional<std::vector<Stitch>> build_row(const Ring& ring, const Input& input, const RowsSettings& rows,
                                             const StitchSize& stitch, std::int32_t below) {
  const bool robust = rows.on_stall == OnStall::continue_;
  Walk walk;
  while (walk.next < static_cast<std::int32_t>(ring.vertices.size())) {
    const CandidateMeasured measured = measure_next(walk, ring, input, rows, stitch);
    if (robust && measured.verdict == Verdict::too_far) take_nearest(walk, ring, input, rows, stitch);
  }
  if (!robust && stalled(walk)) return std::nullopt;
  if (robust) take_before_end(walk, ring, input, rows, stitch);
  ClosedRow row = close_row(walk, ring, input, rows, stitch);
  const auto picked = static_cast<std::int32_t>(row.stitches.size());
  if (const auto needed = needed_count(picked, below, ring.length, stitch.width)) {
    row.stitches = spread_evenly(ring, needed->count);
    row.resampled = true;
    row.gap = glm::distance(row.stitches.back().position, row.stitches.front().position);
  }
  return share_gap(row, ring, rows, stitch).stitches;
}

struct RingMesh {
  Input input;  // positions only: enough for every metric but geodesic
  Ring ring;
};

// Vertices at the given angles (in turns) on a circle of radius 1, in order.
RingMesh ring_at(const std::vector<double>& turns) {
  RingMesh made;
  for (const double turn : turns) {
    const double angle = 2 * std::numbers::pi * turn;
    made.ring.points.emplace_back(std::cos(angle), 0.0, std::sin(angle));
    made.ring.vertices.push_back(static_cast<VertexId>(made.ring.vertices.size()));
  }
  for (std::size_t i = 0; i < turns.size(); ++i) {
    made.ring.arc.push_back(made.ring.length);
    made.ring.length += glm::distance(made.ring.points[i], made.ring.points[(i + 1) % turns.size()]);
  }
  return made;
}

RingMesh even_ring(int count) {
  std::vector<double> turns;
  for (int i = 0; i < count; ++i) turns.push_back(static_cast<double>(i) / count);
  return ring_at(turns);
}

Parameters with(double width, double epsilon) {
  Parameters parameters;
  give_width(parameters, width);
  give_epsilon(parameters, epsilon);
  return parameters;
}

std::vector<Verdict> walk_verdicts(Walk& walk, const RingMesh& r, const Parameters& parameters) {
  std::vector<Verdict> verdicts;
  while (walk.next < static_cast<std::int32_t>(r.ring.vertices.size())) {
    verdicts.push_back(measure_next(walk, r.ring, r.input, parameters.rows, parameters.stitch).verdict);
  }
  return verdicts;
}

}  // namespace

TEST_CASE("the first vertex in the band wins, and the old anchor is kept") {
  const RingMesh r = even_ring(12);  // chords 0.518, 1, 1.414 ...
  Walk walk;
  const std::vector<Verdict> verdicts = walk_verdicts(walk, r, with(1.0, 0.1));
  CHECK(walk.kept == std::vector<std::int32_t>{0, 2, 4, 6, 8});
  CHECK(walk.anchor == 10);
  using V = Verdict;
  CHECK(verdicts == std::vector<Verdict>{V::too_near, V::too_near, V::accepted, V::too_near, V::accepted,
                                         V::too_near, V::accepted, V::too_near, V::accepted, V::too_near,
                                         V::accepted, V::too_near});
}

TEST_CASE("both edges of the band belong to it") {
  RingMesh r = even_ring(6);
  r.ring.points = {{0, 0, 0}, {0.75, 0, 0}, {2.0, 0, 0}, {2.5, 0, 0}, {3.0, 0, 0}, {4.0, 0, 0}};
  Walk walk;
  Parameters parameters = with(1.0, 0.25);
  measure_next(walk, r.ring, r.input, parameters.rows, parameters.stitch);
  CHECK(measure_next(walk, r.ring, r.input, parameters.rows, parameters.stitch).verdict ==
        Verdict::accepted);  // 0.75
  CHECK(measure_next(walk, r.ring, r.input, parameters.rows, parameters.stitch).verdict ==
        Verdict::accepted);  // 1.25
  CHECK(measure_next(walk, r.ring, r.input, parameters.rows, parameters.stitch).verdict ==
        Verdict::too_near);  // 0.5
}

TEST_CASE("the last anchor is kept, or dropped when it is nearer than half a width to the first") {
  const RingMesh r = even_ring(13);
  Parameters parameters = with(1.1, 0.2);  // 0.479, 0.929: every second vertex; 12 is one segment from 0
  Walk walk;
  walk_verdicts(walk, r, parameters);
  CHECK(close_row(walk, r.ring, r.input, parameters.rows, parameters.stitch).orders.back() == 12);
  CHECK(close_row(walk, r.ring, r.input, parameters.rows, parameters.stitch).orders.size() == 7);
  parameters.rows.last_anchor = LastAnchor::drop;
  const ClosedRow dropped = close_row(walk, r.ring, r.input, parameters.rows, parameters.stitch);
  CHECK(dropped.dropped_last);
  CHECK(dropped.orders.back() == 10);
  CHECK(dropped.gap == Approx(2 * std::sin(3 * std::numbers::pi / 13)));
}

TEST_CASE(
    "a stall: as printed the anchor never moves again, robust, the nearest is taken and measuring goes on") {
  const RingMesh r = even_ring(12);              // chords 0.518, 1.0
  const Parameters parameters = with(0.7, 0.1);  // nothing between 0.6 and 0.8
  Walk printed;
  walk_verdicts(printed, r, parameters);
  CHECK(printed.kept.empty());
  CHECK(printed.jumped);
  CHECK(stalled(printed));
  CHECK(printed.nearest_distance == Approx(0.5176).margin(1e-3));
  Parameters stop = parameters;
  stop.rows.on_stall = OnStall::stop;
  CHECK_FALSE(build_row(r.ring, r.input, stop.rows, stop.stitch, 12));

  const auto robust = build_row(r.ring, r.input, parameters.rows, parameters.stitch, 12);
  REQUIRE(robust);
  CHECK(robust->size() == 12);  // 0.518 is nearer to 0.7 than 1.0 is
}

TEST_CASE(
    "robust: a far vertex is taken when it is nearer to the width, or alone, but not beyond half the ring") {
  const Parameters parameters = with(0.9, 0.05);
  const RingMesh r = even_ring(12);
  Walk walk;
  for (int i = 0; i < 3; ++i) measure_next(walk, r.ring, r.input, parameters.rows, parameters.stitch);
  const BandMissed missed = take_nearest(walk, r.ring, r.input, parameters.rows, parameters.stitch);
  CHECK(missed.taken_order == 2);
  CHECK(missed.distance == Approx(1.0));
  CHECK(missed.skipped_distance == Approx(0.5176).margin(1e-3));
  CHECK(walk.anchor == 2);
  CHECK(walk.next == 3);

  const RingMesh coarse = even_ring(3);  // chord 1.732
  Walk alone;
  measure_next(alone, coarse.ring, coarse.input, parameters.rows, parameters.stitch);
  measure_next(alone, coarse.ring, coarse.input, parameters.rows, parameters.stitch);
  const BandMissed only = take_nearest(alone, coarse.ring, coarse.input, parameters.rows, parameters.stitch);
  CHECK(only.taken_order == 1);
  CHECK(only.skipped_distance < 0.0);

  const RingMesh uneven = ring_at({0.0, 0.05, 0.75, 0.9});
  Walk far;
  const Parameters wide = with(1.1, 0.05);
  for (int i = 0; i < 3; ++i) measure_next(far, uneven.ring, uneven.input, wide.rows, wide.stitch);
  CHECK(take_nearest(far, uneven.ring, uneven.input, wide.rows, wide.stitch).taken_order == 1);
}

TEST_CASE("how many stitches a row must have") {
  CHECK_FALSE(needed_count(12, 6, 10.0, 1.0));
  CHECK_FALSE(needed_count(3, 6, 10.0, 1.0));
  CHECK(needed_count(13, 6, 10.0, 1.0)->count == 12);
  CHECK(needed_count(13, 6, 10.0, 1.0)->reason == ResampleReason::more_than_double);
  CHECK(needed_count(6, 13, 10.0, 1.0)->count == 7);
  CHECK(needed_count(6, 13, 10.0, 1.0)->reason == ResampleReason::less_than_half);
  CHECK(needed_count(1, 6, 4.4, 1.0)->count == 4);
  CHECK(needed_count(1, 6, 1.0, 1.0)->count == 3);
  CHECK(needed_count(1, 6, 99.0, 1.0)->count == 12);
  CHECK(needed_count(2, 20, 2.0, 1.0)->count == 10);
}

TEST_CASE("the gap, shared out three ways") {
  const RingMesh r = even_ring(128);
  Parameters parameters = with(0.3, 0.1);  // steps of 5 segments (0.245), 26 stitches, a gap of 3 (0.147)
  Walk walk;
  walk_verdicts(walk, r, parameters);
  const ClosedRow row = close_row(walk, r.ring, r.input, parameters.rows, parameters.stitch);
  REQUIRE(row.stitches.size() == 26);
  REQUIRE(row.gap == Approx(0.1472).margin(1e-3));

  parameters.rows.close = Closing::none;
  const SharedGap none = share_gap(row, r.ring, parameters.rows, parameters.stitch);
  CHECK_FALSE(none.shared);
  CHECK(none.stitches == row.stitches);

  parameters.rows.close = Closing::thesis;
  const SharedGap thesis = share_gap(row, r.ring, parameters.rows, parameters.stitch);
  CHECK(thesis.shared);
  CHECK(thesis.per_stitch == Approx((row.gap - 0.3) / 26));
  CHECK(thesis.stitches.front() == row.stitches.front());
  CHECK(thesis.gap == Approx(0.3).margin(0.01));  // stitch 25 moved back by 25/26 of what lacks
  CHECK(thesis.gap > row.gap);

  parameters.rows.close = Closing::arc;
  const SharedGap arc = share_gap(row, r.ring, parameters.rows, parameters.stitch);
  const double expected = r.ring.length / 26;
  for (std::size_t i = 0; i < 26; ++i) {
    CHECK(glm::distance(arc.stitches[i].position, arc.stitches[(i + 1) % 26].position) ==
          Approx(expected).epsilon(0.01));
  }
}

TEST_CASE("the thesis's shift leaves a gap inside the band alone") {
  const RingMesh r = even_ring(12);
  Parameters parameters = with(1.0, 0.1);
  parameters.rows.close = Closing::thesis;
  Walk walk;
  walk_verdicts(walk, r, parameters);
  const ClosedRow row = close_row(walk, r.ring, r.input, parameters.rows, parameters.stitch);
  CHECK(row.gap == Approx(1.0));
  CHECK_FALSE(share_gap(row, r.ring, parameters.rows, parameters.stitch).shared);
}

TEST_CASE("the machine's rows are those of the plain function") {
  const auto input = test_support::small_sphere();
  Parameters parameters = test_support::small_parameters();
  give_epsilon(parameters, GENERATE(0.15, 0.08, 0.04));
  parameters.rows.close = GENERATE(Closing::none, Closing::thesis, Closing::arc);
  Timeline timeline(input, parameters);
  timeline.extend_to_end();
  const State& state = timeline.furthest();
  REQUIRE(state.fabric.rows().size() > 5);
  for (std::size_t i = 1; i < state.fabric.rows().size(); ++i) {
    const auto below = static_cast<std::int32_t>(state.fabric.rows()[i - 1]->stitches.size());
    CHECK(build_row(*state.fabric.rows()[i]->ring, *input, parameters.rows, parameters.stitch, below) ==
          state.fabric.rows()[i]->stitches);
  }
}
