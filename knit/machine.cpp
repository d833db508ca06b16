#include "knit/machine.h"

#include "knit/bug.h"

namespace knit {

namespace {

Happening advance_stage(const Input& input, const Parameters& parameters, State& state) {
  switch (state.next.stage) {
    case Stage::timing:
      return advance_timing(input, parameters, state);
    case Stage::cast_on:
      return advance_cast_on(input, parameters, state);
    case Stage::rows:
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

std::size_t copy_bytes(const State& state) {
  std::size_t bytes = sizeof(State);
  bytes += sizeof(void*) * 2 *
           (state.rows.size() + state.transitions.size() + state.strips.size() + state.lines.size());
  if (const auto* timing = std::get_if<TimingWork>(&state.work)) bytes += timing->times.copy_bytes();
  if (const auto* cast_on = std::get_if<CastOnWork>(&state.work))
    bytes += cast_on->stitches.size() * sizeof(Stitch);
  if (const auto* row = std::get_if<RowWork>(&state.work)) {
    bytes += (row->walk.kept.size() + row->closed.orders.size()) * sizeof(std::int32_t);
    bytes += row->closed.stitches.size() * sizeof(Stitch);
  }
  return bytes;
}

}  // namespace knit
