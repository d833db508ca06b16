#include "knit/pattern/fold.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>

namespace knit {

namespace {

// A repeat takes in at most so many runs of the round: what is longer no one keeps in mind.
constexpr std::size_t longest_period = 16;

std::vector<Run> runs_of(std::span<const Operation> operations, const FoldOptions& options) {
  std::vector<Run> runs;
  for (const Operation& operation : operations) {
    const bool marker = options.markers && operation.at_main;
    if (operation.hand == Hand::knit && !runs.empty() && runs.back().hand == Hand::knit && !marker)
      ++runs.back().count;
    else
      runs.push_back({operation.hand, 1, marker});
  }
  return runs;
}

std::int32_t words_in(const Run& run) { return run.marker ? 2 : 1; }

// In a round's runs: run `run` of which `taken` stitches are written already.
struct Spot {
  std::size_t run = 0;
  std::int32_t taken = 0;
  friend bool operator==(const Spot&, const Spot&) = default;
};

// What is written from one spot to the next: the rest of a run (times 0), or `lead` knit stitches of it and a
// repeat over `period` runs. A repeat that begins in a knit run has `head` stitches of it, and as many of the
// next such run as its `tail` says go to its end: head + tail is the run where two rounds of the repeat meet.
// In a round with markers no run is cut: the knitter goes from marker to marker.
struct Move {
  Spot from;
  std::int32_t lead = 0, head = 0, tail = 0;
  std::size_t period = 0, times = 0;
};

struct Cost {
  std::int32_t words = 0, repeats = 0;
  std::int64_t starts = 0;  // of the repeats, in stitches worked before them
  friend auto operator<=>(const Cost&, const Cost&) = default;
};

// The shortest way from the first spot to the last, over all ways to go on from each.
class Folder {
 public:
  explicit Folder(std::vector<Run> runs)
      : runs_(std::move(runs)),
        has_markers_(std::any_of(runs_.begin(), runs_.end(), [](const Run& run) { return run.marker; })) {
    for (const Run& run : runs_) worked_.push_back(worked_.back() + run.count);
    for (std::size_t period = 1; period <= longest_period; ++period) count_same(period);
  }

  std::vector<Phrase> phrases() {
    found_.resize(runs_.size() + 1);
    found_.front().emplace(0, Found{});
    // Moves lead to later runs only, so that a spot is settled when its turn comes.
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      for (const auto& [taken, found] : found_[run]) {
        cost_here_ = found.cost;
        move_from({run, taken});
      }
    }
    return written_up_to({runs_.size(), 0});
  }

 private:
  struct Found {
    Cost cost;
    Move move;
  };

  [[nodiscard]] bool is_knit(std::size_t run) const {
    return run < runs_.size() && runs_[run].hand == Hand::knit;
  }
  [[nodiscard]] bool may_be_cut(std::size_t run) const { return is_knit(run) && !has_markers_; }

  // From each run on, how many equal the run one period later.
  void count_same(std::size_t period) {
    std::vector<std::size_t> same(runs_.size() + 1, 0);
    for (std::size_t run = runs_.size(); run-- > 0;) {
      const bool equal = run + period < runs_.size() && runs_[run] == runs_[run + period];
      same[run] = equal ? same[run + 1] + 1 : 0;
    }
    same_.push_back(std::move(same));
  }
  [[nodiscard]] std::size_t same_from(std::size_t run, std::size_t period) const {
    return same_[period - 1][run];
  }

  void move_from(Spot from) {
    const Run& run = runs_[from.run];
    offer({from.run + 1, 0}, {from}, words_in(run));
    for (std::size_t period = 1; period <= longest_period && from.run + period < runs_.size(); ++period) {
      if (from.taken == 0) repeat_whole_runs(from, period);
      if (may_be_cut(from.run) && may_be_cut(from.run + period)) {
        repeat_after_lead(from, period);
        repeat_with_tail(from, period);
      }
    }
  }

  // [X, K4]: the last of its knit runs may be longer than the others and give a part only.
  void repeat_whole_runs(Spot from, std::size_t period) {
    const std::size_t same = same_from(from.run, period);
    const std::size_t most = same / period + 1;
    std::int32_t words = 1;
    for (std::size_t i = 0; i < period; ++i) words += words_in(runs_[from.run + i]);
    for (std::size_t times = 2; times <= most; ++times)
      offer({from.run + times * period, 0}, {from, 0, 0, 0, period, times}, words);
    const std::size_t last = from.run + (most + 1) * period - 1;
    const std::size_t closing = from.run + period - 1;
    if (same % period != period - 1 || !may_be_cut(last) || !may_be_cut(closing)) return;
    if (runs_[last].count > runs_[closing].count)
      offer({last, runs_[closing].count}, {from, 0, 0, 0, period, most + 1}, words);
  }

