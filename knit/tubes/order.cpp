#include <algorithm>
#include <compare>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "knit/mesh/ranking.h"
#include "knit/model/bug.h"
#include "knit/tubes/plan.h"

namespace knit {

namespace {

constexpr std::size_t most_states = 2000;  // a level

// A total order, though one that means nothing: sets that differ are told apart by a word.
class TubeSet {
 public:
  explicit TubeSet(std::size_t tubes) : words_(tubes / 64 + 1, 0) {}
  [[nodiscard]] bool has(TubeId id) const {
    const auto bit = static_cast<std::size_t>(id);
    return (words_[bit / 64] >> (bit % 64) & 1U) != 0;
  }
  void add(TubeId id) {
    const auto bit = static_cast<std::size_t>(id);
    words_[bit / 64] |= std::uint64_t{1} << (bit % 64);
    std::uint64_t mixed = (bit + 1) * 0x9e3779b97f4a7c15U;
    mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9U;
    mix_ += mixed ^ (mixed >> 27U);
  }
  [[nodiscard]] bool has_all(const std::vector<TubeId>& ids) const {
    return std::all_of(ids.begin(), ids.end(), [&](TubeId id) { return has(id); });
  }
  friend bool operator==(const TubeSet&, const TubeSet&) = default;
  friend bool operator<(const TubeSet& a, const TubeSet& b) {
    return std::tie(a.mix_, a.words_) < std::tie(b.mix_, b.words_);
  }

 private:
  std::uint64_t mix_ = 0;  // of the tubes added, each once
  std::vector<std::uint64_t> words_;
};

// After some tubes. States of a level stand in the order of their tubes so far, so that of two the one whose parent
// stands first, then the lower last tube, wins a tie.
struct OrderState {
  TubeSet done{0};
  TubeId last = -1;
  std::int32_t live = 0;  // loops of what is done that nothing stands on yet
  std::int32_t held_most = 0, yarns = 0, held_sum = 0;
  std::size_t parent = 0;  // in the level before
  [[nodiscard]] auto key() const { return std::tie(done, last); }
  [[nodiscard]] auto tubes_so_far() const { return std::tie(parent, last); }
  [[nodiscard]] auto cost() const { return std::tie(held_most, yarns, held_sum, parent, last); }
  [[nodiscard]] auto cost_but_held() const { return std::tie(yarns, held_sum, parent, last); }
};

using OrderLevel = std::vector<OrderState>;

// A rowless leaf of a ring is not searched for: it is an edge to cast on or to graft, and neither waits for a holder nor has
// a yarn. Both tubes above a ring cast on begin with a yarn of their own; the one that is worked later picks its stitches up.
class OrderSearch {
 public:
  OrderSearch(const std::vector<Tube>& tubes, const std::vector<TubeEvent>& events)
      : tubes_(tubes), events_(events), at_ring_(tubes.size(), 0) {
    for (const TubeEvent& event : events) {
      if (event.kind == EventKind::ring_cast_on) set_ring_leaf(event.below.front());
      if (event.kind == EventKind::ring_bind_off) set_ring_leaf(event.above.front());
    }
  }

  // Twice: how few holders do is settled by the first going, as of two ways to the same tubes the one that held fewer is
  // never worse. It may have taken more yarns, which counts again where more are held later in any case: so among the orders
  // that hold no more than that, the second looks at yarns and sums alone.
  TubeOrder run() {
    TubeOrder first = search();
    if (!exact_) return first;
    held_allowed_ = first.held_most;
    return search();
  }

