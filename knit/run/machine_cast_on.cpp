#include "knit/rows/cast_on.h"
#include "knit/rows/ring.h"
#include "knit/run/machine.h"

namespace knit {

namespace {

constexpr std::int32_t default_cast_on = 6;

Happening find_cycle(const Input& input, const Parameters& parameters, State& state, CastOnWork& work) {
  const Timing& timing = *state.timing;
  auto found = find_first_cycle(input, timing, parameters);
  if (const auto* stopped = std::get_if<Stopped>(&found)) return *stopped;
  auto& cycle = std::get<FirstCycle>(found);
  const CycleFound step{cycle.level,
                        cycle.last_level,
                        static_cast<std::int32_t>(cycle.ring.vertices.size()),
                        cycle.passed_over,
                        timing.levels.times[static_cast<std::size_t>(cycle.level)],
                        cycle.ring.length};
  work.level = cycle.level;
  work.ring = Shared(std::move(cycle.ring));
  state.last_level = cycle.last_level;
  return step;
}

void finish_cast_on(State& state, CastOnWork& work) {
  const double time = state.timing->levels.times[static_cast<std::size_t>(work.level)];
  state.fabric.add(Row{0, 1, {}, work.level, time, work.ring, std::move(work.stitches)});
  const std::int32_t next_level = work.level + 1;
  if (next_level > state.last_level) {
    state.work = IndexWork{};
    state.next = {Stage::stitches, 2, 0};
  } else {
    state.work = row_work_at(next_level);
    state.next = {Stage::rows, 2, 0};
  }
}

}  // namespace

Happening advance_cast_on(const Input& input, const Parameters& parameters, State& state) {
  auto& work = std::get<CastOnWork>(state.work);
  if (!work.ring) return find_cycle(input, parameters, state, work);
  // The count may be edited half way; a stitch already cast on stays.
  const auto placed = static_cast<std::int32_t>(work.stitches.size());
  const std::int32_t wanted = parameters.cast_on > 0 ? parameters.cast_on : default_cast_on;
  const std::int32_t count = std::max(wanted, placed + 1);
  const double arc = work.ring->length * placed / count;
  work.stitches.push_back({point_at(*work.ring, arc), no_vertex});
  if (placed + 1 == count) finish_cast_on(state, work);
  return StitchCastOn{placed + 1, count, arc};
}

}  // namespace knit
