#include "knit/rhythm/joint_search.h"

#include <algorithm>
#include <cmath>

#include "knit/model/ties.h"
#include "knit/rhythm/segment_states.h"

namespace knit {

namespace {

constexpr std::int32_t longest_half_turn = 6;
constexpr std::int32_t most_half_turns = 14;

// One half: what its rows cost at each even count, and the counts that are in reach of each row.
class Half {
 public:
  Half(std::span<const double> ideals, std::span<const double> weights) : ideals_(ideals) {
    const double belt = *std::max_element(ideals.begin(), ideals.end());
    reach_ = std::clamp(0.1 * belt + 4.0, 8.0, 16.0);
    levels_ = static_cast<std::int32_t>((belt + reach_) / 2.0) + 2;
    window_ = static_cast<std::int32_t>(reach_) + 2;
    for (std::int32_t level = 0; level < levels_; ++level) {
      sums_.push_back(0.0);
      for (std::size_t row = 0; row < ideals.size(); ++row) {
        const double off = 2.0 * level - ideals[row];
        sums_.push_back(sums_.back() + weights[row] * off * off);
      }
    }
  }
  // Of the rows a to b - 1 at one count.
  [[nodiscard]] double stretch(std::int32_t count, std::int32_t a, std::int32_t b) const {
    const auto line = static_cast<std::size_t>(count / 2) * (ideals_.size() + 1);
    return sums_[line + static_cast<std::size_t>(b)] - sums_[line + static_cast<std::size_t>(a)];
  }
  [[nodiscard]] bool reaches(std::int32_t row, std::int32_t count) const {
    return count >= 2 && count / 2 < levels_ && in_window(row, count) >= 0 &&
           in_window(row, count) < window_ &&
           std::abs(count - ideals_[static_cast<std::size_t>(row)]) <= reach_;
  }
  // Counts that a row may have are lowest(row), and two more each.
  [[nodiscard]] std::int32_t lowest(std::int32_t row) const {
    const double least = ideals_[static_cast<std::size_t>(row)] - reach_;
    return 2 * std::max(1, static_cast<std::int32_t>(std::floor(least / 2.0)));
  }
  [[nodiscard]] std::int32_t in_window(std::int32_t row, std::int32_t count) const {
    return count < lowest(row) ? -1 : (count - lowest(row)) / 2;
  }
  [[nodiscard]] std::int32_t window() const { return window_; }

 private:
  std::span<const double> ideals_;
  double reach_ = 0.0;
  std::int32_t levels_ = 0, window_ = 0;
  std::vector<double> sums_;  // of a count's rows, count after count
};

std::vector<double> weights_of(const JointTask& task) {
  std::vector<double> weights;
  for (std::size_t row = 0; row < task.front.size(); ++row)
    weights.push_back(std::min(1.0, (task.front[row] + task.back[row]) / 12.0));
  return weights;
}

class JointSearch {
 public:
  explicit JointSearch(const JointTask& task)
      : task_(task),
        rows_(static_cast<std::int32_t>(task.front.size())),
        weights_(weights_of(task)),
        front_(task.front, weights_),
        back_(task.back, weights_) {
    reached_.resize(static_cast<std::size_t>(rows_ * front_.window() * back_.window() * segment_ends));
    for (std::size_t row = 0; row < task.front.size(); ++row)
      tie_scale_ =
          std::max(tie_scale_, (task.front[row] + task.back[row]) * (task.front[row] + task.back[row]));
  }

  std::optional<FoundJoint> found() {
    begin();
    for (std::int32_t row = task_.start.row; row < rows_; ++row) {
      hear(task_.heard, static_cast<double>(row) / rows_);
      for (const Place& here : going_on(row)) {
        stay(here);
        for (const HalvesChange& change : task_.growing) shape(here, change);
        for (const HalvesChange& change : task_.shrinking) shape(here, {-change.front, -change.back});
      }
    }
    return best();
  }

 private:
  struct Place {
    std::int32_t row = 0, front = 0, back = 0, end = 0;
  };
  struct Reached {
    double cost = never;
    std::int32_t from = -1;
    std::int32_t times = 1;
  };

