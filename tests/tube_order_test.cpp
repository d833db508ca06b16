// In which order tubes are worked: random events of up to 17 tubes, against all orders there are.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "knit/tubes/plan.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"
#include "tests/support/rough_sphere.h"

using namespace knit;
using test_support::Dice;

namespace {

constexpr std::size_t most_tubes = 17;

// Events put together at random, as an order sees them: which tubes end at each, which begin, and which of them are only the
// edge of a ring.
struct Events {
  std::vector<Tube> tubes;
  std::vector<TubeEvent> events;
  [[nodiscard]] const TubeEvent& bottom_of(std::size_t tube) const {
    return events[static_cast<std::size_t>(tubes[tube].bottom)];
  }
  [[nodiscard]] const TubeEvent& top_of(std::size_t tube) const {
    return events[static_cast<std::size_t>(tubes[tube].top)];
  }
};

class EventMaker {
 public:
  explicit EventMaker(Dice& dice) : dice_(dice) {}

  // Of at most 17 tubes, the rowless leaves of rings among them.
  Events make(bool rings) {
    const std::size_t wanted = 1 + dice_.below(most_tubes);
    begin(EventKind::cast_on, {}, 1);
    while (made_.tubes.size() < wanted) step(rings ? 5 : 3);
    while (!open_.empty()) begin(EventKind::bind_off, {take()}, 0);
    return std::move(made_);
  }

 private:
  void step(std::size_t choices) {
    const std::size_t room = most_tubes - made_.tubes.size();
    switch (dice_.below(choices)) {
      case 0:
        return begin(EventKind::cast_on, {}, 1);
      case 1:
        if (!open_.empty() && room >= 2) return begin(EventKind::split, {take()}, 2);
        return begin(EventKind::cast_on, {}, 1);
      case 2:
        if (open_.size() >= 2) return begin(EventKind::join, {take(), take()}, 1);
        return begin(EventKind::cast_on, {}, 1);
      case 3:
        if (room < 3) return begin(EventKind::cast_on, {}, 1);
        begin(EventKind::cast_on, {}, 1);
        return begin(EventKind::ring_cast_on, {take_last()}, 2);
      default:
        if (open_.size() < 2) return begin(EventKind::cast_on, {}, 1);
        begin(EventKind::ring_bind_off, {take(), take()}, 1);
        return begin(EventKind::bind_off, {take_last()}, 0);
    }
  }
  TubeId take() {
    std::swap(open_[dice_.below(open_.size())], open_.back());
    return take_last();
  }
  TubeId take_last() {
    const TubeId id = open_.back();
    open_.pop_back();
    return id;
  }
  void begin(EventKind kind, std::vector<TubeId> below, int above) {
    TubeEvent event;
    event.kind = kind;
    std::sort(below.begin(), below.end());
    const auto id = static_cast<std::int32_t>(made_.events.size());
    for (const TubeId tube : below) made_.tubes[static_cast<std::size_t>(tube)].top = id;
    event.below = std::move(below);
    for (int i = 0; i < above; ++i) {
      open_.push_back(static_cast<TubeId>(made_.tubes.size()));
      event.above.push_back(open_.back());
      made_.tubes.emplace_back();
      made_.tubes.back().bottom = id;
    }
    made_.events.push_back(std::move(event));
  }

