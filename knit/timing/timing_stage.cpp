#include "knit/timing/timing_stage.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>

#include "knit/model/ties.h"
#include "knit/timing/choice.h"
#include "knit/timing/critical.h"
#include "knit/timing/heights.h"
#include "knit/timing/levels.h"
#include "knit/timing/timing.h"

namespace knit {

namespace {

bool is_retimed(TimingKind kind) { return kind == TimingKind::arc_length || kind == TimingKind::harmonic; }

// Algorithm 1, line 3: exact at the ends, whatever rounding says.
double pinned(const Ends& ends, VertexId vertex, double value) {
  return vertex == ends.start ? 0.0 : vertex == ends.end ? 1.0 : value;
}

Advanced<TimingEvent> find_ends_of_knitting(const Input& input, const TimingSettings& settings,
                                            TimingWork& work) {
  auto found = find_ends(input, settings);
  if (const auto* stopped = std::get_if<Stopped>(&found)) return *stopped;
  work.ends = std::get<Ends>(found);
  const bool open = work.ends->start_rim >= 0 || work.ends->end_rim >= 0;
  work.kind = open ? TimingKind::harmonic : settings.kind;
  return EndsFound{work.ends->start, work.ends->end, glm::length(work.ends->direction)};
}

TimingChosen choose_kind(const Input& input, TimingWork& work) {
  const LevelFigures figures = measure_levels(input, *work.ends);
  work.kind = better_timing(figures);
  const bool for_flat = is_too_flat(figures);
  return {work.kind, for_flat, for_flat ? figures.flat_at : figures.uneven_at, figures.flat,
          figures.unevenness};
}

// Distances from the start become a field; without a picked end the farthest vertex is the end.
Advanced<TimingEvent> take_distances(const Input& input, const TimingSettings& settings, TimingWork& work,
                                     const Heard& heard) {
  std::vector<double> field = distance_from(input, *work.net, *work.slopes, work.ends->start, heard);
  if (settings.end == no_vertex) {
    const double reach = *std::max_element(field.begin(), field.end());
    const auto farthest = std::find_if(field.begin(), field.end(),
                                       [&](double value) { return !clearly_less(value, reach, reach); });
    work.ends->end = static_cast<VertexId>(farthest - field.begin());
  }
  const double whole = field[work.ends->end];
  const FieldSolved step{FieldStep::distance, work.ends->end, static_cast<std::int64_t>(field.size()), whole};
  if (!(whole > 0.0)) return Stopped{StopReason::no_extent, {}, -1, 0, 0, work.ends->start, 0.0, 0.0};
  for (double& value : field) value /= whole;
  work.field = Shared(std::move(field));
  return step;
}

Advanced<TimingEvent> solve_next(const Input& input, const TimingSettings& settings, TimingWork& work,
                                 const Heard& heard) {
  const VertexId start = work.ends->start;
  const auto vertices = static_cast<std::int64_t>(input.mesh.positions.size());
  if (!work.net) {
    work.net = Shared(make_intrinsic(input, heard));
    return FieldSolved{FieldStep::net, start, static_cast<std::int64_t>(work.net->triangles.size()), 0.0};
  }
  if (work.kind == TimingKind::harmonic) {
    const auto all_of = [&](std::int32_t rim, const VertexId& vertex) {
      return rim >= 0 ? std::span<const VertexId>(input.rims[static_cast<std::size_t>(rim)].vertices)
                      : std::span(&vertex, 1);
    };
    const Ends& ends = *work.ends;
    work.field = Shared(solve_harmonic(input, *work.net, all_of(ends.start_rim, ends.start),
                                       all_of(ends.end_rim, ends.end), heard));
    return FieldSolved{FieldStep::harmonic, start, vertices, 1.0};
  }
  if (!work.heat) {
    work.heat = Shared(spread_heat(input, *work.net, start, heard));
    return FieldSolved{FieldStep::heat, start, vertices, 0.0};
  }
  if (!work.slopes) {
    work.slopes = Shared(unit_slopes(*work.net, *work.heat, heard));
    return FieldSolved{FieldStep::slopes, start, static_cast<std::int64_t>(work.slopes->size()), 1.0};
  }
  return take_distances(input, settings, work, heard);
}

// How far a vertex stands from the start to the end along the line, within [0, 1].
double clamped_projection(const Input& input, const Ends& ends, VertexId vertex) {
  return std::clamp(pinned(ends, vertex, time_of(ends, input.mesh.positions[vertex])), 0.0, 1.0);
}

HeightsMeasured measure(const Input& input, TimingWork& work, const Heard& heard) {
  Shared<std::vector<double>> field = work.field;
  if (!field) {
    std::vector<double> projections(input.mesh.positions.size());
    for (VertexId v = 0; v < projections.size(); ++v)
      projections[v] = clamped_projection(input, *work.ends, v);
    field = Shared(std::move(projections));
  }
  work.scale = Shared(measure_heights(input, *field, heard));
  work.field = std::move(field);
  return HeightsMeasured{static_cast<std::int32_t>(work.scale->values.size()) - 1, work.scale->total()};
}

VertexTimed time_next_vertex(const Input& input, TimingWork& work) {
  const auto vertex = static_cast<VertexId>(work.times.size());
  const Ends& ends = *work.ends;
  const bool solved = work.kind == TimingKind::geodesic || work.kind == TimingKind::harmonic;
  const double value = solved ? (*work.field)[vertex] : time_of(ends, input.mesh.positions[vertex]);
  // Rounding may push a vertex of the extreme level out by a hair; only a real excess is worth a word.
  const bool outside = value < -1e-9 || value > 1.0 + 1e-9;
  if (outside) ++work.outside;
  double time = std::clamp(pinned(ends, vertex, value), 0.0, 1.0);
  if (work.scale) time = height_at(*work.scale, time) / work.scale->total();
  work.times.push_back(time);
  return VertexTimed{vertex, outside, time};
}

CriticalsFound find_critical_points(const Input& input, TimingWork& work, const Heard& heard) {
  work.criticals = Shared(find_criticals(input, work.times.to_vector(), heard));
  const Criticals& found = *work.criticals;
  return CriticalsFound{found.minima, found.saddles, found.maxima, found.euler};
}

Advanced<TimingEvent> group(const Input& input, const TimingSettings& settings, const TimingWork& work,
                            Shared<Timing>& made, const Heard& heard) {
  Timing timing;
  timing.ends = *work.ends;
  timing.kind = work.kind;
  timing.outside = work.outside;
  timing.times = work.times.to_vector();
  timing.criticals = *work.criticals;
  timing.retimed = is_retimed(work.kind);
  if (timing.retimed) timing.field = *work.field;
  if (work.scale) timing.scale = *work.scale;  // else only contours ask for one, of the times: plan_cuts
  timing.levels = group_levels(input, timing.times, timing.criticals, settings.level_tolerance, heard);
  const auto& split = timing.levels.split;
  const LevelsGrouped grouped{timing.levels.count(), timing.outside, split ? split->level : -1,
                              split ? split->loops : 1, settings.level_tolerance};
  made = Shared(std::move(timing));
  return {grouped, Ended::stage};
}

}  // namespace

Advanced<TimingEvent> advance_timing(const Input& input, const TimingSettings& settings, TimingWork& work,
                                     Shared<Timing>& timing, const Heard& heard) {
  if (!work.ends) return find_ends_of_knitting(input, settings, work);
  if (work.kind == TimingKind::by_itself) return choose_kind(input, work);
  const bool solved_for = work.kind == TimingKind::geodesic || work.kind == TimingKind::harmonic;
  if (solved_for && !work.field) return solve_next(input, settings, work, heard);
  if (is_retimed(work.kind) && !work.scale) return measure(input, work, heard);
  if (work.times.size() < input.mesh.positions.size()) return time_next_vertex(input, work);
  if (!work.criticals) return find_critical_points(input, work, heard);
  return group(input, settings, work, timing, heard);
}

bool next_is_a_solve(const Input& input, const TimingSettings& settings, const TimingWork& work) {
  const bool all_timed = work.times.size() == input.mesh.positions.size();
  const TimingKind kind = work.ends ? work.kind : settings.kind;
  if (kind == TimingKind::linear || kind == TimingKind::by_itself) return all_timed;
  return work.ends && (!work.times.empty() ? all_timed : !work.field || !work.scale);
}

std::string_view work_ahead(const TimingWork& work) {
  if (!work.ends || work.kind == TimingKind::by_itself) return "working";
  if (!work.times.empty()) return work.criticals ? "sorting the levels" : "finding critical points";
  if (work.field || work.kind == TimingKind::arc_length) return "measuring heights";
  if (!work.net) return "laying out the surface";
  if (work.kind == TimingKind::harmonic) return "solving for the harmonic field";
  if (!work.heat) return "spreading heat";
  return work.slopes ? "solving for the distance" : "turning the slopes of the heat";
}

}  // namespace knit
