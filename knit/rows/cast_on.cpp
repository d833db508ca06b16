#include "knit/rows/cast_on.h"

#include "knit/rows/ring.h"

namespace knit {

namespace {

// The last level before the end that is long enough; a level that is no ring is left for its row to report.
std::int32_t find_last_level(const Input& input, const Timing& timing, std::int32_t first,
                             const RowsSettings& rows, const StitchSize& stitch) {
  std::int32_t level = timing.levels.count() - 2;
  while (level > first) {
    const auto ordered = order_ring(input, timing.ends, timing.levels.level(level), rows.start_direction);
    const Ring* ring = std::get_if<Ring>(&ordered);
    const bool skip =
        ring != nullptr ? too_short(*ring, stitch.width) : std::get<NotARing>(ordered).vertices < 3;
    if (!skip) break;
    --level;
  }
  return level;
}

}  // namespace

std::variant<FirstCycle, Stopped> find_first_cycle(const Input& input, const Timing& timing,
                                                   const RowsSettings& rows, const StitchSize& stitch) {
  const Levels& levels = timing.levels;
  std::int32_t passed_over = 0;
  std::int32_t vertices = 0;
  for (std::int32_t level = 1; level + 1 < levels.count(); ++level) {
    const double time = levels.times[static_cast<std::size_t>(level)];
    if (levels.split && level >= levels.split->level) {
      const Split& split = *levels.split;
      return Stopped{StopReason::splits, split.cause, level, split.loops, 1, split.vertex, split.time, time};
    }
    auto ordered = order_ring(input, timing.ends, levels.level(level), rows.start_direction);
    if (const auto* problem = std::get_if<NotARing>(&ordered)) {
      const VertexId vertex = levels.level(level).front();
      return Stopped{problem->loops > 1 ? StopReason::splits : StopReason::not_a_ring,
                     CriticalKind::saddle,
                     level,
                     problem->loops > 1 ? problem->loops : problem->vertices,
                     1,
                     vertex,
                     time,
                     time};
    }
    Ring& ring = std::get<Ring>(ordered);
    if (!too_short(ring, stitch.width)) {
      const std::int32_t last = find_last_level(input, timing, level, rows, stitch);
      if (last == level) {  // one row is no piece
        return Stopped{StopReason::no_row_levels,
                       {},
                       levels.count(),
                       1,
                       static_cast<std::int32_t>(ring.vertices.size()),
                       ring.vertices.front(),
                       stitch.width,
                       time};
      }
      return FirstCycle{level, last, passed_over, std::move(ring)};
    }
    ++passed_over;
    vertices = static_cast<std::int32_t>(ring.vertices.size());
  }
  return Stopped{StopReason::no_row_levels,
                 {},
                 levels.count(),
                 passed_over,
                 vertices,
                 timing.ends.start,
                 stitch.width,
                 0.0};
}

}  // namespace knit