  Dice& dice_;
  Events made_;
  std::vector<TubeId> open_;
};

std::int32_t count_of(const Events& all, EventKind kind) {
  return static_cast<std::int32_t>(std::count_if(all.events.begin(), all.events.end(),
                                                 [&](const TubeEvent& e) { return e.kind == kind; }));
}

// Below a ring cast on is a leaf that is cast on: with it, it counts as two.
std::int32_t cast_ons_and_splits(const Events& all) {
  return count_of(all, EventKind::cast_on) + count_of(all, EventKind::split) +
         count_of(all, EventKind::ring_cast_on);
}

// What an order takes.
struct Taken {
  std::int32_t held_most = 0, yarns = 0, held_sum = 0;
  friend auto operator<=>(const Taken&, const Taken&) = default;
};

using TubeBits = std::uint32_t;
constexpr TubeBits bit(std::size_t tube) { return TubeBits{1} << tube; }
TubeBits bits_of(const std::vector<TubeId>& tubes) {
  TubeBits bits = 0;
  for (const TubeId id : tubes) bits |= bit(static_cast<std::size_t>(id));
  return bits;
}

// Going through tubes with the loops in hand, said once more and otherwise than the program does: from the set of tubes that
// are done alone.
class Hands {
 public:
  explicit Hands(const Events& all) : all_(all) {
    for (const TubeEvent& event : all.events) {
      below_.push_back(bits_of(event.below));
      above_.push_back(bits_of(event.above));
      if (event.kind == EventKind::ring_cast_on) edges_ |= below_.back();
      if (event.kind == EventKind::ring_bind_off) edges_ |= above_.back();
    }
    for (std::size_t i = 0; i < all.tubes.size(); ++i) whole_ |= bit(i);
    whole_ &= ~edges_;
  }
  // Tubes to be worked: an edge that is cast on or grafted takes no turn.
  [[nodiscard]] TubeBits whole() const { return whole_; }
  [[nodiscard]] bool is_ready(std::size_t tube, TubeBits done) const {
    const TubeBits feet = feet_of(tube);
    return (bit(tube) & whole_ & ~done) != 0 && (feet & ~done) == 0;
  }
  [[nodiscard]] bool goes_on(std::size_t tube, std::size_t last) const {
    return (feet_of(tube) & bit(last)) != 0;
  }
  // Loops that wait while a tube is worked: of each event what comes out and is not taken up, or else what has gone in.
  [[nodiscard]] std::int32_t held_beside(std::size_t tube, TubeBits done) const {
    TubeBits held = 0;
    for (std::size_t i = 0; i < below_.size(); ++i) {
      if (all_.events[i].kind == EventKind::ring_cast_on || below_[i] == 0) continue;
      const bool met = (below_[i] & ~done) == 0;
      if (!met) held |= below_[i] & done;
      if (met) held |= above_[i] & whole_ & ~done & ~bit(tube);
    }
    std::int32_t count = 0;
    for (; held != 0; held &= held - 1) ++count;
    return count;
  }

 private:
  [[nodiscard]] TubeBits feet_of(std::size_t tube) const {
    return below_[static_cast<std::size_t>(all_.tubes[tube].bottom)] & ~edges_;
  }
  const Events& all_;
  std::vector<TubeBits> below_, above_;
  TubeBits edges_ = 0, whole_ = 0;
};

Taken work_through(const Hands& hands, const std::vector<TubeId>& order) {
  Taken taken;
  TubeBits done = 0;
  std::size_t last = most_tubes;
  for (const TubeId id : order) {
    const auto tube = static_cast<std::size_t>(id);
    if ((hands.whole() & bit(tube)) == 0) continue;
    const std::int32_t held = hands.held_beside(tube, done);
    taken.held_most = std::max(taken.held_most, held);
    taken.held_sum += held;
    taken.yarns += last < most_tubes && hands.goes_on(tube, last) ? 0 : 1;
    done |= bit(tube);
    last = tube;
  }
  return taken;
}

// Of all orders there are the least: first how few holders do, over all sets of tubes that can be done; then, with no more
// than these, the fewest yarns, and the least sum of holders among them, over all sets and last tubes.
class AllOrders {
 public:
  explicit AllOrders(const Events& all) : hands_(all), tubes_(all.tubes.size()) {}

  Taken best() {
    std::map<TubeBits, std::int32_t> most{{0, 0}};
    each_set(most, [&](TubeBits done, std::int32_t held, std::size_t tube) {
      const std::int32_t now = std::max(held, hands_.held_beside(tube, done));
      const auto [at, is_new] = most.try_emplace(done | bit(tube), now);
      if (!is_new) at->second = std::min(at->second, now);
    });
    const std::int32_t fewest = most.at(hands_.whole());
    using Last = std::map<std::size_t, Taken>;
    std::map<TubeBits, Last> least{{0, {{most_tubes, {fewest, 0, 0}}}}};
    each_set(least, [&](TubeBits done, const Last& lasts, std::size_t tube) {
      const std::int32_t held = hands_.held_beside(tube, done);
      if (held > fewest) return;
      for (const auto& [last, taken] : lasts) {
        const bool goes_on = last < most_tubes && hands_.goes_on(tube, last);
        const Taken now{fewest, taken.yarns + (goes_on ? 0 : 1), taken.held_sum + held};
        const auto [at, is_new] = least[done | bit(tube)].try_emplace(tube, now);
        if (!is_new) at->second = std::min(at->second, now);
      }
    });
    Taken best{fewest, std::numeric_limits<std::int32_t>::max(), 0};
    for (const auto& [last, taken] : least.at(hands_.whole())) best = std::min(best, taken);
    return best;
  }

