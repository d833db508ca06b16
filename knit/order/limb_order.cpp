#include "knit/order/limb_order.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "knit/model/bug.h"

namespace knit {

namespace {

using Order = std::vector<std::int32_t>;

constexpr double clearly = 1e-9;
constexpr unsigned starts = 32;  // all ways at the first five choices

bool is_limb(const LimbPiece& piece) {
  return piece.deals.size() == 1 && piece.deals.front().kind == LimbDealKind::cast_on;
}

bool is_cast_on(const std::vector<LimbStep>& steps) {
  return steps.size() == 1 && steps.front().kind == LimbStepKind::cast_on;
}

// What an order costs wherever its rounds begin: each yarn that is moved, each line for it, each entry and slip adds to it.
double least_cost(const LimbTubes& tubes, const LimbRuns& runs) {
  const auto pieces = static_cast<std::int32_t>(runs.order.size());
  std::vector<std::int32_t> piece_of(static_cast<std::size_t>(tubes.count()), -1);
  for (std::int32_t i = 0; i < pieces; ++i)
    piece_of[static_cast<std::size_t>(runs.order[static_cast<std::size_t>(i)])] = i;
  std::int32_t apart = 0, lines = 0, yarns = 0;
  for (std::int32_t i = 0; i < pieces; ++i) {
    const std::int32_t tube = runs.order[static_cast<std::size_t>(i)];
    std::int32_t twins = 0, first = pieces, last = -1;
    bool follows_twin = false;
    for (const std::int32_t twin : tubes.tube(tube).twins) {
      const std::int32_t other = piece_of[static_cast<std::size_t>(twin)];
      if (other < 0) continue;
      ++twins;
      first = std::min(first, other);
      last = std::max(last, other);
      follows_twin = follows_twin || other == i - 1;
    }
    if (twins > 1 && first == i) apart += last - i - twins + 1;
    const auto& steps = runs.steps[static_cast<std::size_t>(i)];
    const bool together =
        follows_twin && is_cast_on(steps) && is_cast_on(runs.steps[static_cast<std::size_t>(i) - 1]);
    lines += static_cast<std::int32_t>(steps.size()) + (together ? 0 : 3);
    yarns += static_cast<std::int32_t>(std::count_if(
        steps.begin(), steps.end(), [](const LimbStep& step) { return begins_yarn(step.kind); }));
  }
  return 4.0 * runs.held_most + 10.0 * yarns + 2.0 * apart + 0.3 * lines;
}

double cost_of(const LimbTubes& tubes, const LimbRuns& runs, const LimbMarkers& markers,
               const LimbLayout& layout) {
  return least_cost(tubes, runs) + (10.0 + 0.3) * markers.moves + 1.5 * layout.offsets + markers.slips;
}

std::optional<OrderedLimbs> with_markers(const LimbTubes& tubes, LimbRuns runs) {
  std::optional<LimbMarkers> markers = markers_of(tubes, runs);
  if (!markers) return std::nullopt;
  std::optional<LimbLayout> layout = lay_out(tubes, runs, *markers);
  if (!layout) return std::nullopt;
  const double cost = cost_of(tubes, runs, *markers, *layout);
  return OrderedLimbs{std::move(runs), std::move(*markers), std::move(*layout), cost, 1};
}

class OrderSearch {
 public:
  explicit OrderSearch(const LimbTubes& tubes) : tubes_(tubes), own_(order_of_rows(tubes)) {
    std::int32_t stitches = 1;
    for (std::int32_t i = 0; i < tubes.count(); ++i)
      stitches += static_cast<std::int32_t>(tubes.tube(i).base.size());
    most_orders_ = std::clamp(1000000 / stitches, 60, 1500);
  }

  OrderedLimbs run() {
    climb(own_);
    for (unsigned choices = 0; choices < starts && tried_ < most_orders_; ++choices)
      climb(yarn_first(choices));
    if (!best_) throw Bug("the fabric's own order cannot be worked");
    for (int round = 0; round < 3 && put_joined_in_order(); ++round) {
    }
    best_->tried = tried_;
    return std::move(*best_);
  }

 private:
  // What it costs, if it is new, can be worked and may cost no more than this; the best is kept.
  std::optional<double> try_order(const Order& order, double at_most, bool equal_will_do = false) {
    if (!seen_.insert(order).second) return std::nullopt;
    ++tried_;
    std::optional<LimbRuns> runs = runs_of(tubes_, order);
    if (!runs || least_cost(tubes_, *runs) > at_most + clearly) return std::nullopt;
    std::optional<OrderedLimbs> found = with_markers(tubes_, std::move(*runs));
    if (!found) return std::nullopt;
    const double cost = found->cost;
    const double most = best_ ? best_->cost + (equal_will_do ? clearly : -clearly) : cost;
    if (cost <= most) best_ = std::move(found);
    return cost;
  }

