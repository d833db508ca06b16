#include "knit/pattern/passes.h"

#include <algorithm>

#include "knit/model/bug.h"

namespace knit {

namespace {

constexpr std::int32_t shortest_row = 3;
constexpr std::int32_t kept_out = 2;  // so many stitches at least are not in a short row

std::size_t place(std::int32_t column, std::int32_t columns) {
  return static_cast<std::size_t>(column < 0 ? column + columns : column);
}

// Invariant: before a pass every column at or ahead of the needle has its short rows' stitches that are still due, and
// none of the round's own.
class PassMaker {
 public:
  explicit PassMaker(const Round& round)
      : round_(round), short_left_(static_cast<std::size_t>(round.before)), first_(short_left_.size() + 1) {
    for (const ShortRowPair& pair : round.pairs) {
      for (std::int32_t column = pair.first; column <= pair.last; ++column)
        short_left_[place(column, round.before)] += 2;
    }
    std::size_t column = 0;
    for (std::size_t i = 0; i < round.operations.size(); ++i) {
      for (std::int32_t taken = consumed_by(round.operations[i].hand); taken > 0; --taken)
        first_[column++] = i;
    }
    if (!first_.empty()) first_.front() = 0;  // increases before the first stitch too
    first_.back() = round.operations.size();
  }

  std::vector<Pass> run() {
    std::vector<ShortRowPair> over, within;
    for (const ShortRowPair& pair : round_.pairs) (pair.first < 0 ? over : within).push_back(pair);
    std::sort(over.begin(), over.end(), [](const ShortRowPair& a, const ShortRowPair& b) {
      return a.first != b.first ? a.first > b.first : a.last < b.last;
    });
    std::sort(within.begin(), within.end());
    for (const ShortRowPair& pair : over) there_and_back(pair);
    if (!over.empty()) forward(0, Pass::End::home);
    for (const ShortRowPair& pair : within) there_and_back(pair);
    forward(round_.before, Pass::End::round);
    return std::move(passes_);
  }

 private:
  void there_and_back(const ShortRowPair& pair) {
    forward(pair.last + 1, Pass::End::right_side);
    Pass pass{Pass::End::wrong_side, {}, change_};
    while (at_ > pair.first) pass.stitches.push_back(short_stitch(--at_));
    passes_.push_back(std::move(pass));
  }

  PassStitch short_stitch(std::int32_t column) {
    --short_left_[place(column, round_.before)];
    return {column, true, {}};
  }

  void forward(std::int32_t stop, Pass::End end) {
    Pass pass{end, {}, 0};
    while (at_ < stop) {
      if (short_left_[place(at_, round_.before)] > 0) {
        pass.stitches.push_back(short_stitch(at_++));
        continue;
      }
      work_column(pass);
    }
    pass.change = change_;
    passes_.push_back(std::move(pass));
  }

  // The round's own stitches of the column, and of the next where they are taken together.
  void work_column(Pass& pass) {
    const std::int32_t column = at_;
    std::size_t i = first_[place(column, round_.before)];
    do {
      const Operation& operation = round_.operations[i];
      pass.stitches.push_back({column, false, operation});
      at_ += consumed_by(operation.hand);
      change_ += made_by(operation.hand) - consumed_by(operation.hand);
      ++i;
    } while (at_ == column || i < first_[static_cast<std::size_t>(at_)]);
  }

  const Round& round_;
  std::vector<std::int32_t> short_left_;
  std::vector<std::size_t> first_;  // of each column, its first operation; behind them, how many there are
  std::int32_t at_ = 0, change_ = 0;
  std::vector<Pass> passes_;
};

}  // namespace

std::vector<bool> plain_columns(std::span<const Operation> operations) {
  std::vector<bool> plain;
  bool made = false;
  for (const Operation& operation : operations) {
    const std::int32_t taken = consumed_by(operation.hand);
    if (taken == 0 && !plain.empty()) plain.back() = false;
    for (std::int32_t i = 0; i < taken; ++i) plain.push_back(operation.hand == Hand::knit && !made);
    made = taken == 0;
  }
  if (made && !plain.empty()) plain.front() = false;
  if (!operations.empty() && consumed_by(operations.front().hand) == 0 && !plain.empty())
    plain.back() = false;
  return plain;
}

bool can_be_worked(const Round& round) {
  const std::vector<bool> plain = plain_columns(round.operations);
  const std::int32_t columns = round.before;
  if (static_cast<std::int32_t>(plain.size()) != columns) return round.pairs.empty();
  return std::all_of(round.pairs.begin(), round.pairs.end(), [&](const ShortRowPair& pair) {
    const std::int32_t stitches = pair.last - pair.first + 1;
    if (stitches < shortest_row || stitches > columns - kept_out) return false;
    const bool over = pair.first < 0 && pair.last >= 0;
    if (!over && (pair.first < 1 || pair.last > columns - 2)) return false;
    const auto is_plain = [&](std::int32_t column) { return bool{plain[place(column, columns)]}; };
    return is_plain(pair.first - 1) && is_plain(pair.first) && is_plain(pair.last) && is_plain(pair.last + 1);
  });
}

std::vector<Pass> passes_of(const Round& round) {
  if (!can_be_worked(round)) throw Bug("short rows that cannot be worked");
  return PassMaker(round).run();
}

}  // namespace knit
