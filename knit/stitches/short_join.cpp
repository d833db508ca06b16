#include "knit/stitches/short_join.h"

#include <numeric>

namespace knit {

Join plan_short_join(std::span<const std::int32_t> mains, const Row& row) {
  const std::int32_t size = size_of(row);
  Join join;
  join.tube = row.tube;
  join.to = row.id;
  join.below = join.above = size;
  join.labels.assign(static_cast<std::size_t>(size), Label::knit);
  join.partner.resize(join.labels.size());
  std::iota(join.partner.begin(), join.partner.end(), 0);
  join.link = join.partner;
  join.mains.assign(mains.begin(), mains.end());
  const auto put = [&](std::int32_t cell, Label label) {
    join.labels[static_cast<std::size_t>(cell)] = label;
    join.placed.push_back({cell, label});
  };
  const std::int32_t end = row.turned->back ? 0 : size - 1;
  for (const std::int32_t main : mains) {
    if (main != end) put(main, Label::main);
  }
  put(end, row.turned->back ? Label::turn_right : Label::turn_left);
  return join;
}

std::vector<std::uint8_t> plain_below(const Join& join) {
  std::vector<std::int32_t> cells_of(static_cast<std::size_t>(join.below), 0);
  std::vector<std::int32_t> shared(static_cast<std::size_t>(join.above), 0);
  for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(join.link.size()); ++cell) {
    const CellEnds ends = ends_of(join, cell);
    ++cells_of[static_cast<std::size_t>(ends.below)];
    ++shared[static_cast<std::size_t>(ends.above)];
  }
  std::vector<std::uint8_t> plain(cells_of.size(), 0);
  for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(join.link.size()); ++cell) {
    const CellEnds ends = ends_of(join, cell);
    const auto below = static_cast<std::size_t>(ends.below);
    plain[below] = cells_of[below] == 1 && shared[static_cast<std::size_t>(ends.above)] == 1 ? 1 : 0;
  }
  // An increase is worked in the bar between two stitches: neither is plain, whichever of them it is linked to.
  const auto cells = static_cast<std::int32_t>(join.labels.size());
  for (std::int32_t cell = 0; cell < cells; ++cell) {
    if (!is_increase(join.labels[static_cast<std::size_t>(cell)])) continue;
    for (const std::int32_t beside : {(cell + cells - 1) % cells, (cell + 1) % cells})
      plain[static_cast<std::size_t>(ends_of(join, beside).below)] = 0;
  }
  return plain;
}

void mark_turns(Join& join, std::span<const std::int32_t> marked) {
  if (marked.empty()) return;
  std::size_t next = 0;
  for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(join.link.size()); ++cell) {
    const std::int32_t below = ends_of(join, cell).below;
    while (next < marked.size() && marked[next] < below) ++next;
    Label& label = join.labels[static_cast<std::size_t>(cell)];
    if (next == marked.size() || marked[next] != below || label != Label::knit) continue;
    label = Label::marked;
    join.placed.push_back({cell, label});
    ++next;
  }
}

std::vector<std::array<std::int32_t, 2>> short_arcs_below(const Fabric& fabric, RowId round) {
  std::vector<std::array<std::int32_t, 2>> arcs;
  const LiveStitches under = fabric.under_short_rows(fabric.row(round).on);
  for (const auto& row : fabric.rows()) {
    if (row->id >= round) break;
    if (!is_short(*row) || row->turned->back) continue;
    const LiveStitches on = fabric.under_short_rows(row->on);
    const std::int32_t first = place_in(under, on.at(0));
    if (first < 0) continue;  // of another round
    const std::int32_t last = first + on.size() - 1, all = under.size();
    arcs.push_back(last < all ? std::array{first, last} : std::array{first - all, last - all});
  }
  return arcs;
}

}  // namespace knit
