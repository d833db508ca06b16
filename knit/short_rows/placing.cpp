#include "knit/short_rows/placing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace knit {

namespace {

constexpr std::int32_t farthest_move = 3, fewest_stitches = 3, fewest_beside = 2;

struct Span {
  std::int32_t first = 0, last = 0;
  [[nodiscard]] std::int32_t stitches() const { return last - first + 1; }
};

bool is_symmetric(const Span& span, std::int32_t count) { return (span.first + span.last) % count == 0; }

// The stitches that stand in the arc; unwrapped so that first <= last, and last is in the round.
Span stitches_in(const PairArc& arc, const RoundBelow& round) {
  const auto count = static_cast<std::int32_t>(round.columns.size());
  const double whole = round.chart_columns, begin = round.columns[0];
  // Rounding must not decide whether a stitch on the arc's end is in it.
  const double slack = 1e-7 * whole;
  const auto from_beginning = [&](double column) {
    const double way = column - begin;
    return way - std::floor((way + slack) / whole) * whole;
  };
  const double from = from_beginning(arc.from), to = from_beginning(arc.to);
  const auto stitches_before = [&](double way) {
    return static_cast<std::int32_t>(
        std::count_if(round.columns.begin(), round.columns.end(), [&](double c) { return c - begin < way; }));
  };
  Span span{stitches_before(from - slack), stitches_before(to + slack) - 1};
  if (to < from) span.first -= count;  // over the beginning
  return span;
}

// Each stitch and its image, as far before the beginning of the round, at the mean of their columns.
RoundBelow made_alike(const RoundBelow& round) {
  RoundBelow alike = round;
  const std::size_t count = round.columns.size();
  const double begin = round.columns[0];
  for (std::size_t i = 1; i < count; ++i)
    alike.columns[i] =
        begin + 0.5 * ((round.columns[i] - begin) + round.chart_columns - (round.columns[count - i] - begin));
  return alike;
}

// Whether the arc's middle is where the round begins, or opposite.
bool is_centred(const PairArc& arc, const RoundBelow& round) {
  const double off = (arc.from + arc.to - 2.0 * round.columns[0]) / round.chart_columns;
  return std::abs(off - std::round(off)) < 1e-6;
}

Span wanted_for(const PairArc& arc, const RoundBelow& round) {
  const Span span = stitches_in(arc, round);
  if (!round.mirrored || !is_centred(arc, round)) return span;
  const Span alike = stitches_in(arc, made_alike(round));
  return std::abs(alike.first - span.first) <= 1 && std::abs(alike.last - span.last) <= 1 ? alike : span;
}

class Placer {
 public:
  explicit Placer(const RoundBelow& round)
      : round_(round), count_(static_cast<std::int32_t>(round.columns.size())) {}

  [[nodiscard]] bool legal(const Span& span) const {
    const bool over = span.first < 0 && span.last > 0;
    if (!over && (span.first < 2 || span.last > count_ - 2)) return false;
    if (span.stitches() < fewest_stitches || span.stitches() > count_ - fewest_beside) return false;
    return plain(span.first - 1) && plain(span.first) && plain(span.last) && plain(span.last + 1);
  }

  // The first legal place, the nearest first. Only the end that is in the way moves, so the order of the two does not matter.
  [[nodiscard]] std::optional<Span> place(const Span& wanted) const {
    if (legal(wanted)) return wanted;
    for (std::int32_t shift = 1; shift <= farthest_move; ++shift) {
      for (const std::int32_t wider : {shift, -shift}) {
        const std::int32_t first = wanted.first - wider, last = wanted.last + wider;
        const Span both{first, last};
        if (round_.mirrored && is_symmetric(wanted, count_) && legal(both)) return both;
        for (const Span& tried : {Span{first, wanted.last}, Span{wanted.first, last}, both})
          if (legal(tried)) return tried;
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool plain(std::int32_t stitch) const {
    return round_.plain[static_cast<std::size_t>((stitch % count_ + count_) % count_)] != 0;
  }

  const RoundBelow& round_;
  std::int32_t count_;
};

// Those over the beginning first, the widest last; then the others by their first stitch, the shorter first.
bool worked_before(const PairPlan& a, const PairPlan& b) {
  if (a.over_beginning() != b.over_beginning()) return a.over_beginning();
  if (a.first != b.first) return a.over_beginning() ? a.first > b.first : a.first < b.first;
  return a.last < b.last;
}

DropReason reason_of(const Span& span, std::int32_t count) {
  if (span.stitches() < fewest_stitches) return DropReason::too_few;
  if (span.stitches() > count - fewest_beside) return DropReason::too_many;
  return DropReason::no_plain_stitch;
}

}  // namespace

std::string sentence_of(const DroppedPair& dropped, std::int32_t row) {
  std::string what = "Row " + std::to_string(row) + ": a short row over " +
                     std::to_string(std::max(0, dropped.stitches())) + " stitches was left out: ";
  switch (dropped.reason) {
    case DropReason::no_plain_stitch:
      return what + "no plain stitch to turn at within 3 stitches.";
    case DropReason::too_few:
      return what + "it is under 3 stitches long.";
    case DropReason::too_many:
      return what + "it would leave under 2 stitches of the round.";
  }
  return what;
}

void place_pairs(std::span<const PairArc> arcs_of_gap, const RoundBelow& round, PairPlans& plans) {
  const Placer placer(round);
  const auto begin = static_cast<std::ptrdiff_t>(plans.pairs.size());
  for (const PairArc& arc : arcs_of_gap) {
    const Span wanted = wanted_for(arc, round);
    const auto count = static_cast<std::int32_t>(round.columns.size());
    // Too far off to be moved: dropped for what it is.
    const bool sized = wanted.stitches() >= fewest_stitches && wanted.stitches() <= count - fewest_beside;
    const std::optional<Span> placed = sized ? placer.place(wanted) : std::nullopt;
    if (!placed) {
      plans.dropped.push_back({arc.gap, wanted.first, wanted.last, reason_of(wanted, count)});
      continue;
    }
    const std::int32_t moved =
        std::max(std::abs(placed->first - wanted.first), std::abs(placed->last - wanted.last));
    plans.pairs.push_back({arc.gap, placed->first, placed->last, arc.gain, arc.price, arc.lag, moved});
  }
  std::stable_sort(plans.pairs.begin() + begin, plans.pairs.end(), worked_before);
}

}  // namespace knit
