#include "app/explain/code_variables.h"

#include <algorithm>
#include <concepts>
#include <cstdio>
#include <glm/geometric.hpp>

#include "app/explain/code_variable_table.h"
#include "app/explain/step_table.h"
#include "app/session/document.h"
#include "knit/insight/narrate.h"
#include "knit/insight/step_fields.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"

namespace app {

namespace {

// Where a step's number is a variable of another name.
struct Alias {
  std::string_view kind, field, name;
};
constexpr std::array aliases{
    Alias{"ends-found", "length", "mag"},
    Alias{"field-solved", "what", ""},
    Alias{"cycle-found", "vertices", "count"},
    Alias{"stitch-cast-on", "stitch", "item"},
    Alias{"stitch-cast-on", "of", "k"},
    Alias{"cycle-gathered", "vertices", "count"},
    Alias{"cycle-ordered", "vertices", "count"},
    Alias{"candidate-measured", "distance", "d"},
    Alias{"band-missed", "taken", "candidate"},
    Alias{"band-missed", "distance", "d"},
    Alias{"band-missed", "skipped_distance", "skipped"},
    Alias{"row-closed", "stitches", "n"},
    Alias{"row-resampled", "stitches", "n"},
    Alias{"gap-shared", "stitches", "n"},
    Alias{"gap-shared", "per_stitch", "share"},
    Alias{"gap-shared", "gap_before", "gap"},
    Alias{"rows-planned", "height", "surface_height"},
    Alias{"count-chosen", "stitches", "n"},
    Alias{"stitch-placed", "stitch", "item"},
    Alias{"stitch-placed", "of", "n"},
    Alias{"rows-matched", "sum_of_squares", "sum"},
    Alias{"transition-counted", "mains_wanted", "wanted"},
    Alias{"transition-counted", "mains_before", "mains"},
    Alias{"spacing-chosen", "mains", "mains_set"},
};

// Names and values, each name once; the newest counts.
class Values {
 public:
  void set(std::string_view name, std::string value) {
    const auto at = find(name);
    if (at != values_.end()) {
      at->second = std::move(value);
    } else {
      values_.emplace_back(name, std::move(value));
    }
  }
  void set(std::string_view name, double value) { set(name, knit::short_number(value)); }
  template <std::integral Whole>
  void set(std::string_view name, Whole value) {
    set(name, std::to_string(value));
  }
  [[nodiscard]] std::string take(std::string_view name) {
    const auto at = find(name);
    return at != values_.end() ? std::move(at->second) : std::string();
  }

