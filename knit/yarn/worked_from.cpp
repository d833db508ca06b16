#include "knit/yarn/worked_from.h"

#include <algorithm>

namespace knit {

namespace {

LoopKind kind_of(Label label) {
  switch (label) {
    case Label::m1r:
      return LoopKind::m1r;
    case Label::m1l:
      return LoopKind::m1l;
    case Label::k2tog:
      return LoopKind::k2tog;
    case Label::ssk:
      return LoopKind::ssk;
    default:
      return LoopKind::knit;
  }
}

using Numbers = std::vector<std::uint32_t>;

// The stitches at places from `place` - 2 on, round and round; at the end of a stretch the last one again.
std::array<std::uint32_t, 4> beside_bar(const Numbers& below, std::size_t place, bool closed) {
  std::array<std::uint32_t, 4> beside{};
  const auto count = static_cast<std::int64_t>(below.size());
  for (std::size_t i = 0; i < beside.size(); ++i) {
    std::int64_t at = static_cast<std::int64_t>(place + i) - 2;
    at = closed ? (at % count + count) % count : std::clamp<std::int64_t>(at, 0, count - 1);
    beside[i] = below[static_cast<std::size_t>(at)];
  }
  return beside;
}

// An increase takes nothing, whatever its cell hangs on; all other cells take the stitches below in order.
void grow(const Join& join, const Numbers& below, const Numbers& above, std::vector<WorkedFrom>& all) {
  std::size_t place = 0;
  for (std::size_t cell = 0; cell < above.size(); ++cell) {
    WorkedFrom& made = all[above[cell]];
    made.kind = kind_of(join.labels[cell]);
    if (is_increase(made.kind)) {
      made.beside = beside_bar(below, place, join.from.closed);
    } else {
      made.kind = LoopKind::knit;
      made.parents[0] = below[place++];
    }
  }
}

void shrink(const Join& join, const Numbers& below, const Numbers& above, std::vector<WorkedFrom>& all) {
  for (std::size_t cell = 0; cell < below.size(); ++cell) {
    WorkedFrom& made = all[above[static_cast<std::size_t>(join.link[cell])]];
    if (made.parents[0] == no_stitch) {
      made.kind = LoopKind::knit;
      made.parents[0] = below[cell];
    } else {
      made.parents[1] = below[cell];
    }
    if (is_decrease(join.labels[cell])) made.kind = kind_of(join.labels[cell]);
  }
}

// The row of a ring that is made first is the edge; the other's stitches are picked up from it.
void share_edge(const Fabric& fabric, const Deal& deal, std::vector<WorkedFrom>& all) {
  const Numbers one = fabric.path_indices(deal.taken[0]), two = fabric.path_indices(deal.taken[1]);
  const bool one_first = one.front() < two.front();
  for (const std::uint32_t stitch : one_first ? one : two) all[stitch].kind = LoopKind::bridge;
  const Numbers& picked = one_first ? two : one;
  for (const std::uint32_t stitch : picked) all[stitch].kind = LoopKind::picked_up;
  for (const auto& [a, b] : deal.column_edges) {
    const std::uint32_t above = all[a].kind == LoopKind::picked_up ? a : b, edge = above == a ? b : a;
    WorkedFrom& made = all[above];
    made.parents[made.parents[0] == no_stitch ? 0 : 1] = edge;
  }
}

bool takes_from(const LiveStitches& live, RowId row) {
  return std::any_of(live.spans.begin(), live.spans.end(),
                     [&](const StitchSpan& span) { return span.row == row; });
}

class Paths {
 public:
  explicit Paths(const Fabric& fabric) : fabric_(fabric) {}

  std::vector<YarnPath> all() {
    const Row* before = nullptr;
    for (RowId id = 1; id <= fabric_.row_count(); ++id) {
      if (before == nullptr || !goes_on(*before, fabric_.row(id))) paths_.emplace_back();
      before = &fabric_.row(id);
      if (is_short(fabric_.row(id))) {
        shorts_.push_back(id);
      } else {
        add_round(id);
      }
      add_bridges(id);
    }
    // Short rows without a round over them: a fabric that is not whole.
    flush_shorts();
    std::erase_if(paths_, [](const YarnPath& path) { return path.steps.empty(); });
    return std::move(paths_);
  }

 private:
  // Whether the yarn that worked the row before works this one.
  [[nodiscard]] bool goes_on(const Row& before, const Row& row) const {
    if (row.tube == before.tube && is_short(before)) return true;
    return takes_from(row.on, before.id) || goes_on_over_bridge(before.id, row.on);
  }
  [[nodiscard]] bool goes_on_over_bridge(RowId before, const LiveStitches& on) const {
    std::int32_t number = 0;
    return std::any_of(fabric_.deals().begin(), fabric_.deals().end(), [&](const Shared<Deal>& deal) {
      return takes_from(on, bridge_row(++number)) && deal->after == before &&
             std::any_of(deal->taken.begin(), deal->taken.end(),
                         [&](const LiveStitches& live) { return takes_from(live, before); });
    });
  }