 private:
  [[nodiscard]] TubeOrder search() {
    OrderState start;
    start.done = TubeSet(tubes_.size());
    std::size_t searched = 0;
    for (std::size_t i = 0; i < tubes_.size(); ++i) {
      if (at_ring_[i] == 0)
        ++searched;
      else if (kind_at(tubes_[i].top) == EventKind::ring_cast_on)
        start.done.add(static_cast<TubeId>(i));
    }
    std::vector<OrderLevel> levels{{start}};
    for (std::size_t i = 0; i < searched; ++i) levels.push_back(next_level(levels.back()));
    if (levels.back().empty()) throw Bug("tubes that stand on each other");
    return best_of(levels);
  }
  [[nodiscard]] bool is_better(const OrderState& a, const OrderState& b) const {
    return held_allowed_ ? a.cost_but_held() < b.cost_but_held() : a.cost() < b.cost();
  }
  [[nodiscard]] const TubeEvent& event(std::int32_t id) const {
    return events_[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] EventKind kind_at(std::int32_t id) const { return event(id).kind; }
  [[nodiscard]] const Tube& tube(TubeId id) const { return tubes_[static_cast<std::size_t>(id)]; }
  void set_ring_leaf(TubeId id) { at_ring_[static_cast<std::size_t>(id)] = 1; }

  // Live loops are dealt as soon as they can be: a split gives two, a join leaves one.
  [[nodiscard]] std::int32_t loops_left_by(const TubeEvent& top, const TubeSet& done) const {
    switch (top.kind) {
      case EventKind::bind_off:
        return 0;
      case EventKind::split:
        return 2;
      case EventKind::join:
        return done.has_all(top.below) ? 0 : 1;
      case EventKind::ring_bind_off:
        return done.has_all(top.below) ? -1 : 1;
      case EventKind::cast_on:
      case EventKind::ring_cast_on:
        break;
    }
    throw Bug("a tube that ends where tubes begin");
  }

  [[nodiscard]] OrderState worked(const OrderState& state, TubeId next, std::size_t parent) const {
    const TubeEvent& bottom = event(tube(next).bottom);
    const bool begins = bottom.kind == EventKind::cast_on || bottom.kind == EventKind::ring_cast_on;
    const bool goes_on =
        !begins && std::find(bottom.below.begin(), bottom.below.end(), state.last) != bottom.below.end();
    OrderState after = state;
    after.parent = parent;
    after.last = next;
    after.done.add(next);
    if (!begins) --after.live;
    after.held_most = std::max(after.held_most, after.live);
    after.held_sum += after.live;
    after.yarns += goes_on ? 0 : 1;
    after.live += loops_left_by(event(tube(next).top), after.done);
    return after;
  }

  OrderLevel next_level(const OrderLevel& level) {
    OrderLevel next;
    for (std::size_t i = 0; i < level.size(); ++i) {
      for (TubeId id = 0; id < static_cast<TubeId>(tubes_.size()); ++id) {
        if (at_ring_[static_cast<std::size_t>(id)] != 0 || level[i].done.has(id) ||
            !level[i].done.has_all(event(tube(id).bottom).below))
          continue;
        OrderState after = worked(level[i], id, i);
        if (!held_allowed_ || after.held_most <= *held_allowed_) next.push_back(std::move(after));
      }
    }
    // Of each set and last tube the best; of them the best.
    const auto by_cost = [&](const OrderState& a, const OrderState& b) { return is_better(a, b); };
    std::sort(next.begin(), next.end(), [&](const OrderState& a, const OrderState& b) {
      return a.key() != b.key() ? a.key() < b.key() : by_cost(a, b);
    });
    const auto same = [](const OrderState& a, const OrderState& b) { return a.key() == b.key(); };
    next.erase(std::unique(next.begin(), next.end(), same), next.end());
    if (next.size() > most_states) {
      exact_ = false;
      put_least_first(std::span(next), most_states, by_cost);
      next.resize(most_states, OrderState{});
    }
    std::sort(next.begin(), next.end(),
              [](const OrderState& a, const OrderState& b) { return a.tubes_so_far() < b.tubes_so_far(); });
    return next;
  }

  // With the leaves of rings right before the first and right after the last tube that they belong to.
  [[nodiscard]] TubeOrder best_of(const std::vector<OrderLevel>& levels) const {
    const OrderLevel& last = levels.back();
    const auto best = std::min_element(
        last.begin(), last.end(), [&](const OrderState& a, const OrderState& b) { return is_better(a, b); });
    TubeOrder order{{}, best->held_most, best->yarns, exact_};
    std::vector<TubeId> searched;
    const OrderState* state = &*best;
    for (std::size_t level = levels.size() - 1; level > 0; --level) {
      searched.push_back(state->last);
      state = &levels[level - 1][state->parent];
    }
    TubeSet done(tubes_.size());
    const auto list = [&](TubeId next) {
      if (done.has(next)) return;
      done.add(next);
      order.order.push_back(next);
    };
    std::reverse(searched.begin(), searched.end());
    for (const TubeId id : searched) {
      const TubeEvent& bottom = event(tube(id).bottom);
      const TubeEvent& top = event(tube(id).top);
      if (bottom.kind == EventKind::ring_cast_on) list(bottom.below.front());
      list(id);
      if (top.kind == EventKind::ring_bind_off && done.has_all(top.below)) list(top.above.front());
    }
    return order;
  }

  const std::vector<Tube>& tubes_;
  const std::vector<TubeEvent>& events_;
  std::vector<std::uint8_t> at_ring_;         // of each tube: a rowless leaf of a ring
  std::optional<std::int32_t> held_allowed_;  // none: whatever it takes
  bool exact_ = true;
};

}  // namespace

TubeOrder order_tubes(const std::vector<Tube>& tubes, const std::vector<TubeEvent>& events) {
  return OrderSearch(tubes, events).run();
}

namespace {

class RowlessPlacer {
 public:
  explicit RowlessPlacer(const TubePlan& plan) : plan_(plan), done_(plan.tubes.size()) {}