  // Goes on where the last piece leads, if it can; else with a piece that can be worked. Of several the first or the second:
  // one bit of `choices` each time, so that children of a fork are swapped.
  [[nodiscard]] Order yarn_first(unsigned choices) const {
    Order order, left = own_;
    std::set<std::int32_t> done;
    while (!left.empty()) {
      Order can, goes_on;
      for (const std::int32_t tube : left) {
        const Order below = tubes_below(tubes_, tube);
        if (!std::all_of(below.begin(), below.end(), [&](std::int32_t b) { return done.count(b) > 0; }))
          continue;
        can.push_back(tube);
        const bool follows =
            !order.empty() && std::find(below.begin(), below.end(), order.back()) != below.end();
        if (follows) goes_on.push_back(tube);
      }
      const Order& from = goes_on.empty() ? can : goes_on;
      if (from.empty()) throw Bug("tubes that stand on each other");
      std::size_t at = 0;
      if (from.size() > 1) {
        at = choices & 1U;
        choices >>= 1U;
      }
      order.push_back(from[at]);
      done.insert(from[at]);
      left.erase(std::find(left.begin(), left.end(), from[at]));
    }
    return order;
  }

  void climb(Order order) {
    std::optional<double> cost = try_order(order, std::numeric_limits<double>::infinity());
    while (cost) cost = improve(order, *cost);
  }

  // Blocks, the shortest first; the order is changed for the first that costs less.
  std::optional<double> improve(Order& order, double cost) {
    const std::size_t n = order.size();
    for (std::size_t length = 1; length < n; ++length) {
      for (std::size_t first = 0; first + length <= n; ++first) {
        for (std::size_t to = 0; to + length <= n; ++to) {
          if (tried_ >= most_orders_) return std::nullopt;
          if (to == first) continue;
          Order moved = order;
          const auto begin = moved.begin() + static_cast<std::ptrdiff_t>(first);
          const Order block(begin, begin + static_cast<std::ptrdiff_t>(length));
          moved.erase(begin, begin + static_cast<std::ptrdiff_t>(length));
          moved.insert(moved.begin() + static_cast<std::ptrdiff_t>(to), block.begin(), block.end());
          const std::optional<double> changed = stands(moved) ? try_order(moved, cost) : std::nullopt;
          if (!changed || *changed > cost - clearly) continue;
          order = std::move(moved);
          return changed;
        }
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] bool stands(const Order& order) const {
    std::set<std::int32_t> done;
    for (const std::int32_t tube : order) {
      for (const std::int32_t below : tubes_below(tubes_, tube)) {
        if (done.count(below) == 0) return false;
      }
      done.insert(tube);
    }
    return true;
  }

  // Limbs that are cast on and taken by one join stand as it takes them; twins of the one that brings the yarn stay with it.
  bool put_joined_in_order() {
    const OrderedLimbs now = *best_;
    for (const LimbPiece& piece : now.layout.plan.pieces) {
      if (piece.deals.back().kind != LimbDealKind::join) continue;
      const std::int32_t yarn =
          now.runs.steps[static_cast<std::size_t>(&piece - now.layout.plan.pieces.data())].back().other;
      Order feet;  // pieces
      for (const LimbItem& item : piece.deals.back().items) {
        const bool fits = item.kind == LimbItemKind::take && is_limb(now.layout.plan.piece(item.piece));
        if (fits && std::find(feet.begin(), feet.end(), item.piece) == feet.end()) feet.push_back(item.piece);
      }
      if (feet.size() < 2) continue;
      const std::optional<double> cost = try_order(with_feet(now, feet, yarn), now.cost, true);
      if (cost && *cost <= now.cost + clearly) return true;
    }
    return false;
  }
  [[nodiscard]] Order with_feet(const OrderedLimbs& now, const Order& feet, std::int32_t yarn) const {
    const Order& order = now.runs.order;
    Order places = feet, wanted;
    std::sort(places.begin(), places.end());
    for (const bool last : {false, true}) {
      for (const std::int32_t foot : feet) {
        const Order& twins = tubes_.tube(order[static_cast<std::size_t>(foot)]).twins;
        const bool of_yarn = twins.size() > 1 && std::find(twins.begin(), twins.end(), yarn) != twins.end();
        if (of_yarn == last) wanted.push_back(order[static_cast<std::size_t>(foot)]);
      }
    }
    Order moved = order;
    for (std::size_t i = 0; i < places.size(); ++i) moved[static_cast<std::size_t>(places[i])] = wanted[i];
    return moved;
  }

  const LimbTubes& tubes_;
  Order own_;
  std::set<Order> seen_;
  std::optional<OrderedLimbs> best_;
  std::int32_t tried_ = 0, most_orders_ = 0;
};

}  // namespace

std::optional<OrderedLimbs> in_order(const LimbTubes& tubes, const std::vector<std::int32_t>& order) {
  std::optional<LimbRuns> runs = runs_of(tubes, order);
  return runs ? with_markers(tubes, std::move(*runs)) : std::nullopt;
}

std::vector<std::int32_t> order_of_rows(const LimbTubes& tubes) {
  std::vector<std::int32_t> order;
  for (std::int32_t i = 0; i < tubes.count(); ++i) {
    if (tubes.tube(i).has_rows()) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return tubes.tube(a).rows.front() < tubes.tube(b).rows.front();
  });
  return order;
}

OrderedLimbs cheapest_order(const LimbTubes& tubes) { return OrderSearch(tubes).run(); }

}  // namespace knit
