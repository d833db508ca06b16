#include "knit/wales.h"

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
  explicit WaleFinder(const Rounds& rounds) : graph_(graph_of(rounds)), main_(main_stitches(rounds)) {}

  Wales find() {
    for (std::size_t row = 0; row < graph_.rows.size(); ++row) {
      std::vector<Wale> wales;
      Wale last = none;  // the last of those that the stitch before took in
      for (std::size_t i = 0; i < graph_.rows[row].size(); ++i) {
        const GraphStitch& stitch = graph_.rows[row][i];
        wales.push_back(stitch.count == 0 ? begun_after(last, stitch.hand, row) : kept(stitch, row, i));
        last = stitch.count == 2 ? below(stitch.first + 1) : wales.back();
      }
      found_.rows.push_back(std::move(wales));
    }
    return in_order();
  }

 private:
  [[nodiscard]] Wale below(std::int32_t stitch) const {
    return found_.rows.back()[static_cast<std::size_t>(stitch)];
  }

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
    if (main_[row][i] != 0) {
      const bool first = was_main(stitch.first, row - 1);
      const bool second = was_main(stitch.first + 1, row - 1);
      if (first != second) return below(first ? stitch.first : stitch.first + 1);
    }
    return below(stitch.hand == Hand::k2tog ? stitch.first + 1 : stitch.first);
  }
  [[nodiscard]] bool was_main(std::int32_t stitch, std::size_t row) const {
    return !main_[row].empty() && main_[row][static_cast<std::size_t>(stitch)] != 0;
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
  Wales found_;
  Wale first_ = none;
  std::vector<Wale> next_;
};

}  // namespace

Wales wales_of(const Rounds& rounds) { return WaleFinder(rounds).find(); }

}  // namespace knit