 private:
  std::vector<std::pair<std::string_view, std::string>>::iterator find(std::string_view name) {
    return std::find_if(values_.begin(), values_.end(), [&](const auto& pair) { return pair.first == name; });
  }
  std::vector<std::pair<std::string_view, std::string>> values_;
};

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
  values.set("width", parameters.stitch.width);
  values.set("epsilon", parameters.epsilon());
  values.set("stitch_height", parameters.stitch.height);
  values.set("metric", parameter_text(parameters, knit::keys::metric));
  values.set("tolerance", parameters.timing.level_tolerance);
}

void add_timing(const knit::State& state, Values& values) {
  const knit::Ends* ends = ends_shown(state);
  if (ends == nullptr) return;
  values.set("start", ends->start);
  values.set("end", ends->end);
  values.set("direction", vector_text(ends->direction));
  values.set("mag", glm::length(ends->direction));
  const auto* work = std::get_if<knit::TimingWork>(&state.work);
  if (work != nullptr && work->scale) values.set("height", work->scale->total());
}

void add_row(const knit::State& state, std::int32_t row, Values& values) {
  const RowShown shown = row_shown(state, row);
  if (shown.level) values.set("level", *shown.level);
  if (shown.time) values.set("time", *shown.time);
  if (shown.below != nullptr) values.set("below", shown.below->stitches.size());
  if (shown.ring != nullptr) {
    values.set("count", shown.ring->points.size());
    values.set("points", shown.ring->points.size());
    values.set("length", shown.ring->length);
  }
  const auto* walk = std::get_if<knit::RowWork>(&state.work);
  const auto* contour = std::get_if<knit::ContourWork>(&state.work);
  if (shown.finished != nullptr) {
    values.set("n", shown.finished->stitches.size());
  } else if (walk != nullptr && walk->phase == knit::RowPhase::measure) {
    values.set("n", walk->walk.kept.size() + 1);
  } else if (contour != nullptr && contour->count > 0) {
    values.set("n", contour->count);
  }
}

void add_join(const knit::State& state, std::int32_t row, Values& values) {
  const knit::Fabric& fabric = state.fabric;
  const knit::RowId into = std::max(row, 2);
  const knit::Row* below = fabric.row_below(into);
  if (below == nullptr || !fabric.has_row(into)) return;
  values.set("below", below->stitches.size());
  values.set("above", fabric.row(into).stitches.size());
  if (const knit::Join* before = fabric.join_into(below->id)) values.set("mains", before->mains.size());
  const knit::Join* plan = join_shown(state, row);
  if (plan == nullptr) return;
  values.set("change", plan->change());
  values.set("wanted", (std::abs(plan->change()) + 1) / 2);
  values.set("rule", std::string(knit::name_of(plan->rule)));
  if (plan->spacing > 0) values.set("spacing", plan->spacing);
  values.set("remainder", plan->remainder);
}

// A solve's numbers mean something else by what was solved for.
void add_solve(const knit::FieldSolved& step, Values& values) {
  switch (step.which) {
    case knit::FieldStep::net:
      return values.set("net", step.count);
    case knit::FieldStep::slopes:
      return values.set("slopes", step.count);
    case knit::FieldStep::heat:
    case knit::FieldStep::harmonic:
      return values.set("unknowns", step.count);
    case knit::FieldStep::distance:
      values.set("unknowns", step.count);
      values.set("far", step.high);
      return values.set("end", step.vertex);
  }
}

void add_stop(const knit::Stopped& stop, Values& values) {
  if (stop.level >= 0 && stop.time > 0.0) {
    values.set("level", stop.level);
    values.set("time", stop.time);
  }
  switch (stop.reason) {
    case knit::StopReason::stall:
      values.set("anchor", stop.vertex);
      values.set("stitch", stop.count);
      return values.set("skipped", stop.value);
    case knit::StopReason::changes_too_much:
      values.set("n", stop.count);
      return values.set("below", stop.other);
    case knit::StopReason::splits:
      return values.set("loops", stop.count);
    case knit::StopReason::not_a_ring:
      return values.set("count", stop.count);
    case knit::StopReason::no_extent:
    case knit::StopReason::no_row_levels:
    case knit::StopReason::too_fine:
      return;
  }
}

std::string_view variable_of_field(std::string_view kind, std::string_view field) {
  const auto alias = std::find_if(aliases.begin(), aliases.end(),
                                  [&](const Alias& a) { return a.kind == kind && a.field == field; });
  return alias != aliases.end() ? alias->name : field;
}

// The step's own numbers, as its table has them.
void add_step(const knit::Step& step, const knit::Input& input, const knit::State& state, Values& values) {
  if (const auto* stop = knit::get_if<knit::Stopped>(step)) return add_stop(*stop, values);
  if (const auto* solve = knit::get_if<knit::FieldSolved>(step)) return add_solve(*solve, values);
  const auto fields = knit::fields_of(step);
  const auto numbers = numbers_of(step);
  for (std::size_t i = 0; i < fields.size(); ++i)
    values.set(variable_of_field(knit::kind_name(step), fields[i].name), numbers[i].second);
  const knit::Ends* ends = ends_shown(state);
  const auto* timed = knit::get_if<knit::VertexTimed>(step);
  if (timed != nullptr && ends != nullptr) {
    const auto& positions = input.mesh.positions;
    values.set("diff", vector_text(positions[timed->vertex] - positions[ends->start]));
  }
  if (knit::is<knit::LineWritten>(step)) values.set("row", step.place.row);
}

const knit::Cut* cut_of(const knit::ContourWork& work) {
  const bool there = work.plan && static_cast<std::size_t>(work.cut) < work.plan->cuts.size();
  return there ? &work.plan->cuts[static_cast<std::size_t>(work.cut)] : nullptr;
}

void take_level(const knit::State& state, std::int32_t level, RowShown& shown) {
  if (level < 0 || !state.timing || level >= state.timing->levels.count()) return;
  shown.level = level;
  shown.time = state.timing->levels.times[static_cast<std::size_t>(level)];
}

}  // namespace

VariableInfo variable_named(std::string_view name) {
  const auto at = std::find_if(variable_table.begin(), variable_table.end(),
                               [&](const VariableInfo& info) { return info.name == name; });
  return at != variable_table.end() ? *at : VariableInfo{};
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
    const knit::Cut* cut = cut_of(*contours);
    if (cut == nullptr || contours->phase <= knit::ContourPhase::cut) return shown;
    if (contours->phase > knit::ContourPhase::loop) shown.ring = &*cut->loops.front();
    shown.level = contours->cut;
    shown.time = cut->time;
  }
  return shown;
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
    if (at->listing == Listing::cast_on || at->listing == Listing::rows_rings ||
        at->listing == Listing::rows_contours) {
      add_row(state, row, values);
    }
    if (at->step->place.stage == knit::Stage::stitches) add_join(state, row, values);
    add_step(*at->step, timeline.input(), state, values);
  }
  std::vector<Variable> variables;
  for (const std::string_view name : variable_names_of(at->listing)) {
    const VariableInfo info = variable_named(name);
    variables.push_back({info.name, info.symbol, info.meaning, values.take(name)});
  }
  return variables;
}

}  // namespace app
