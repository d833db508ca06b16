#include "app/explain/code_variables.h"

#include <algorithm>
#include <concepts>
#include <cstdio>
#include <glm/geometric.hpp>

#include "app/explain/step_table.h"
#include "app/session/document.h"
#include "knit/insight/narrate.h"
#include "knit/insight/step_fields.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"
#include "knit/rows/row_variables.h"
#include "knit/stitches/stitch_variables.h"
#include "knit/timing/heights.h"
#include "knit/timing/timing_variables.h"

namespace app {

namespace var = knit::var;

namespace {

// Variables and values, each variable once; the newest counts.
class Values {
 public:
  void set(const knit::CodeVariable& variable, std::string value) {
    const auto at = find(variable);
    if (at != values_.end()) {
      at->second = std::move(value);
    } else {
      values_.emplace_back(&variable, std::move(value));
    }
  }
  void set(const knit::CodeVariable& variable, double value) { set(variable, knit::short_number(value)); }
  template <std::integral Whole>
  void set(const knit::CodeVariable& variable, Whole value) {
    set(variable, std::to_string(value));
  }
  [[nodiscard]] std::string take(const knit::CodeVariable& variable) {
    const auto at = find(variable);
    return at != values_.end() ? std::move(at->second) : std::string();
  }

 private:
  using Pairs = std::vector<std::pair<const knit::CodeVariable*, std::string>>;
  Pairs::iterator find(const knit::CodeVariable& variable) {
    return std::find_if(values_.begin(), values_.end(),
                        [&](const auto& pair) { return pair.first == &variable; });
  }
  Pairs values_;
};

// What a row stands on, or will: of one in the making its tube's loop, which need not be the last row made.
knit::LiveStitches worked_on(const knit::State& state, std::int32_t row) {
  if (const knit::Row* made = state.fabric.find_row(row)) return made->on;
  const auto* contour = std::get_if<knit::ContourWork>(&state.work);
  if (contour == nullptr) return row > 1 ? state.fabric.live_below(row) : knit::LiveStitches{};
  if (contour->taken == 0 || !state.tubes) return {};
  return state.fabric.live(knit::current_tube(*state.tubes, *contour));
}

std::string vector_text(const glm::dvec3& v) {
  std::array<char, 64> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), "(%.2g, %.2g, %.2g)", v.x, v.y, v.z);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

// As the table of parameters has it: "euclidean".
std::string parameter_text(const knit::Parameters& parameters, std::string_view key) {
  return knit::value_text(*knit::find_parameter(key), parameters);
}

void add_parameters(const knit::Parameters& parameters, Values& values) {
  values.set(var::width, parameters.stitch.width);
  values.set(var::epsilon, parameters.epsilon());
  values.set(var::stitch_height, parameters.stitch.height);
  values.set(var::metric, parameter_text(parameters, knit::keys::metric));
  values.set(var::tolerance, parameters.timing.level_tolerance);
}

void add_timing(const knit::State& state, Values& values) {
  const knit::Ends* ends = ends_shown(state);
  if (ends == nullptr) return;
  values.set(var::start, ends->start);
  values.set(var::end, ends->end);
  values.set(var::direction, vector_text(ends->direction));
  values.set(var::mag, glm::length(ends->direction));
  const auto* work = std::get_if<knit::TimingWork>(&state.work);
  if (work != nullptr && work->scale) values.set(var::height, work->scale->total());
}

void add_row(const knit::State& state, std::int32_t row, Values& values) {
  const RowShown shown = row_shown(state, row);
  if (shown.level) values.set(var::level, *shown.level);
  if (shown.time) values.set(var::time, *shown.time);
  if (const knit::LiveStitches on = worked_on(state, row); !on.empty()) values.set(var::below, on.size());
  if (shown.ring != nullptr) {
    values.set(var::count, shown.ring->points.size());
    values.set(var::points, shown.ring->points.size());
    values.set(var::length, shown.ring->length);
  }
  const auto* walk = std::get_if<knit::RowWork>(&state.work);
  const auto* contour = std::get_if<knit::ContourWork>(&state.work);
  if (shown.finished != nullptr) {
    values.set(var::n, shown.finished->stitches.size());
  } else if (walk != nullptr && walk->phase == knit::RowPhase::measure) {
    values.set(var::n, walk->walk.kept.size() + 1);
  } else if (contour != nullptr && contour->count > 0) {
    values.set(var::n, contour->count);
  }
}

void add_join(const knit::State& state, std::int32_t row, Values& values) {
  const knit::Fabric& fabric = state.fabric;
  const knit::RowId into = std::max(row, 2);
  if (!fabric.has_row(into) || fabric.row(into).on.empty()) return;
  values.set(var::below, fabric.row(into).on.size());
  values.set(var::above, fabric.row(into).stitches.size());
  std::size_t mains = 0;
  bool any = false;
  for (const knit::StitchSpan& span : fabric.row(into).on.spans) {
    const knit::Join* before = fabric.join_into(span.row);
    any = any || before != nullptr;
    if (before == nullptr) continue;
    mains += static_cast<std::size_t>(std::count_if(
        before->mains.begin(), before->mains.end(),
        [&](std::int32_t stitch) { return stitch >= span.first && stitch < span.first + span.count; }));
  }
  if (any) values.set(var::mains, mains);
  const knit::Join* plan = join_shown(state, row);
  if (plan == nullptr) return;
  values.set(var::change, plan->change());
  values.set(var::wanted, (std::abs(plan->change()) + 1) / 2);
  values.set(var::rule, std::string(knit::name_of(plan->rule)));
  if (plan->spacing > 0) values.set(var::spacing, plan->spacing);
  values.set(var::remainder, plan->remainder);
}

void add_stop(const knit::Stopped& stop, Values& values) {
  if (stop.level >= 0 && stop.time > 0.0) {
    values.set(var::level, stop.level);
    values.set(var::time, stop.time);
  }
  switch (stop.reason) {
    case knit::StopReason::stall:
      values.set(var::anchor, stop.vertex);
      values.set(var::stitch, stop.count);
      return values.set(var::skipped, stop.value);
    case knit::StopReason::changes_too_much:
      values.set(var::n, stop.count);
      return values.set(var::below, stop.other);
    case knit::StopReason::splits:
      return values.set(var::loops, stop.count);
    case knit::StopReason::not_a_ring:
      return values.set(var::count, stop.count);
    case knit::StopReason::no_extent:
    case knit::StopReason::no_row_levels:
    case knit::StopReason::too_many_tubes:
    case knit::StopReason::too_fine:
    case knit::StopReason::open_edge:
      return;
  }
}

// The step's own numbers, as its table has them.
void add_step(const knit::Step& step, const knit::Input& input, const knit::State& state, Values& values) {
  if (const auto* stop = knit::get_if<knit::Stopped>(step)) return add_stop(*stop, values);
  const auto fields = knit::fields_of(step);
  const auto numbers = numbers_of(step);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].variable != nullptr) values.set(*fields[i].variable, numbers[i].second);
  }
  const knit::Ends* ends = ends_shown(state);
  const auto* timed = knit::get_if<knit::VertexTimed>(step);
  if (timed != nullptr && ends != nullptr) {
    const auto& positions = input.mesh.positions;
    values.set(var::diff, vector_text(positions[timed->vertex] - positions[ends->start]));
  }
  if (knit::is<knit::LineWritten>(step)) values.set(var::row, step.place.row);
}

