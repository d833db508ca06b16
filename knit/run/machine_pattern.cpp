#include "knit/run/machine.h"
#include "knit/stitches/pattern.h"

namespace knit {

Happening advance_pattern(State& state) {
  const std::int32_t row = state.next.row;
  const auto rows = static_cast<std::int32_t>(state.rows.size());
  const auto stitches = [&] {
    return static_cast<std::int32_t>(state.rows[static_cast<std::size_t>(row) - 1]->stitches.size());
  };
  const bool binding_off = state.next.item > 0;
  PatternLine line = binding_off ? bind_off_line(row, stitches())
                     : row == 1  ? cast_on_line(stitches())
                                 : round_line(*state.transitions[static_cast<std::size_t>(row) - 2]);
  const LineWritten step{line.consumed, line.produced};
  state.lines.emplace_back(std::move(line));
  if (binding_off) {
    state.work = Finished{};
    state.next = {Stage::done, 0, 0};
  } else if (row < rows) {
    state.next = {Stage::pattern, row + 1, 0};
  }
  return step;
}

}  // namespace knit
