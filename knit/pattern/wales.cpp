#include "knit/pattern/wales.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace knit {

namespace {

constexpr Wale none = -1;

std::vector<std::vector<std::uint8_t>> main_stitches(const Rounds& rounds) {
  std::vector<std::vector<std::uint8_t>> main{std::vector<std::uint8_t>()};
  for (const Round& round : rounds.rounds) {
    std::vector<std::uint8_t>& row = main.emplace_back();
    for (const Operation& operation : round.operations) row.push_back(operation.at_main ? 1 : 0);
  }
  return main;
}

// Numbers wales as they come, and keeps their order as a chain into which new ones are put.
class WaleFinder {
 public:
  WaleFinder(const Rounds& rounds, const std::vector<std::uint8_t>& slips_back)
      : graph_(graph_of(rounds)), main_(main_stitches(rounds)), slips_back_(slips_back) {}

  Wales find() {
    auto slips = slips_back_.begin();  // from the round after the cast on
    for (std::size_t row = 0; row < graph_.rows.size(); ++row) {
      std::vector<Wale> wales;
      slips_ = row > 0 && slips != slips_back_.end() && *slips++ != 0;
      Wale last = none;  // the last of those that the stitch before took in
      for (std::size_t i = 0; i < graph_.rows[row].size(); ++i) {
        const GraphStitch& stitch = graph_.rows[row][i];
        const bool begins = stitch.count == 0 || (is_slipped(stitch.first) && stitch.count == 1);
        wales.push_back(begins ? begun_after(last, stitch.hand, row) : kept(stitch, row, i));
        last = stitch.count == 2 ? below(stitch.first + 1) : wales.back();
      }
      found_.rows.push_back(std::move(wales));
      main_below_ = main_[row];
    }
    return in_order();
  }

 private:
  [[nodiscard]] bool is_slipped(std::int32_t stitch) const { return slips_ && stitch == 0; }
  // Where a stitch of the row below stood before the last one was slipped back.
  [[nodiscard]] std::size_t place_below(std::int32_t stitch) const {
    if (is_slipped(stitch)) return found_.rows.back().size() - 1;
    return static_cast<std::size_t>(stitch) - (slips_ ? 1 : 0);
  }
  [[nodiscard]] Wale below(std::int32_t stitch) const { return found_.rows.back()[place_below(stitch)]; }

  Wale begun_after(Wale before, Hand hand, std::size_t row) {
    const auto wale = static_cast<Wale>(next_.size());
    found_.begins.push_back(static_cast<std::int32_t>(row));
    found_.hand.push_back(hand);
    Wale& link = before == none ? first_ : next_[static_cast<std::size_t>(before)];
    const Wale after = link;
    link = wale;
    next_.push_back(after);
    return wale;
  }

  [[nodiscard]] Wale kept(const GraphStitch& stitch, std::size_t row, std::size_t i) const {
    if (stitch.count == 1) return below(stitch.first);
    if (is_slipped(stitch.first)) return below(stitch.first + 1);
    if (main_[row][i] != 0) {
      const bool first = was_main_below(stitch.first);
      const bool second = was_main_below(stitch.first + 1);
      if (first != second) return below(first ? stitch.first : stitch.first + 1);
    }
    return below(stitch.hand == Hand::k2tog ? stitch.first + 1 : stitch.first);
  }
  [[nodiscard]] bool was_main_below(std::int32_t stitch) const {
    return !main_below_.empty() && main_below_[place_below(stitch)] != 0;
  }

  [[nodiscard]] Wales in_order() const {
    Wales sorted;
    std::vector<Wale> number(next_.size());
    for (Wale wale = first_; wale != none; wale = next_[static_cast<std::size_t>(wale)]) {
      number[static_cast<std::size_t>(wale)] = static_cast<Wale>(sorted.hand.size());
      sorted.hand.push_back(found_.hand[static_cast<std::size_t>(wale)]);
      sorted.begins.push_back(found_.begins[static_cast<std::size_t>(wale)]);
    }
    sorted.rows = found_.rows;
    for (std::vector<Wale>& row : sorted.rows) {
      for (Wale& wale : row) wale = number[static_cast<std::size_t>(wale)];
    }
    return sorted;
  }

  KnitGraph graph_;
  std::vector<std::vector<std::uint8_t>> main_;  // per stitch; nothing is known of the cast on
  std::vector<std::uint8_t> main_below_;         // of the row that the next one is worked on
  const std::vector<std::uint8_t>& slips_back_;
  bool slips_ = false;  // in the row at hand
  Wales found_;
  Wale first_ = none;
  std::vector<Wale> next_;
};

}  // namespace