  // K2, [K4, X]: its first knit run may be longer than the others.
  void repeat_after_lead(Spot from, std::size_t period) {
    const Run& meeting = runs_[from.run + period];
    const std::int32_t lead = rest_at(from) - meeting.count;
    // Without a lead and from a run's beginning these are whole runs.
    if (lead < 0 || (lead == 0 && from.taken == 0)) return;
    const Move move{from, lead, meeting.count, 0, period, 0};
    for (std::size_t times = 2; times <= most_times(from, period); ++times)
      offer_part(move, times, {from.run + times * period, 0});
  }

  // [K1, X, K3]: the runs where it meets itself are cut, and the last one may be longer.
  void repeat_with_tail(Spot from, std::size_t period) {
    const Run& meeting = runs_[from.run + period];
    const std::int32_t rest = rest_at(from);
    if (rest >= meeting.count) return;
    const Move move{from, 0, rest, meeting.count - rest, period, 0};
    for (std::size_t times = 2; times <= most_times(from, period); ++times) offer_tail(move, times);
  }

  void offer_tail(const Move& move, std::size_t times) {
    const std::size_t last = move.from.run + times * move.period;
    if (!may_be_cut(last) || runs_[last].count < move.tail) return;
    const bool used_up = runs_[last].count == move.tail;
    offer_part(move, times, used_up ? Spot{last + 1, 0} : Spot{last, move.tail});
  }

  void offer_part(Move move, std::size_t times, Spot to) {
    move.times = times;
    std::int32_t words = 1;
    if (move.lead > 0) ++words;
    for (const Run& run : block_of(move)) words += words_in(run);
    offer(to, move, words);
  }

  void offer(Spot to, const Move& move, std::int32_t words) {
    Cost cost = cost_here_;
    cost.words += words;
    if (move.times > 0) {
      ++cost.repeats;
      cost.starts += worked_[move.from.run] + move.from.taken + move.lead;
    }
    const auto [at, is_new] = found_[to.run].try_emplace(to.taken, Found{cost, move});
    if (!is_new && cost < at->second.cost) at->second = {cost, move};
  }

  [[nodiscard]] std::int32_t rest_at(Spot spot) const { return runs_[spot.run].count - spot.taken; }

  // Of a repeat that begins in a knit run: what stands between its knit runs is there so often.
  [[nodiscard]] std::size_t most_times(Spot from, std::size_t period) const {
    return 1 + (same_from(from.run + 1, period) + 1) / period;
  }

  [[nodiscard]] std::vector<Run> block_of(const Move& move) const {
    const auto first = runs_.begin() + static_cast<std::ptrdiff_t>(move.from.run);
    std::vector<Run> block(first, first + static_cast<std::ptrdiff_t>(move.period));
    if (move.head == 0) return block;
    block.front() = {Hand::knit, move.head};
    if (move.tail > 0) block.push_back({Hand::knit, move.tail});
    return block;
  }

  [[nodiscard]] std::vector<Phrase> written_up_to(Spot spot) const {
    std::vector<Phrase> backwards;
    while (spot != Spot{}) {
      const Move& move = found_[spot.run].at(spot.taken).move;
      if (move.times > 0) {
        backwards.emplace_back(Repeat{block_of(move), static_cast<std::int32_t>(move.times)});
        if (move.lead > 0) backwards.emplace_back(Run{Hand::knit, move.lead});
      } else {
        Run rest = runs_[move.from.run];
        rest.count -= move.from.taken;
        backwards.emplace_back(rest);
      }
      spot = move.from;
    }
    std::reverse(backwards.begin(), backwards.end());
    return backwards;
  }

  std::vector<Run> runs_;
  bool has_markers_;
  std::vector<std::int64_t> worked_{0};               // stitches worked before each run
  std::vector<std::vector<std::size_t>> same_;        // by period, from 1
  std::vector<std::map<std::int32_t, Found>> found_;  // by run, by what is taken of it
  Cost cost_here_;
};

}  // namespace

std::vector<Phrase> fold(std::span<const Operation> operations, const FoldOptions& options) {
  return Folder(runs_of(operations, options)).phrases();
}

}  // namespace knit