  std::vector<TubeId> run(const std::vector<TubeId>& worked) {
    for (const TubeId id : worked) {
      take_up(id);
      const TubeEvent& top = plan_.event(plan_.tube(id).top);
      if (top.kind == EventKind::ring_bind_off && done_.has_all(top.below)) take_up(top.above.front());
    }
    if (order_.size() != plan_.tubes.size()) throw Bug("an order leaves a tube out");
    return std::move(order_);
  }

 private:
  void take_up(TubeId id) {
    if (done_.has(id)) return;
    for (const TubeId below : plan_.event(plan_.tube(id).bottom).below) {
      if (!done_.has(below) && plan_.tube(below).rows() > 0) throw Bug("a tube before one it stands on");
      take_up(below);
    }
    done_.add(id);
    order_.push_back(id);
  }
  const TubePlan& plan_;
  TubeSet done_;
  std::vector<TubeId> order_;
};

}  // namespace

std::vector<TubeId> with_rowless(const TubePlan& plan, const std::vector<TubeId>& worked) {
  return RowlessPlacer(plan).run(worked);
}

TubePlan renumbered(const TubePlan& plan, TubeOrder order) {
  std::vector<TubeId> number(plan.tubes.size(), -1);
  TubeId next = 0;
  for (const bool with_rows : {true, false}) {
    for (const TubeId id : order.order) {
      if ((plan.tube(id).rows() > 0) == with_rows) number[static_cast<std::size_t>(id)] = next++;
    }
  }
  const auto renumber = [&](std::vector<TubeId>& ids) {
    for (TubeId& id : ids) id = number[static_cast<std::size_t>(id)];
  };
  TubePlan numbered = plan;
  for (std::size_t id = 0; id < plan.tubes.size(); ++id) {
    Tube& tube = numbered.tubes[static_cast<std::size_t>(number[id])];
    tube = plan.tubes[id];
    renumber(tube.twins);
    std::sort(tube.twins.begin(), tube.twins.end());
  }
  for (TubeEvent& event : numbered.events) {
    renumber(event.below);
    renumber(event.above);
  }
  renumber(order.order);
  numbered.order = std::move(order.order);
  numbered.held_most = order.held_most;
  numbered.yarns = order.yarns;
  numbered.order_is_exact = order.exact;
  return numbered;
}

}  // namespace knit
