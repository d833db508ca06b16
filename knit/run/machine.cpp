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
void keep(std::vector<Shared<Product>>& finished, Shared<Product>&& made) {
  if (made) finished.push_back(std::move(made));
}

Taken take_contours(const Input& input, const Parameters& parameters, State& state, ContourWork& work) {
  const Row* below = state.rows.empty() ? nullptr : &*state.rows.back();
  const ContourRow at{*state.timing, state.next.row, below != nullptr ? size_of(*below) : 0,
                      below != nullptr ? below->time : 0.0};
  Shared<Row> row;
  Taken taken = advance_contours(input, parameters, at, work, row);
  keep(state.rows, std::move(row));
  return taken;
}

Taken take_cast_on(const Input& input, const Parameters& parameters, State& state, CastOnWork& work) {
  Shared<Row> row;
  Taken taken = advance_cast_on(input, parameters, *state.timing, work, {state.last_level, row});
  keep(state.rows, std::move(row));
  return taken;
}

// The first step of the cast on decides where rows come from.
Taken take_first_row(const Input& input, const Parameters& parameters, State& state) {
  if (state.next.item == 0) {
    const bool contours = parameters.rows == RowSource::contours;
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
  const RingRow at{*state.timing, state.last_level, state.next.row, size_of(*state.rows.back())};
  Shared<Row> row;
  Taken taken = advance_rings(input, parameters, at, std::get<RowWork>(state.work), row);
  keep(state.rows, std::move(row));
  return taken;
}

// The transition into row state.next.row, counted from 1.
Taken take_transition(const Parameters& parameters, State& state) {
  const auto above = static_cast<std::size_t>(state.next.row) - 1;
  const TransitionAt at{state.next.row, *state.rows[above - 1],
                        above < state.rows.size() ? &*state.rows[above] : nullptr,
                        above > 1 ? &*state.transitions[above - 2] : nullptr, above + 1 >= state.rows.size()};
  Shared<Transition> transition;
  Taken taken = advance_index(parameters, at, std::get<IndexWork>(state.work), transition);
  keep(state.transitions, std::move(transition));
  return taken;
}

// The number along the knitting path of the first stitch of a row, counted from 0.
std::uint32_t first_stitch_of(const State& state, std::size_t row) {
  std::size_t first = 0;
  for (std::size_t r = 0; r < row; ++r) first += state.rows[r]->stitches.size();
  return static_cast<std::uint32_t>(first);
}

Taken take_strip(State& state) {
  const auto below = static_cast<std::size_t>(state.next.row) - 2;
  auto& work = std::get<FacesWork>(state.work);
  const StripAt at{*state.transitions[below], work.plan ? 0 : first_stitch_of(state, below),
                   below + 1 == state.transitions.size()};
  Shared<Strip> strip;
  Taken taken = advance_faces(at, work, strip);
  keep(state.strips, std::move(strip));
  return taken;
}

Taken take_line(State& state) {
  const auto row = static_cast<std::size_t>(state.next.row) - 1;
  const LineAt at{state.next.row, size_of(*state.rows[row]), row > 0 ? &*state.transitions[row - 1] : nullptr,
                  state.next.item > 0, row + 1 == state.rows.size()};
  Shared<PatternLine> line;
  Taken taken = advance_pattern(at, line);
  keep(state.lines, std::move(line));
  return taken;
}

Taken take(const Input& input, const Parameters& parameters, State& state) {
  switch (state.next.stage) {
    case Stage::timing:
      return advance_timing(input, parameters, std::get<TimingWork>(state.work), state.timing);
    case Stage::cast_on:
      return take_first_row(input, parameters, state);
    case Stage::rows:
      return take_row(input, parameters, state);
    case Stage::stitches:
      return take_transition(parameters, state);
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
      if (!state.rows.empty() && std::holds_alternative<CastOnWork>(state.work) &&
          state.rows.back()->level < state.last_level) {
        return begin(state, Stage::rows, 2, row_work_at(state.rows.back()->level + 1));
      }
      return begin(state, Stage::stitches, 2, IndexWork{});
    case Stage::rows:
      return begin(state, Stage::stitches, 2, IndexWork{});
    case Stage::stitches:
      if (state.transitions.empty()) return begin(state, Stage::pattern, 1, PatternWork{});
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
  return {place, std::move(taken.what)};
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
  if (const auto* contours = std::get_if<ContourWork>(&state.work))
    return next_plans_cuts(parameters, *contours) && planning_is_long(input, parameters);
  if (state.next == Place{Stage::cast_on, 1, 0})
    return parameters.rows == RowSource::contours && planning_is_long(input, parameters);
  const auto* timing = std::get_if<TimingWork>(&state.work);
  return timing != nullptr && input.mesh.triangles.size() >= many_triangles &&
         next_is_a_solve(input, parameters, *timing);
}

std::size_t copy_bytes(const State& state) {
  const std::size_t products =
      state.rows.size() + state.transitions.size() + state.strips.size() + state.lines.size();
  const std::size_t work = std::visit(
      [](const auto& stage) -> std::size_t {
        if constexpr (requires { stage.copy_bytes(); }) return stage.copy_bytes();
        return 0;
      },
      state.work);
  return sizeof(State) + sizeof(void*) * 2 * products + work;
}

}  // namespace knit
