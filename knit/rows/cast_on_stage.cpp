#include "knit/rows/cast_on_stage.h"

#include <algorithm>

#include "knit/rows/cast_on.h"
#include "knit/rows/ring.h"

namespace knit {

namespace {

constexpr std::int32_t default_cast_on = 6;

Advanced<CastOnEvent> find_cycle(const Input& input, const RowsSettings& rows, const StitchSize& stitch,
                                 const Timing& timing, CastOnWork& work, std::int32_t& last_level) {
  auto found = find_first_cycle(input, timing, rows, stitch);
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
  last_level = cycle.last_level;
  return step;
}

Row finished_row(const Timing& timing, CastOnWork& work) {
  const double time = timing.levels.times[static_cast<std::size_t>(work.level)];
  return {0, 1, {}, work.level, time, work.ring, std::move(work.stitches)};
}

}  // namespace

Advanced<CastOnEvent> advance_cast_on(const Input& input, const RowsSettings& rows, const StitchSize& stitch,
                                      const Timing& timing, CastOnWork& work, CastOnMade made) {
  if (!work.ring) return find_cycle(input, rows, stitch, timing, work, made.last_level);
  // The count may be edited half way; a stitch already cast on stays.
  const auto placed = static_cast<std::int32_t>(work.stitches.size());
  const std::int32_t wanted = rows.cast_on > 0 ? rows.cast_on : default_cast_on;
  const std::int32_t count = std::max(wanted, placed + 1);
  const double arc = work.ring->length * placed / count;
  work.stitches.push_back({point_at(*work.ring, arc), no_vertex});
  const bool last = placed + 1 == count;
  if (last) made.row = finished_row(timing, work);
  return {StitchCastOn{placed + 1, count, arc}, last ? Ended::stage : Ended::step};
}

}  // namespace knit