  void add(RowId row, std::int32_t from, std::int32_t to, bool back) {
    const Numbers& numbers = numbers_of(row);
    for (std::int32_t i = from; i < to; ++i) {
      const std::int32_t place = back ? to - 1 - (i - from) : i;
      paths_.back().steps.push_back({numbers[static_cast<std::size_t>(place)], back});
    }
    paths_.back().last = row;
  }
  [[nodiscard]] const Numbers& numbers_of(RowId row) {
    if (kept_row_ != row) kept_ = fabric_.path_indices(all_of(fabric_.row(row)));
    kept_row_ = row;
    return kept_;
  }

  // Of a round over short rows, how many of its stitches are made before the stitch at a place below.
  [[nodiscard]] std::int32_t made_before(RowId round, std::int32_t place) const {
    const Join* join = fabric_.join_into(round);
    if (join == nullptr) return place;
    if (!cells_above(*join)) return join->link[static_cast<std::size_t>(place)];
    std::int32_t cell = 0;
    for (std::int32_t taken = 0; cell < join->above; ++cell) {
      const Label label = join->labels[static_cast<std::size_t>(cell)];
      if (is_increase(label)) continue;
      if (taken++ == place) break;
    }
    return cell;
  }

  void add_round(RowId round) {
    const std::int32_t size = size_of(fabric_.row(round));
    std::int32_t done = 0;
    const LiveStitches under = fabric_.under_short_rows(fabric_.row(round).on);
    for (std::size_t i = 0; i + 1 < shorts_.size(); i += 2) {
      const Row& there = fabric_.row(shorts_[i]);
      const LiveStitches on = fabric_.under_short_rows(there.on);
      const std::int32_t first = place_in(under, on.at(0)), all = under.size();
      const std::int32_t count = size_of(there);
      const bool over = first + count > all;  // the beginning of the round
      if (!over && first >= 0) {
        const std::int32_t until = made_before(round, first);
        if (until > done) add(round, done, until, false);
        done = std::max(done, until);
      }
      const std::int32_t before = over ? all - first : 0;
      add(shorts_[i], before, count, false);
      add(shorts_[i + 1], before, count, true);
      if (over) {
        add(shorts_[i], 0, before, true);
        add(shorts_[i + 1], 0, before, false);
      }
    }
    shorts_.clear();
    add(round, done, size, false);
  }
  void flush_shorts() {
    for (const RowId id : shorts_) add(id, 0, size_of(fabric_.row(id)), works_back(fabric_.row(id)));
    shorts_.clear();
  }

  void add_bridges(RowId after) {
    for (std::size_t i = 0; i < fabric_.deals().size(); ++i) {
      const Deal& deal = *fabric_.deals()[i];
      if (deal.after != after) continue;
      const auto first = fabric_.first_on_path(bridge_row(static_cast<std::int32_t>(i) + 1));
      for (std::uint32_t k = 0; k < deal.bridge.size(); ++k)
        paths_.back().steps.push_back({first + k, false});
    }
  }

  const Fabric& fabric_;
  std::vector<YarnPath> paths_;
  std::vector<RowId> shorts_;  // since the last round, there and back by turns
  Numbers kept_;
  RowId kept_row_ = 0;
};

}  // namespace

std::vector<WorkedFrom> worked_from(const Fabric& fabric) {
  std::vector<WorkedFrom> all(fabric.stitch_count());
  for (const auto& join : fabric.joins()) {
    const Numbers below = fabric.path_indices(join->from);
    const Numbers above = fabric.path_indices(all_of(fabric.row(join->to)));
    if (cells_above(*join)) {
      grow(*join, below, above, all);
    } else {
      shrink(*join, below, above, all);
    }
  }
  for (std::size_t i = 0; i < fabric.deals().size(); ++i) {
    const Deal& deal = *fabric.deals()[i];
    if (deal.kind == DealKind::ring_cast_on) share_edge(fabric, deal, all);
    const auto first = fabric.first_on_path(bridge_row(static_cast<std::int32_t>(i) + 1));
    for (std::uint32_t k = 0; k < deal.bridge.size(); ++k) all[first + k].kind = LoopKind::bridge;
  }
  return all;
}

std::vector<YarnPath> yarn_paths(const Fabric& fabric) { return Paths(fabric).all(); }

}  // namespace knit