  [[nodiscard]] std::int32_t number_of(const Place& p) const {
    const std::int32_t f = front_.in_window(p.row, p.front), b = back_.in_window(p.row, p.back);
    return ((p.row * front_.window() + f) * back_.window() + b) * segment_ends + p.end;
  }
  [[nodiscard]] Place place_of(std::int32_t number) const {
    const std::int32_t line = number / segment_ends, cell = line / back_.window();
    const std::int32_t row = cell / front_.window();
    return {row, front_.lowest(row) + 2 * (cell % front_.window()),
            back_.lowest(row) + 2 * (line % back_.window()), number % segment_ends};
  }
  [[nodiscard]] Reached& at(const Place& place) {
    return reached_[static_cast<std::size_t>(number_of(place))];
  }
  [[nodiscard]] bool reaches(const Place& place) const {
    return place.row < rows_ && front_.reaches(place.row, place.front) &&
           back_.reaches(place.row, place.back);
  }
  [[nodiscard]] double stretch(const Place& at_counts_of, std::int32_t a, std::int32_t b) const {
    return front_.stretch(at_counts_of.front, a, b) + back_.stretch(at_counts_of.back, a, b);
  }

  [[nodiscard]] bool may_begin(const Place& place) const {
    const RhythmStart& start = task_.start;
    const std::int32_t count = place.front + place.back;
    if (start.count > 0) {
      const bool split = task_.start_front == 0 || place.front == task_.start_front;
      return count == start.count && split;
    }
    if (start.live > 0) return 2 * count >= start.live && count <= 2 * start.live;
    return count >= 4 && count <= std::max(12.0, 2.6 * (task_.front[0] + task_.back[0]));
  }
  // Of the first round where it makes another count of the live stitches: one more or fewer, as an odd count needs it, is a change, more
  // a rhythm of its own. How they part into halves is open: no mains stand in them.
  [[nodiscard]] double price_to_begin(const Place& place) const {
    const std::int32_t live = task_.start.live, more = std::abs(place.front + place.back - live);
    if (live == 0 || more == 0) return 0.0;
    return more == 1 ? task_.prices.change : task_.prices.rhythm;
  }
  void begin() {
    const RhythmStart& start = task_.start;
    Place place{start.row, 0, 0, static_cast<std::int32_t>(start.ended)};
    for (std::int32_t f = 0; f < front_.window(); ++f) {
      place.front = front_.lowest(start.row) + 2 * f;
      for (std::int32_t b = 0; b < back_.window(); ++b) {
        place.back = back_.lowest(start.row) + 2 * b;
        if (!reaches(place) || !may_begin(place)) continue;
        at(place).cost = start.row == 0 ? stretch(place, 0, 1) : 0.0;
        at(place).cost += price_to_begin(place);
      }
    }
  }

  // States of a row, those with the least cost as far as the beam goes, in the order of their numbers.
  [[nodiscard]] std::vector<Place> going_on(std::int32_t row) {
    const std::int32_t all = front_.window() * back_.window() * segment_ends;
    std::vector<std::int32_t> numbers;
    for (std::int32_t i = row * all; i < (row + 1) * all; ++i) {
      if (reached_[static_cast<std::size_t>(i)].cost < never) numbers.push_back(i);
    }
    if (task_.beam > 0 && numbers.size() > task_.beam) {
      sort_by_rule(
          numbers, [&](std::int32_t i) { return reached_[static_cast<std::size_t>(i)].cost; }, tie_scale_);
      numbers.resize(task_.beam);
      std::sort(numbers.begin(), numbers.end());
    }
    std::vector<Place> places;
    places.reserve(numbers.size());
    for (const std::int32_t number : numbers) places.push_back(place_of(number));
    return places;
  }

  void reach(const Place& to, double cost, const Place& from, std::int32_t times) {
    Reached& there = at(to);
    if (there.cost < never && !clearly_less(cost, there.cost, tie_scale_)) return;
    there = {cost, number_of(from), times};
  }

  // One plain row more.
  void stay(const Place& from) {
    const Place to{from.row + 1, from.front, from.back, after_plain};
    if (!reaches(to)) return;
    const bool goes_on = from.end == after_plain && at(from).from >= 0;
    const Place begun = goes_on ? place_of(at(from).from) : from;
    reach(to, at(begun).cost + task_.prices.plain + stretch(from, begun.row + 1, to.row + 1), begun, 1);
  }