Wales wales_of(const Rounds& rounds, const std::vector<std::uint8_t>& slips_back) {
  return WaleFinder(rounds, slips_back).find();
}

namespace {

// What ever stood next to what, in a row or with the row below: a wale that a round begins does not stand on
// one that the same round ends.
struct Neighbours {
  std::vector<std::vector<Wale>> before, after;  // per wale
};

Neighbours neighbours_of(const Wales& wales) {
  std::vector<std::pair<Wale, Wale>> pairs;
  const std::vector<Wale>* below = &wales.rows.front();
  for (const std::vector<Wale>& here : wales.rows) {
    std::vector<Wale> both;
    std::set_union(here.begin(), here.end(), below->begin(), below->end(), std::back_inserter(both));
    below = &here;
    for (std::size_t i = 0; i + 1 < both.size(); ++i) pairs.emplace_back(both[i], both[i + 1]);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Neighbours all;
  all.before.resize(wales.begins.size());
  all.after.resize(wales.begins.size());
  for (const auto& [first, second] : pairs) {
    all.after[static_cast<std::size_t>(first)].push_back(second);
    all.before[static_cast<std::size_t>(second)].push_back(first);
  }
  return all;
}

// The width is the number of wales in the longest chain of neighbours, through all rows. Each wale has a
// range of columns left, `low` to `high`; whatever it takes of its range leaves every other wale one.
class ColumnRanges {
 public:
  explicit ColumnRanges(const Wales& wales)
      : next_to_(neighbours_of(wales)), low_(wales.begins.size(), 0), high_(wales.begins.size()) {
    std::set<Wale> all;
    for (std::size_t w = 0; w < low_.size(); ++w) all.insert(all.end(), static_cast<Wale>(w));
    raise_after(all);
    width_ = 1 + *std::max_element(low_.begin(), low_.end());
    std::fill(high_.begin(), high_.end(), width_ - 1);
    lower_before(all);
  }

  [[nodiscard]] std::int32_t width() const { return width_; }
  [[nodiscard]] std::int32_t low(Wale wale) const { return low_[static_cast<std::size_t>(wale)]; }
  [[nodiscard]] std::int32_t high(Wale wale) const { return high_[static_cast<std::size_t>(wale)]; }

  void fix(Wale wale, std::int32_t column) {
    const auto w = static_cast<std::size_t>(wale);
    low_[w] = high_[w] = column;
    raise_after({wale});
    lower_before({wale});
  }

 private:
  // In the order of wales, so that each is looked at once.
  void raise_after(std::set<Wale> changed) {
    while (!changed.empty()) {
      const Wale wale = changed.extract(changed.begin()).value();
      const std::int32_t least = low(wale) + 1;
      for (const Wale after : next_to_.after[static_cast<std::size_t>(wale)]) {
        std::int32_t& low = low_[static_cast<std::size_t>(after)];
        if (low >= least) continue;
        low = least;
        changed.insert(after);
      }
    }
  }
  void lower_before(std::set<Wale> changed) {
    while (!changed.empty()) {
      const Wale wale = changed.extract(std::prev(changed.end())).value();
      const std::int32_t most = high(wale) - 1;
      for (const Wale before : next_to_.before[static_cast<std::size_t>(wale)]) {
        std::int32_t& high = high_[static_cast<std::size_t>(before)];
        if (high <= most) continue;
        high = most;
        changed.insert(before);
      }
    }
  }

  Neighbours next_to_;
  std::vector<std::int32_t> low_, high_;
  std::int32_t width_ = 0;
};

// A wale that is cast on stands in the middle of its range; one that is made, beside the stitch that it is
// made next to: the one before for m1r, the one after for m1l.
std::int32_t wish_of(Hand begins, std::int32_t low, std::int32_t high) {
  if (begins == Hand::m1r) return low;
  return begins == Hand::m1l ? high : (low + high) / 2;
}

}  // namespace

WaleColumns columns_of(const Wales& wales) {
  ColumnRanges ranges(wales);
  WaleColumns columns{std::vector<std::int32_t>(wales.begins.size()), ranges.width()};
  for (std::size_t row = 0; row < wales.rows.size(); ++row) {
    for (const Wale wale : wales.rows[row]) {
      const auto w = static_cast<std::size_t>(wale);
      if (wales.begins[w] != static_cast<std::int32_t>(row)) continue;
      columns.of[w] = wish_of(wales.hand[w], ranges.low(wale), ranges.high(wale));
      ranges.fix(wale, columns.of[w]);
    }
  }
  return columns;
}

}  // namespace knit
