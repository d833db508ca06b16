// Fabrics of no shape: loops are cast on, worked, split and joined by chance, down to loops that are dealt on without a row.
#pragma once

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "knit/run/state.h"

namespace test_support {

class RandomFabric {
 public:
  explicit RandomFabric(unsigned seed) : random_(seed) {}

  knit::State run(int events) {
    cast_on();
    for (int i = 0; i < events; ++i) {
      const int what = below(10);
      if (what < 2)
        cast_on();
      else if (what < 6)
        split();
      else
        join();
    }
    for (const knit::TubeId tube : live_) {
      if (begun_.count(tube) == 0) add_rows(tube, 1 + below(3));
    }
    return std::move(state_);
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  std::size_t any_live() { return static_cast<std::size_t>(below(static_cast<int>(live_.size()))); }

  void cast_on() {
    knit::Row row;
    row.tube = next_++;
    row.id = state_.fabric.next_row();
    row.stitches.resize(static_cast<std::size_t>(3 + below(10)));
    const knit::TubeId tube = row.tube;
    state_.fabric.add(std::move(row));
    begun_.insert(tube);
    live_.push_back(tube);
    add_rows(tube, below(4));
  }

  void add_rows(knit::TubeId tube, int count) {
    for (int i = 0; i < count; ++i) add_row(tube);
    if (count > 0) begun_.insert(tube);
  }
  void maybe_add_rows(knit::TubeId tube) { add_rows(tube, below(5) < 3 ? 1 + below(3) : 0); }

  void add_row(knit::TubeId tube) {
    const knit::LiveStitches on = state_.fabric.live(tube);
    const int n = on.size();
    const int wanted = below(10) == 0 ? 2 * n : n + below(7) - 3;
    const int m = std::clamp(wanted, std::max(3, (n + 1) / 2), 2 * n);
    knit::Join join;
    join.tube = tube;
    join.to = state_.fabric.next_row();
    join.from = on;
    join.below = n;
    join.above = m;
    link_by_chance(join);
    knit::Row row;
    row.tube = tube;
    row.id = join.to;
    row.on = on;
    row.stitches.resize(static_cast<std::size_t>(m));
    state_.fabric.add(std::move(row));
    state_.fabric.add(knit::Shared(std::move(join)));
  }

  void link_by_chance(knit::Join& join) {
    const int small = std::min(join.below, join.above);
    std::vector<int> twice(static_cast<std::size_t>(small), 0);
    for (int left = std::max(join.below, join.above) - small; left > 0;) {
      int& here = twice[static_cast<std::size_t>(below(small))];
      left -= here == 0 ? 1 : 0;
      here = 1;
    }
    for (int stitch = 0; stitch < small; ++stitch) {
      const int cell = static_cast<int>(join.link.size());
      const int cells = twice[static_cast<std::size_t>(stitch)] + 1;
      for (int i = 0; i < cells; ++i) {
        join.link.push_back(stitch);
        join.labels.push_back(knit::Label::knit);
        join.partner.push_back(cell + i);
      }
      if (cells == 1) continue;
      const int labelled = cell + below(2);
      const bool left = below(2) == 0;
      const knit::Label made = left ? knit::Label::m1l : knit::Label::m1r;
      const knit::Label taken = left ? knit::Label::ssk : knit::Label::k2tog;
      join.labels[static_cast<std::size_t>(labelled)] = join.above >= join.below ? made : taken;
      join.partner[static_cast<std::size_t>(labelled)] = labelled == cell ? cell + 1 : cell;
    }
  }

  [[nodiscard]] knit::LiveStitches bridge(int stitches, bool backwards) const {
    const knit::RowId row = knit::bridge_row(static_cast<std::int32_t>(state_.fabric.deals().size()) + 1);
    knit::LiveStitches live;
    for (int i = 0; i < stitches; ++i) live.append({row, backwards ? stitches - 1 - i : i, 1});
    return live;
  }
  knit::LiveStitches turned(const knit::LiveStitches& live) { return begun_at(live, below(live.size())); }

  void deal(knit::Deal deal, const std::vector<std::size_t>& gone) {
    deal.after = state_.fabric.row_count();
    const std::vector<knit::TubeId> to = deal.to;
    state_.fabric.add(std::move(deal));
    for (auto i = gone.rbegin(); i != gone.rend(); ++i)
      live_.erase(live_.begin() + static_cast<std::ptrdiff_t>(*i));
    for (const knit::TubeId tube : to) {
      live_.push_back(tube);
      maybe_add_rows(tube);
    }
  }

  void split() {
    const std::size_t at = any_live();
    const knit::LiveStitches loop = state_.fabric.live(live_[at]);
    const int n = loop.size();
    if (n < 4) return;
    const int least = std::min(3, n / 2), arc = least + below(n - 2 * least + 1), first = below(n);
    const int stitches = std::max(3 - std::min(arc, n - arc), below(4));
    knit::Deal split;
    split.kind = knit::DealKind::split;
    split.from = {live_[at]};
    split.to = {next_, next_ + 1};
    next_ += 2;
    split.taken = {loop};
    split.bridge.resize(static_cast<std::size_t>(stitches));
    knit::LiveStitches one = stretch_of(loop, first, arc), two = stretch_of(loop, (first + arc) % n, n - arc);
    one.append(bridge(stitches, false));
    two.append(bridge(stitches, true));
    split.given = {turned(one), turned(two)};
    deal(std::move(split), {at});
  }

  void join() {
    if (live_.size() < 2) return;
    const std::size_t a = any_live(), b = any_live();
    if (a == b) return;
    knit::Deal join;
    join.kind = knit::DealKind::join;
    join.from = {live_[a], live_[b]};
    join.to = {next_++};
    const int stitches = 1 + below(3);
    join.bridge.resize(static_cast<std::size_t>(stitches));
    for (const knit::TubeId tube : join.from) join.taken.push_back(state_.fabric.live(tube));
    knit::LiveStitches all = turned(join.taken[0]);
    all.append(bridge(stitches, false));
    all.append(turned(join.taken[1]));
    all.append(bridge(stitches, true));
    join.given = {turned(all)};
    deal(std::move(join), {std::min(a, b), std::max(a, b)});
  }

  std::mt19937 random_;
  knit::State state_;
  knit::TubeId next_ = 0;
  std::vector<knit::TubeId> live_;
  std::set<knit::TubeId> begun_;
};

}  // namespace test_support
