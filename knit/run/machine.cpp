#include "knit/run/machine.h"

#include <cmath>

#include "knit/model/bug.h"

namespace knit {

namespace {

// The first step of the cast on decides where rows come from.
Happening advance_first_row(const Input& input, const Parameters& parameters, State& state) {
  if (state.next.item == 0) {
    const bool contours = parameters.rows == RowSource::contours;
    state.work = contours ? Work(ContourWork{}) : Work(CastOnWork{});
  }
  if (!std::holds_alternative<ContourWork>(state.work)) return advance_cast_on(input, parameters, state);
  Happening happening = advance_contours(input, parameters, state);
  if (state.next.item == 0 && std::holds_alternative<Stopped>(happening)) state.work = CastOnWork{};
  return happening;
}

Happening advance_stage(const Input& input, const Parameters& parameters, State& state) {
  switch (state.next.stage) {
    case Stage::timing:
      return advance_timing(input, parameters, state);
    case Stage::cast_on:
      return advance_first_row(input, parameters, state);
    case Stage::rows:
      if (std::holds_alternative<ContourWork>(state.work)) return advance_contours(input, parameters, state);
      return advance_rows(input, parameters, state);
    case Stage::stitches:
      return advance_stitches(parameters, state);
    case Stage::faces:
      return advance_faces(state);
    case Stage::pattern:
      return advance_pattern(state);
    case Stage::import:
    case Stage::done:
      break;
  }
  throw Bug("advance() was called on a finished state");
}

}  // namespace

Step advance(const Input& input, const Parameters& parameters, State& state) {
  const Place place = state.next;
  Step step{place, advance_stage(input, parameters, state)};
  // A stage that moves to another row or stage sets the next place itself.
  if (!is_stop(step) && state.next == place) ++state.next.item;
  return step;
}

namespace {

constexpr std::size_t many_triangles = 20000;
constexpr double many_crossings = 20000.0;  // of cuts and edges: some milliseconds

// The cuts of all rows, each of which goes through about as many triangles as lie side by side.
bool planning_is_long(const Input& input, const Parameters& parameters) {
  const auto triangles = static_cast<double>(input.mesh.triangles.size());
  const double cuts = input.bounds.diagonal() / stitch_height_of(parameters);
  return input.mesh.triangles.size() >= many_triangles || cuts * std::sqrt(triangles) > many_crossings;
}

}  // namespace

bool step_is_long(const Input& input, const Parameters& parameters, const State& state) {
  if (const auto* contours = std::get_if<ContourWork>(&state.work)) {
    const bool anew =
        contours->phase == ContourPhase::cut && contours->plan->stitch_height != stitch_height_of(parameters);
    return anew && planning_is_long(input, parameters);
  }
  if (state.next == Place{Stage::cast_on, 1, 0})
    return parameters.rows == RowSource::contours && planning_is_long(input, parameters);
  if (input.mesh.triangles.size() < many_triangles) return false;
  const auto* timing = std::get_if<TimingWork>(&state.work);
  if (timing == nullptr) return false;
  const TimingKind kind = timing->ends ? timing->kind : parameters.timing;
  if (kind == TimingKind::linear) return timing->times.size() == input.mesh.positions.size();
  return timing->ends && (!timing->times.empty() ? timing->times.size() == input.mesh.positions.size()
                                                 : !timing->field || !timing->scale);
}

const Join* planned_join(const State& state, RowId into) {
  const auto* work = std::get_if<IndexWork>(&state.work);
  const bool in_progress = work != nullptr && work->plan && work->plan->to == into;
  return in_progress ? &*work->plan : state.fabric.join_into(into);
}

const Strip* planned_strip(const State& state, RowId into) {
  const auto* work = std::get_if<FacesWork>(&state.work);
  const bool in_progress = work != nullptr && work->plan && work->plan->to == into;
  return in_progress ? &*work->plan : state.fabric.strip_into(into);
}

std::size_t copy_bytes(const State& state) {
  std::size_t bytes = sizeof(State);
  bytes += state.fabric.copy_bytes() + sizeof(void*) * 2 * state.lines.size();
  if (const auto* timing = std::get_if<TimingWork>(&state.work)) bytes += timing->times.copy_bytes();
  if (const auto* cast_on = std::get_if<CastOnWork>(&state.work))
    bytes += cast_on->stitches.size() * sizeof(Stitch);
  if (const auto* contour = std::get_if<ContourWork>(&state.work))
    bytes += contour->stitches.size() * sizeof(Stitch);
  if (const auto* row = std::get_if<RowWork>(&state.work)) {
    bytes += (row->walk.kept.size() + row->closed.orders.size()) * sizeof(std::int32_t);
    bytes += row->closed.stitches.size() * sizeof(Stitch);
  }
  return bytes;
}

}  // namespace knit