  void shape(const Place& from, const HalvesChange& change) {
    for (std::int32_t turn = 1; turn <= longest_half_turn && from.row + turn < rows_; ++turn) {
      change_last(from, change, turn);
      if (turn > 1) change_first(from, change, turn);
    }
  }
  [[nodiscard]] double begun(const Place& from, const HalvesChange& change) {
    const double apart = change.front == change.back ? 0.0 : task_.prices.rhythm / 6.0;
    return at(from).cost + task_.prices.rhythm + apart;
  }
  [[nodiscard]] static bool may_change(const Place& now, const HalvesChange& change) {
    return may_change_half(now.front, change.front) && may_change_half(now.back, change.back);
  }

  void change_last(const Place& from, const HalvesChange& change, std::int32_t turn) {
    Place now{from.row, from.front, from.back, after_change};
    double cost = begun(from, change);
    for (std::int32_t times = 1; times <= most_half_turns && may_change(now, change); ++times) {
      const Place next{now.row + turn, now.front + change.front, now.back + change.back, after_change};
      if (!reaches(next)) return;
      cost += stretch(now, now.row + 1, next.row) + stretch(next, next.row, next.row + 1);
      const bool unrested = turn == 1 && (times > 1 || from.end == after_change);
      cost += task_.prices.change + (unrested ? task_.prices.unrested : 0.0);
      now = next;
      reach(now, cost, from, times);
    }
  }

  void change_first(const Place& from, const HalvesChange& change, std::int32_t turn) {
    Place now{from.row, from.front, from.back, after_rest};
    double cost = begun(from, change) + (from.end == after_change ? task_.prices.unrested : 0.0);
    for (std::int32_t times = 1; times <= most_half_turns && may_change(now, change); ++times) {
      const Place next{now.row + turn, now.front + change.front, now.back + change.back, after_rest};
      if (!reaches(next)) return;
      cost += stretch(next, now.row + 1, next.row + 1) + task_.prices.change;
      now = next;
      reach(now, cost, from, times);
    }
  }

  [[nodiscard]] RhythmSegment segment_between(const Place& from, const Place& to) {
    const std::int32_t times = at(to).times;
    const SegmentKind kind = to.end == after_plain    ? SegmentKind::plain
                             : to.end == after_change ? SegmentKind::pre
                                                      : SegmentKind::post;
    const std::int32_t front = (to.front - from.front) / times, back = (to.back - from.back) / times;
    return {kind, (to.row - from.row) / times, front + back, times, front};
  }

  [[nodiscard]] std::optional<Place> cheapest_end(double most) {
    std::optional<Place> least;
    const std::int32_t all = front_.window() * back_.window() * segment_ends;
    for (std::int32_t i = (rows_ - 1) * all; i < rows_ * all; ++i) {
      const double cost = reached_[static_cast<std::size_t>(i)].cost;
      const Place here = place_of(i);
      if (cost == never || here.front + here.back > most) continue;
      if (!least || clearly_less(cost, at(*least).cost, tie_scale_)) least = here;
    }
    return least;
  }

  [[nodiscard]] std::optional<FoundJoint> best() {
    std::optional<Place> least = cheapest_end(std::max(12.0, 2.6 * (task_.front.back() + task_.back.back())));
    if (!least) least = cheapest_end(never);
    if (!least) return std::nullopt;
    FoundJoint found;
    found.cost = at(*least).cost;
    Place now = *least;
    while (now.row > task_.start.row) {
      const Place from = place_of(at(now).from);
      found.segments.push_back(segment_between(from, now));
      now = from;
    }
    std::reverse(found.segments.begin(), found.segments.end());
    found.first_front = now.front;
    found.first_back = now.back;
    return found;
  }

  const JointTask& task_;
  std::int32_t rows_ = 0;
  std::vector<double> weights_;
  Half front_, back_;
  double tie_scale_ = 1.0;
  std::vector<Reached> reached_;
};

}  // namespace

bool may_change_half(std::int32_t half, std::int32_t change) {
  const std::int32_t quarter = half / 2;
  if (change > 0) return change / 2 <= quarter;
  return change == 0 || quarter >= (change == -2 ? 3 : 4);
}

std::optional<FoundJoint> find_joint_segments(const JointTask& task) { return JointSearch(task).found(); }

}  // namespace knit
