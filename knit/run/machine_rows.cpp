#include <glm/geometric.hpp>

#include "knit/rows/ring.h"
#include "knit/rows/rows.h"
#include "knit/run/machine.h"

namespace knit {

namespace {

double time_of_level(const State& state, std::int32_t level) {
  return state.timing->levels.times[static_cast<std::size_t>(level)];
}

Happening gather(const State& state, RowWork& work) {
  const auto level = state.timing->levels.level(work.level);
  work.phase = RowPhase::order;
  return CycleGathered{work.level, static_cast<std::int32_t>(level.size()), time_of_level(state, work.level)};
}

Happening order(const Input& input, const Parameters& parameters, const State& state, RowWork& work) {
  const Levels& levels = state.timing->levels;
  const double time = time_of_level(state, work.level);
  if (levels.split && work.level >= levels.split->level) {
    return Stopped{StopReason::splits, levels.split->cause,  work.level,         levels.split->loops,
                   state.next.row,     levels.split->vertex, levels.split->time, time};
  }
  auto ordered = order_ring(input, state.timing->ends, levels.level(work.level), parameters.start_direction);
  if (const auto* problem = std::get_if<NotARing>(&ordered)) {
    const bool several = problem->loops > 1;
    return Stopped{several ? StopReason::splits : StopReason::not_a_ring,
                   CriticalKind::saddle,
                   work.level,
                   several ? problem->loops : problem->vertices,
                   state.next.row,
                   levels.level(work.level).front(),
                   time,
                   time};
  }
  work.ring = Shared(std::get<Ring>(std::move(ordered)));
  work.phase = RowPhase::measure;
  return CycleOrdered{work.ring->vertices.front(), static_cast<std::int32_t>(work.ring->vertices.size()),
                      work.ring->ordered_by, work.ring->length};
}

Stopped stall(const State& state, const RowWork& work) {
  const auto anchor = work.ring->vertices[static_cast<std::size_t>(work.walk.anchor)];
  return Stopped{StopReason::stall,
                 {},
                 work.level,
                 static_cast<std::int32_t>(work.walk.kept.size()) + 1,
                 0,
                 anchor,
                 work.walk.nearest_distance,
                 time_of_level(state, work.level)};
}

Happening close(const Input& input, const Parameters& parameters, const State& state, RowWork& work) {
  const bool stop_on_stall = parameters.on_stall == OnStall::stop;
  if (stop_on_stall && stalled(work.walk)) return stall(state, work);
  ClosedRow closed = close_row(work.walk, *work.ring, input, parameters);
  const auto picked = static_cast<std::int32_t>(closed.stitches.size());
  const std::int32_t below = state.fabric.live().size();
  const auto needed = needed_count(picked, below, work.ring->length, parameters.stitch_width);
  const bool changes_too_much = needed && needed->reason != ResampleReason::too_few;
  if (changes_too_much && parameters.resample == Resample::off) {
    return Stopped{StopReason::changes_too_much,    {}, work.level, picked, below, no_vertex, 0.0,
                   time_of_level(state, work.level)};
  }
  const Band band = band_of(parameters);
  const RowClosed step{picked, closed.gap >= band.low && closed.gap <= band.high, closed.dropped_last,
                       closed.gap};
  work.closed = std::move(closed);
  work.phase = needed ? RowPhase::resample : RowPhase::share;
  return step;
}

Happening resample(const Parameters& parameters, const State& state, RowWork& work) {
  const auto picked = static_cast<std::int32_t>(work.closed.stitches.size());
  const std::int32_t below = state.fabric.live().size();
  // Parameters may have been edited since the row closed; a row that now fits is still spread evenly.
  const auto needed = needed_count(picked, below, work.ring->length, parameters.stitch_width)
                          .value_or(NeededCount{picked, ResampleReason::too_few});
  work.closed.stitches = spread_evenly(*work.ring, needed.count);
  work.closed.gap =
      glm::distance(work.closed.stitches.back().position, work.closed.stitches.front().position);
  work.closed.resampled = true;
  work.phase = RowPhase::share;
  return RowResampled{picked, needed.count, below, needed.reason, work.ring->length};
}

Happening share(const Parameters& parameters, State& state, RowWork& work) {
  SharedGap shared = share_gap(work.closed, *work.ring, parameters);
  const GapShared step{static_cast<std::int32_t>(shared.stitches.size()),
                       parameters.close,
                       shared.shared,
                       work.closed.resampled,
                       shared.per_stitch,
                       work.closed.gap,
                       shared.gap};
  const std::int32_t number = state.next.row;
  const std::int32_t level = work.level;
  state.fabric.add(Row{0, number, state.fabric.live(), level, time_of_level(state, level), work.ring,
                       std::move(shared.stitches)});
  if (level < state.last_level) {
    state.work = row_work_at(level + 1);
    state.next = {Stage::rows, number + 1, 0};
  } else {
    state.work = IndexWork{};
    state.next = {Stage::stitches, 2, 0};
  }
  return step;
}

}  // namespace

Happening advance_rows(const Input& input, const Parameters& parameters, State& state) {
  auto& work = std::get<RowWork>(state.work);
  switch (work.phase) {
    case RowPhase::gather:
      return gather(state, work);
    case RowPhase::order:
      return order(input, parameters, state, work);
    case RowPhase::missed: {
      work.phase = RowPhase::measure;
      return take_nearest(work.walk, *work.ring, input, parameters);
    }
    case RowPhase::resample:
      return resample(parameters, state, work);
    case RowPhase::share:
      return share(parameters, state, work);
    case RowPhase::measure:
      break;
  }
  const bool robust = parameters.on_stall == OnStall::continue_;
  if (work.walk.next == static_cast<std::int32_t>(work.ring->vertices.size())) {
    const auto missed =
        robust ? take_before_end(work.walk, *work.ring, input, parameters) : std::optional<BandMissed>();
    return missed ? Happening(*missed) : close(input, parameters, state, work);
  }
  const CandidateMeasured measured = measure_next(work.walk, *work.ring, input, parameters);
  if (robust && measured.verdict == Verdict::too_far) work.phase = RowPhase::missed;
  return measured;
}

}  // namespace knit
