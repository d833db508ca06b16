#include "knit/rows/ring_stage.h"

#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "knit/rows/ring.h"
#include "knit/rows/rows.h"

namespace knit {

namespace {

double time_of_level(const Timing& timing, std::int32_t level) {
  return timing.levels.times[static_cast<std::size_t>(level)];
}

// All rings are of one tube.
LiveStitches below(const RingRow& at) { return at.fabric.live(0); }

CycleGathered gather(const Timing& timing, RowWork& work) {
  const auto level = timing.levels.level(work.level);
  work.phase = RowPhase::order;
  return CycleGathered{work.level, static_cast<std::int32_t>(level.size()),
                       time_of_level(timing, work.level)};
}

Advanced<RingEvent> order(const Input& input, const RowsSettings& rows, const RingRow& at, RowWork& work) {
  const Levels& levels = at.timing.levels;
  const double time = time_of_level(at.timing, work.level);
  if (levels.split && work.level >= levels.split->level) {
    return Stopped{StopReason::splits, levels.split->cause,  work.level,         levels.split->loops,
                   at.number,          levels.split->vertex, levels.split->time, time};
  }
  auto ordered = order_ring(input, at.timing.ends, levels.level(work.level), rows.start_direction);
  if (const auto* problem = std::get_if<NotARing>(&ordered)) {
    const bool several = problem->loops > 1;
    return Stopped{several ? StopReason::splits : StopReason::not_a_ring,
                   CriticalKind::saddle,
                   work.level,
                   several ? problem->loops : problem->vertices,
                   at.number,
                   levels.level(work.level).front(),
                   time,
                   time};
  }
  work.ring = Shared(std::get<Ring>(std::move(ordered)));
  work.phase = RowPhase::measure;
  return CycleOrdered{work.ring->vertices.front(), static_cast<std::int32_t>(work.ring->vertices.size()),
                      work.ring->ordered_by, work.ring->length};
}

Stopped stall(const Timing& timing, const RowWork& work) {
  const auto anchor = work.ring->vertices[static_cast<std::size_t>(work.walk.anchor)];
  return Stopped{StopReason::stall,
                 {},
                 work.level,
                 static_cast<std::int32_t>(work.walk.kept.size()) + 1,
                 0,
                 anchor,
                 work.walk.nearest_distance,
                 time_of_level(timing, work.level)};
}

Advanced<RingEvent> close(const Input& input, const RowsSettings& rows, const StitchSize& stitch,
                          const RingRow& at, RowWork& work) {
  const bool stop_on_stall = rows.on_stall == OnStall::stop;
  if (stop_on_stall && stalled(work.walk)) return stall(at.timing, work);
  ClosedRow closed = close_row(work.walk, *work.ring, input, rows, stitch);
  const auto picked = static_cast<std::int32_t>(closed.stitches.size());
  const std::int32_t on = below(at).size();
  const auto needed = needed_count(picked, on, work.ring->length, stitch.width);
  const bool changes_too_much = needed && needed->reason != ResampleReason::too_few;
  if (changes_too_much && rows.resample == Resample::off) {
    return Stopped{StopReason::changes_too_much,        {}, work.level, picked, on, no_vertex, 0.0,
                   time_of_level(at.timing, work.level)};
  }
  const bool gap_fits = verdict_on(closed.gap, band_of(rows, stitch)) == Verdict::accepted;
  const RowClosed step{picked, gap_fits, closed.dropped_last, closed.gap};
  work.closed = std::move(closed);
  work.phase = needed ? RowPhase::resample : RowPhase::share;
  return step;
}

RowResampled resample(const StitchSize& stitch, std::int32_t below, RowWork& work) {
  const auto picked = static_cast<std::int32_t>(work.closed.stitches.size());
  // Parameters may have been edited since the row closed; a row that now fits is still spread evenly.
  const auto needed = needed_count(picked, below, work.ring->length, stitch.width)
                          .value_or(NeededCount{picked, ResampleReason::too_few});
  work.closed.stitches = spread_evenly(*work.ring, needed.count);
  work.closed.gap =
      glm::distance(work.closed.stitches.back().position, work.closed.stitches.front().position);
  work.closed.resampled = true;
  work.phase = RowPhase::share;
  return {picked, needed.count, below, needed.reason, work.ring->length};
}

Advanced<RingEvent> share(const RowsSettings& rows, const StitchSize& stitch, const RingRow& at,
                          RowWork& work, std::optional<Row>& row) {
  SharedGap shared = share_gap(work.closed, *work.ring, rows, stitch);
  const GapShared step{static_cast<std::int32_t>(shared.stitches.size()),
                       rows.close,
                       shared.shared,
                       work.closed.resampled,
                       shared.per_stitch,
                       work.closed.gap,
                       shared.gap};
  const std::int32_t level = work.level;
  row = Row{
      0, at.number, below(at), level, time_of_level(at.timing, level), work.ring, std::move(shared.stitches)};
  work = row_work_at(level + 1);
  return {step, level < at.last_level ? Ended::row : Ended::stage};
}

}  // namespace

Advanced<RingEvent> advance_rings(const Input& input, const RowsSettings& rows, const StitchSize& stitch,
                                  const RingRow& at, RowWork& work, std::optional<Row>& row) {
  switch (work.phase) {
    case RowPhase::gather:
      return gather(at.timing, work);
    case RowPhase::order:
      return order(input, rows, at, work);
    case RowPhase::missed: {
      work.phase = RowPhase::measure;
      return take_nearest(work.walk, *work.ring, input, rows, stitch);
    }
    case RowPhase::resample:
      return resample(stitch, below(at).size(), work);
    case RowPhase::share:
      return share(rows, stitch, at, work, row);
    case RowPhase::measure:
      break;
  }
  const bool robust = rows.on_stall == OnStall::continue_;
  if (work.walk.next == static_cast<std::int32_t>(work.ring->vertices.size())) {
    const auto missed =
        robust ? take_before_end(work.walk, *work.ring, input, rows, stitch) : std::optional<BandMissed>();
    return missed ? Advanced<RingEvent>(*missed) : close(input, rows, stitch, at, work);
  }
  const CandidateMeasured measured = measure_next(work.walk, *work.ring, input, rows, stitch);
  if (robust && measured.verdict == Verdict::too_far) work.phase = RowPhase::missed;
  return measured;
}

}  // namespace knit