 private:
  // Sets rise as numbers where tubes are added, so each is met after all that lead to it.
  template <class Sets, class See>
  void each_set(Sets& sets, See see) const {
    for (auto at = sets.begin(); at != sets.end(); ++at) {
      for (std::size_t tube = 0; tube < tubes_; ++tube) {
        if (hands_.is_ready(tube, at->first)) see(at->first, at->second, tube);
      }
    }
  }
  Hands hands_;
  std::size_t tubes_;
};

// Each tube once, after those that it stands on.
bool is_order(const Events& all, const std::vector<TubeId>& order) {
  TubeBits done = 0;
  for (const TubeId id : order) {
    const auto tube = static_cast<std::size_t>(id);
    if ((done & bit(tube)) != 0 || (bits_of(all.bottom_of(tube).below) & ~done) != 0) return false;
    done |= bit(tube);
  }
  return order.size() == all.tubes.size();
}

// Any of the orders that go on with the yarn in hand where they can.
std::vector<TubeId> any_order_that_goes_on(const Events& all, Dice& dice) {
  const Hands hands(all);
  std::vector<TubeId> order;
  TubeBits done = 0;
  while (done != hands.whole()) {
    std::vector<std::size_t> ready, on;
    for (std::size_t tube = 0; tube < all.tubes.size(); ++tube) {
      if (!hands.is_ready(tube, done)) continue;
      ready.push_back(tube);
      if (!order.empty() && hands.goes_on(tube, static_cast<std::size_t>(order.back()))) on.push_back(tube);
    }
    const std::vector<std::size_t>& from = on.empty() ? ready : on;
    const std::size_t next = from[dice.below(from.size())];
    order.push_back(static_cast<TubeId>(next));
    done |= bit(next);
  }
  return order;
}

// Whether all orders were looked at, which is said: else only yarns are promised.
bool check_order(const Events& all) {
  const TubeOrder order = order_tubes(all.tubes, all.events);
  REQUIRE(is_order(all, order.order));
  const Taken taken = work_through(Hands(all), order.order);
  CHECK(order.held_most == taken.held_most);
  CHECK(order.yarns == taken.yarns);
  CHECK(order.yarns == cast_ons_and_splits(all));
  if (order.exact) CHECK(taken == AllOrders(all).best());
  return order.exact;
}

}  // namespace

TEST_CASE("tube order: of all orders of up to 17 tubes none has fewer holders, nor fewer yarns",
          "[tube-order]") {
  Dice dice(17);
  std::array<std::int32_t, 6> met{};
  std::size_t largest = 0;
  int exact = 0;
  for (int run = 0; run < test_support::repeated(300); ++run) {
    CAPTURE(run);
    const Events all = EventMaker(dice).make(run % 2 == 1);
    exact += check_order(all) ? 1 : 0;
    for (const TubeEvent& event : all.events) ++met.at(static_cast<std::size_t>(event.kind));
    largest = std::max(largest, all.tubes.size());
  }
  if (!test_support::whole()) return;
  CHECK(largest == most_tubes);
  CHECK(exact > 250);
  CHECK(*std::min_element(met.begin(), met.end()) > 50);
}

TEST_CASE("tube order: every order that goes on with its yarn has as few yarns", "[tube-order]") {
  Dice dice(18);
  for (int run = 0; run < test_support::repeated(400); ++run) {
    CAPTURE(run);
    const Events all = EventMaker(dice).make(run % 2 == 1);
    const Taken taken = work_through(Hands(all), any_order_that_goes_on(all, dice));
    CHECK(taken.yarns == cast_ons_and_splits(all));
  }
}

TEST_CASE("tube order: what is worked out does not hang on how tubes are numbered", "[tube-order]") {
  Dice dice(19);
  for (int run = 0; run < test_support::repeated(100); ++run) {
    CAPTURE(run);
    const Events all = EventMaker(dice).make(run % 2 == 1);
    std::vector<std::size_t> number(all.tubes.size());
    for (std::size_t i = 0; i < number.size(); ++i) number[i] = i;
    for (std::size_t i = number.size(); i > 1; --i) std::swap(number[i - 1], number[dice.below(i)]);
    Events other = all;
    for (std::size_t i = 0; i < number.size(); ++i) other.tubes[number[i]] = all.tubes[i];
    for (TubeEvent& event : other.events) {
      for (TubeId& id : event.below) id = static_cast<TubeId>(number[static_cast<std::size_t>(id)]);
      for (TubeId& id : event.above) id = static_cast<TubeId>(number[static_cast<std::size_t>(id)]);
    }
    const TubeOrder one = order_tubes(all.tubes, all.events), two = order_tubes(other.tubes, other.events);
    CHECK(one.yarns == two.yarns);
    if (!one.exact || !two.exact) continue;
    CHECK(one.held_most == two.held_most);
    CHECK(work_through(Hands(all), one.order) == work_through(Hands(other), two.order));
  }
}
