#include "knit/run/machine.h"

#include <cmath>
#include <utility>

#include "knit/model/bug.h"

namespace knit {

namespace {

// What a step did, and what ended with it.
struct Taken {
  Event what;
  Ended ended = Ended::step;

  template <class StageEvent>
  Taken(Advanced<StageEvent> advanced)
      : what(std::visit([](auto& happened) { return Event(std::move(happened)); }, advanced.what)),
        ended(advanced.ended) {}
};

template <class Product>
void keep(Fabric& fabric, Product&& made) {
  if (made) fabric.add(std::move(*made));
}
void keep(Fabric& fabric, Shared<Join>&& made) {
  if (made) fabric.add(std::move(made));
}
void keep(Fabric& fabric, Shared<Strip>&& made) {
  if (made) fabric.add(std::move(made));
}

Taken take_contours(const Input& input, const Parameters& parameters, State& state, ContourWork& work) {
  const LiveStitches on = state.fabric.live();
  const Row* below = state.fabric.row_below(state.fabric.next_row());
  const ContourRow at{*state.timing, state.next.row, on, below != nullptr ? below->time : 0.0};
  std::optional<Row> row;
  Taken taken = advance_contours(input, parameters.rows, parameters.stitch, at, work, row);
  keep(state.fabric, std::move(row));
  return taken;
}

Taken take_cast_on(const Input& input, const Parameters& parameters, State& state, CastOnWork& work) {
  std::optional<Row> row;
  Taken taken = advance_cast_on(input, parameters.rows, parameters.stitch, *state.timing, work,
                                {state.last_level, row});
  keep(state.fabric, std::move(row));
  return taken;
}

// The first step of the cast on decides where rows come from.
Taken take_first_row(const Input& input, const Parameters& parameters, State& state) {
  if (state.next.item == 0) {
    const bool contours = parameters.rows.source == RowSource::contours;
    state.work = contours ? Work(ContourWork{}) : Work(CastOnWork{});
  }
  if (auto* rings = std::get_if<CastOnWork>(&state.work)) {
    return take_cast_on(input, parameters, state, *rings);
  }
  Taken taken = take_contours(input, parameters, state, std::get<ContourWork>(state.work));
  if (state.next.item == 0 && is<Stopped>(taken.what)) state.work = CastOnWork{};
  return taken;
}

Taken take_row(const Input& input, const Parameters& parameters, State& state) {
  if (auto* contours = std::get_if<ContourWork>(&state.work)) {
    return take_contours(input, parameters, state, *contours);
  }
  const LiveStitches on = state.fabric.live();
  const RingRow at{*state.timing, state.last_level, state.next.row, on};
  std::optional<Row> row;
  Taken taken =
      advance_rings(input, parameters.rows, parameters.stitch, at, std::get<RowWork>(state.work), row);
  keep(state.fabric, std::move(row));
  return taken;
}

// The join into row state.next.row; where the cast on is the only row, there is none to make.
Taken take_join(const Parameters& parameters, State& state) {
  const Fabric& fabric = state.fabric;
  const RowId row = state.next.row;
  const Row* below = fabric.row_below(row);
  const JoinAt at{row,
                  *below,
                  fabric.live_below(row),
                  fabric.find_row(row),
                  fabric.join_into(below->id),
                  !fabric.has_row(row + 1)};
  Shared<Join> join;
  Taken taken =
      advance_index(parameters.stitches, parameters.stitch, at, std::get<IndexWork>(state.work), join);
  keep(state.fabric, std::move(join));
  return taken;
}

Taken take_strip(State& state) {
  const RowId row = state.next.row;
  const StripAt at{state.fabric, *state.fabric.join_into(row), !state.fabric.has_row(row + 1)};
  Shared<Strip> strip;
  Taken taken = advance_faces(at, std::get<FacesWork>(state.work), strip);
  keep(state.fabric, std::move(strip));
  return taken;
}

Taken take_line(State& state) {
  const RowId row = state.next.row;
  const LineAt at{row, size_of(state.fabric.row(row)), state.fabric.join_into(row), state.next.item > 0,
                  row == state.fabric.row_count()};
  Shared<CountedLine> line;
  Taken taken = advance_pattern(at, line);
  if (line) state.lines.push_back(std::move(line));
  return taken;
}

Taken take(const Input& input, const Parameters& parameters, State& state) {
  switch (state.next.stage) {
    case Stage::timing:
      return advance_timing(input, parameters.timing, std::get<TimingWork>(state.work), state.timing);
    case Stage::cast_on:
      return take_first_row(input, parameters, state);
    case Stage::rows:
      return take_row(input, parameters, state);
    case Stage::stitches:
      return take_join(parameters, state);
    case Stage::faces:
      return take_strip(state);
    case Stage::pattern:
      return take_line(state);
    case Stage::import:
    case Stage::done:
      break;
  }
  throw Bug("advance() was called on a finished state");
}

// --- From stage to stage -------------------------------------------------------------------------------------

void begin(State& state, Stage stage, std::int32_t row, Work work) {
  state.work = std::move(work);
  state.next = {stage, row, 0};
}

void begin_next_stage(State& state) {
  switch (state.next.stage) {
    case Stage::timing:
      return begin(state, Stage::cast_on, 1, CastOnWork{});
    case Stage::cast_on:
      // From contours the stage cast on ends only where no row follows; rings may have levels left.
      if (const Row* cast_on = state.fabric.find_row(1); cast_on != nullptr &&
                                                         std::holds_alternative<CastOnWork>(state.work) &&
                                                         cast_on->level < state.last_level) {
        return begin(state, Stage::rows, 2, row_work_at(cast_on->level + 1));
      }
      return begin(state, Stage::stitches, 2, IndexWork{});
    case Stage::rows:
      return begin(state, Stage::stitches, 2, IndexWork{});
    case Stage::stitches:
      if (state.fabric.joins().empty()) return begin(state, Stage::pattern, 1, PatternWork{});
      return begin(state, Stage::faces, 2, FacesWork{});
    case Stage::faces:
      return begin(state, Stage::pattern, 1, PatternWork{});
    case Stage::pattern:
    case Stage::import:
    case Stage::done:
      return begin(state, Stage::done, 0, Finished{});
  }
}

void hand_on(State& state, Ended ended) {
  switch (ended) {
    case Ended::step:
      ++state.next.item;
      return;
    case Ended::row: {
      const bool first_row = state.next.stage == Stage::cast_on;
      state.next = {first_row ? Stage::rows : state.next.stage, state.next.row + 1, 0};
      return;
    }
    case Ended::stage:
      return begin_next_stage(state);
  }
}

}  // namespace

Step advance(const Input& input, const Parameters& parameters, State& state) {
  const Place place = state.next;
  Taken taken = take(input, parameters, state);
  if (!is<Stopped>(taken.what)) hand_on(state, taken.ended);
  return {place, taken.what};
}

namespace {

constexpr std::size_t many_triangles = 20000;
constexpr double many_crossings = 20000.0;  // of cuts and edges: some milliseconds

// The cuts of all rows, each of which goes through about as many triangles as lie side by side.
bool planning_is_long(const Input& input, const Parameters& parameters) {
  const auto triangles = static_cast<double>(input.mesh.triangles.size());
  const double cuts = input.bounds.diagonal() / parameters.stitch.height;
  return input.mesh.triangles.size() >= many_triangles || cuts * std::sqrt(triangles) > many_crossings;
}

}  // namespace

bool step_is_long(const Input& input, const Parameters& parameters, const State& state) {
  if (const auto* contours = std::get_if<ContourWork>(&state.work))
    return next_plans_cuts(parameters.stitch, *contours) && planning_is_long(input, parameters);
  if (state.next == Place{Stage::cast_on, 1, 0})
    return parameters.rows.source == RowSource::contours && planning_is_long(input, parameters);
  const auto* timing = std::get_if<TimingWork>(&state.work);
  return timing != nullptr && input.mesh.triangles.size() >= many_triangles &&
         next_is_a_solve(input, parameters.timing, *timing);
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
  const std::size_t work = std::visit(
      [](const auto& stage) -> std::size_t {
        if constexpr (requires { stage.copy_bytes(); }) return stage.copy_bytes();
        return 0;
      },
      state.work);
  return sizeof(State) + state.fabric.copy_bytes() + sizeof(void*) * 2 * state.lines.size() + work;
}

}  // namespace knit
