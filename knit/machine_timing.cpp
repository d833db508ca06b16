#include <algorithm>
#include <glm/geometric.hpp>

#include "knit/levels.h"
#include "knit/machine.h"
#include "knit/timing.h"

namespace knit {

namespace {

Happening time_next_vertex(const Input& input, TimingWork& work) {
  const auto vertex = static_cast<VertexId>(work.times.size());
  const Ends& ends = *work.ends;
  double time = time_of(ends, input.mesh.positions[vertex]);
  // Algorithm 1, line 3: exact at the ends, whatever rounding says.
  if (vertex == ends.start) time = 0.0;
  if (vertex == ends.end) time = 1.0;
  const double clamped = std::clamp(time, 0.0, 1.0);
  // Rounding may push a vertex of the extreme level out by a hair; only a real excess is worth a word.
  const bool outside = time < -1e-9 || time > 1.0 + 1e-9;
  if (outside) ++work.outside;
  work.times.push_back(clamped);
  return VertexTimed{vertex, outside, clamped};
}

Happening group(const Input& input, const Parameters& parameters, State& state, const TimingWork& work) {
  Timing timing;
  timing.ends = *work.ends;
  timing.outside = work.outside;
  timing.times = work.times.to_vector();
  timing.levels = group_levels(input, timing.times, parameters.level_tolerance);
  const auto& split = timing.levels.split;
  const LevelsGrouped grouped{timing.levels.count(), timing.outside, split ? split->level : -1,
                              split ? split->loops : 1, parameters.level_tolerance};
  state.timing = Shared(std::move(timing));
  state.work = CastOnWork{};
  state.next = {Stage::cast_on, 1, 0};
  return grouped;
}

}  // namespace

Happening advance_timing(const Input& input, const Parameters& parameters, State& state) {
  auto& work = std::get<TimingWork>(state.work);
  if (!work.ends) {
    auto found = find_ends(input, parameters);
    if (const auto* stopped = std::get_if<Stopped>(&found)) return *stopped;
    work.ends = std::get<Ends>(found);
    const double length = glm::length(work.ends->direction);
    return EndsFound{work.ends->start, work.ends->end, length};
  }
  if (work.times.size() < input.mesh.positions.size()) return time_next_vertex(input, work);
  return group(input, parameters, state, work);
}

}  // namespace knit
