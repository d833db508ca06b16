#include "knit/run/machine.h"
#include "knit/stitches/pattern.h"

namespace knit {

Happening advance_pattern(State& state) {
  const std::int32_t row = state.next.row;
  const auto stitches = [&] { return size_of(state.fabric.row(row)); };
  const bool binding_off = state.next.item > 0;
  PatternLine line = binding_off ? bind_off_line(row, stitches())
                     : row == 1  ? cast_on_line(stitches())
                                 : round_line(*state.fabric.join_into(row));
  const LineWritten step{line.consumed, line.produced};
  state.lines.emplace_back(std::move(line));
  if (binding_off) {
    state.work = Finished{};
    state.next = {Stage::done, 0, 0};
  } else if (row < state.fabric.row_count()) {
    state.next = {Stage::pattern, row + 1, 0};
  }
  return step;
}

}  // namespace knit