void take_level(const knit::State& state, std::int32_t level, RowShown& shown) {
  if (level < 0 || !state.timing || level >= state.timing->levels.count()) return;
  shown.level = level;
  shown.time = state.timing->levels.times[static_cast<std::size_t>(level)];
}

}  // namespace

const knit::CodeVariable* variable_named(std::string_view key) {
  for (const PseudoCode* code : listings()) {
    for (const knit::CodeVariable* variable : variables_in(*code)) {
      if (variable->key == key) return variable;
    }
  }
  return nullptr;
}

RowShown row_shown(const knit::State& state, std::int32_t row) {
  RowShown shown;
  if (row < 1) return shown;
  shown.below = state.fabric.row_below(row);
  shown.finished = state.fabric.find_row(row);
  if (shown.finished != nullptr) {
    if (shown.finished->ring) shown.ring = &*shown.finished->ring;
    shown.level = shown.finished->level;
    shown.time = shown.finished->time;
    return shown;
  }
  if (state.next.row != row) return shown;
  if (const auto* work = std::get_if<knit::RowWork>(&state.work)) {
    if (work->ring) shown.ring = &*work->ring;
    take_level(state, work->level, shown);
  } else if (const auto* cast_on = std::get_if<knit::CastOnWork>(&state.work)) {
    if (cast_on->ring) shown.ring = &*cast_on->ring;
    take_level(state, cast_on->level, shown);
  } else if (const auto* contours = std::get_if<knit::ContourWork>(&state.work)) {
    shown.ring = curve_shown(state);
    if (shown.ring == nullptr) return shown;
    shown.level = contours->row;
    const double value = state.tubes->tube(knit::current_tube(*state.tubes, *contours))
                             .values[static_cast<std::size_t>(contours->row)];
    const knit::Timing& timing = *state.timing;
    shown.time = timing.retimed ? knit::height_at(timing.scale, value) / timing.scale.total() : value;
  }
  return shown;
}

const knit::Ring* curve_shown(const knit::State& state) {
  const auto* work = std::get_if<knit::ContourWork>(&state.work);
  if (work == nullptr || work->phase <= knit::ContourPhase::cut || work->phase >= knit::ContourPhase::bridge)
    return nullptr;
  return work->curve ? &*work->curve : &knit::current_curve(*state.tubes, *work);
}

const knit::Join* join_shown(const knit::State& state, std::int32_t row) {
  return knit::planned_join(state, std::max(row, 2));
}

const knit::Ends* ends_shown(const knit::State& state) {
  if (state.timing) return &state.timing->ends;
  const auto* work = std::get_if<knit::TimingWork>(&state.work);
  return work != nullptr && work->ends ? &*work->ends : nullptr;
}

std::vector<Variable> variables_of(const Session& session) {
  const auto at = explained(session);
  if (!at) return {};
  const knit::Timeline& timeline = session.document->timeline;
  const knit::State& state = timeline.state();
  Values values;
  add_parameters(at->stopped ? timeline.parameters_of_stop() : parameters_of_last_step(session), values);
  add_timing(state, values);
  if (at->step != nullptr) {
    const std::int32_t row = at->step->place.row;
    if (at->code->tells_of(knit::Stage::cast_on) || at->code->tells_of(knit::Stage::rows))
      add_row(state, row, values);
    if (at->step->place.stage == knit::Stage::stitches) add_join(state, row, values);
    add_step(*at->step, timeline.input(), state, values);
  }
  std::vector<Variable> variables;
  for (const knit::CodeVariable* variable : variables_in(*at->code))
    variables.push_back({variable, values.take(*variable)});
  return variables;
}

}  // namespace app
