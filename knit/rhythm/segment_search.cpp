#include "knit/rhythm/segment_search.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "knit/model/ties.h"
#include "knit/rhythm/segment_states.h"

namespace knit {

namespace {

constexpr std::int32_t longest_turn = 12;
constexpr std::int32_t most_turns = 40;

double highest_first(double ideal) { return std::max(12.0, 2.6 * ideal); }

class SegmentSearch {
 public:
  explicit SegmentSearch(const SegmentTask& task)
      : task_(task), rows_(static_cast<std::int32_t>(task.ideals.size())), twice_(task.half ? 2.0 : 1.0) {
    const double belt = *std::max_element(task.ideals.begin(), task.ideals.end());
    levels_ = static_cast<std::int32_t>(std::ceil(1.12 * belt / sections())) + 1;
    levels_ = std::max(levels_, std::max({task.start.count, task.start.live, task.last}) / sections());
    band_ = std::max(1.6 * task.family.changes(), 0.1 * belt) + 2.0;
    sum_stretches();
    tie_scale_ = std::max(1.0, belt * belt);
  }

  std::optional<FoundSegments> found() {
    begin();
    for (std::int32_t row = task_.start.row; row < rows_; ++row) {
      hear(task_.heard, static_cast<double>(row) / rows_);
      for (std::int32_t level = 0; level < levels_; ++level) {
        for (std::int32_t end = 0; end < segment_ends; ++end) {
          const Place here{row, level, end};
          if (at(here).cost == never) continue;
          const bool near = is_near(row, level);
          if (near || end == after_plain) stay(here);
          if (near) change(here);
        }
      }
    }
    return best();
  }

 private:
  // A count is sections x (level + 1).
  struct Place {
    std::int32_t row = 0, level = 0, end = 0;
  };
  // By a segment of so many turns that begins at the place with the number `from`; the two places say the rest of it.
  struct Reached {
    double cost = never;
    std::int32_t from = -1;
    std::int32_t times = 1;
  };

  [[nodiscard]] std::int32_t sections() const { return task_.family.sections; }
  [[nodiscard]] std::int32_t count_at(std::int32_t level) const { return sections() * (level + 1); }
  [[nodiscard]] double ideal(std::int32_t row) const { return task_.ideals[static_cast<std::size_t>(row)]; }
  [[nodiscard]] std::int32_t number_of(const Place& place) const {
    return (place.row * levels_ + place.level) * segment_ends + place.end;
  }
  [[nodiscard]] Place place_of(std::int32_t number) const {
    const std::int32_t line = number / segment_ends;
    return {line / levels_, line % levels_, number % segment_ends};
  }
  [[nodiscard]] Reached& at(const Place& place) {
    return reached_[static_cast<std::size_t>(number_of(place))];
  }
  // Of the rows a to b - 1 at one count.
  [[nodiscard]] double stretch(std::int32_t level, std::int32_t a, std::int32_t b) const {
    const auto line = static_cast<std::size_t>(level) * (task_.ideals.size() + 1);
    return sums_[line + static_cast<std::size_t>(b)] - sums_[line + static_cast<std::size_t>(a)];
  }
  // The first rows about a pole may be far off: a cast on has its least.
  [[nodiscard]] bool is_near(std::int32_t row, std::int32_t level) const {
    return row <= 2 || std::abs(count_at(level) - ideal(row)) <= band_;
  }

  void sum_stretches() {
    for (std::int32_t level = 0; level < levels_; ++level) {
      sums_.push_back(0.0);
      for (const double ideal : task_.ideals) {
        const double off = count_at(level) - ideal;
        sums_.push_back(sums_.back() + twice_ * std::min(1.0, ideal / 12.0) * off * off);
      }
    }
    reached_.resize(static_cast<std::size_t>(rows_ * levels_ * segment_ends));
  }

  [[nodiscard]] bool may_begin(std::int32_t count) const {
    const RhythmStart& start = task_.start;
    if (start.count > 0) return count == start.count;
    if (start.live > 0) return count >= 3 && 2 * count >= start.live && count <= 2 * start.live;
    return count >= 3 && count <= highest_first(ideal(0));
  }

  void begin() {
    const RhythmStart& start = task_.start;
    for (std::int32_t level = 0; level < levels_; ++level) {
      const std::int32_t count = count_at(level);
      if (!may_begin(count)) continue;
      Reached& first = at({start.row, level, static_cast<std::int32_t>(start.ended)});
      first.cost = start.row == 0 ? stretch(level, 0, 1) : 0.0;
      if (start.live > 0 && count != start.live) {
        const bool one_repeat = sections_to_begin(start.live, count, true) > 0;
        first.cost += (one_repeat ? 1.0 : 4.0) * task_.prices.rhythm;
      }
    }
  }

  void reach(const Place& to, double cost, const Place& from, std::int32_t times) {
    Reached& there = at(to);
    if (there.cost < never && !clearly_less(cost, there.cost, tie_scale_)) return;
    there = {cost, number_of(from), times};
  }

  void change(const Place& from) {
    for (const std::int32_t each : {1, 2}) {
      if (!(each == 1 ? task_.family.one : task_.family.two)) continue;
      for (const std::int32_t step : {each, -each}) {
        for (std::int32_t turn = 1; turn <= longest_turn && from.row + turn < rows_; ++turn) {
          change_last(from, step, turn);
          if (turn > 1) change_first(from, step, turn);
        }
      }
    }
  }

  // One plain row more. Of two plain stretches at one count the cheaper stays the cheaper, so only that one goes on.
  void stay(const Place& from) {
    if (from.row + 1 == rows_) return;
    // Where the plan begins behind plain rows that are made, no stretch of its own goes on.
    const bool goes_on = from.end == after_plain && at(from).from >= 0;
    const Place begun = goes_on ? place_of(at(from).from) : from;
    const double cost = at(begun).cost + twice_ * task_.prices.plain;
    reach({from.row + 1, from.level, after_plain}, cost + stretch(from.level, begun.row + 1, from.row + 2),
          begun, 1);
  }

  [[nodiscard]] double begun(const Place& from, std::int32_t step) {
    const bool single = task_.family.two && std::abs(step) == 1;
    return at(from).cost + twice_ * (task_.prices.rhythm + (single ? task_.prices.single : 0.0));
  }
  [[nodiscard]] bool can_turn(const Place& now, std::int32_t step, std::int32_t turn) const {
    return now.row + turn < rows_ && now.level + step >= 0 && now.level + step < levels_ &&
           may_change(now.level + 1, step);
  }

  void change_last(const Place& from, std::int32_t step, std::int32_t turn) {
    Place now{from.row, from.level, after_change};
    double cost = begun(from, step);
    const bool at_once = from.end == after_change;
    for (std::int32_t times = 1; times <= most_turns && can_turn(now, step, turn); ++times) {
      cost += stretch(now.level, now.row + 1, now.row + turn);
      now.level += step;
      now.row += turn;
      if (!is_near(now.row, now.level)) return;
      const bool unrested = turn == 1 && (times > 1 || at_once);
      cost += stretch(now.level, now.row, now.row + 1) +
              twice_ * (task_.prices.change + (unrested ? task_.prices.unrested : 0.0));
      reach(now, cost, from, times);
    }
  }

  void change_first(const Place& from, std::int32_t step, std::int32_t turn) {
    Place now{from.row, from.level, after_rest};
    double cost = begun(from, step);
    if (from.end == after_change) cost += twice_ * task_.prices.unrested;
    for (std::int32_t times = 1; times <= most_turns && can_turn(now, step, turn); ++times) {
      now.level += step;
      cost += stretch(now.level, now.row + 1, now.row + turn + 1) + twice_ * task_.prices.change;
      now.row += turn;
      if (!is_near(now.row, now.level)) return;
      reach(now, cost, from, times);
    }
  }

  [[nodiscard]] RhythmSegment segment_between(const Place& from, const Place& to) {
    const std::int32_t times = at(to).times;
    const SegmentKind kind = to.end == after_plain    ? SegmentKind::plain
                             : to.end == after_change ? SegmentKind::pre
                                                      : SegmentKind::post;
    return {kind, (to.row - from.row) / times, (to.level - from.level) / times * sections(), times};
  }

  [[nodiscard]] std::optional<FoundSegments> best() {
    std::optional<Place> least;
    const auto look = [&](bool (*allowed)(std::int32_t, const SegmentTask&)) {
      for (std::int32_t level = 0; level < levels_; ++level) {
        if (!allowed(count_at(level), task_)) continue;
        for (std::int32_t end = 0; end < segment_ends; ++end) {
          const Place here{rows_ - 1, level, end};
          if (at(here).cost == never) continue;
          if (least && !clearly_less(at(here).cost, at(*least).cost, tie_scale_)) continue;
          least = here;
        }
      }
    };
    look([](std::int32_t count, const SegmentTask& task) {
      if (task.last > 0) return count == task.last;
      return task.half || count <= highest_first(task.ideals.back());
    });
    if (!least && task_.last == 0) look([](std::int32_t, const SegmentTask&) { return true; });
    if (!least) return {};
    FoundSegments found;
    found.cost = at(*least).cost;
    Place now = *least;
    while (now.row > task_.start.row) {
      const Place from = place_of(at(now).from);
      found.segments.push_back(segment_between(from, now));
      now = from;
    }
    std::reverse(found.segments.begin(), found.segments.end());
    found.first = count_at(now.level);
    return found;
  }

  const SegmentTask& task_;
  std::int32_t rows_ = 0, levels_ = 0;
  double twice_ = 1.0, band_ = 0.0, tie_scale_ = 1.0;
  std::vector<double> sums_;  // of a level's rows, level after level
  std::vector<Reached> reached_;
};

}  // namespace

RhythmPrices rhythm_prices(const RhythmFamily& family, double dial, std::span<const double> ideals) {
  const double percent = *std::max_element(ideals.begin(), ideals.end()) / 100.0;
  const double unit = percent * percent * static_cast<double>(ideals.size());
  const double rhythm = 1.5 * dial * unit;
  return {rhythm, 0.4 * rhythm, 0.015 * unit, 0.05 * unit, family.one && family.two ? 0.3 * rhythm : 0.0};
}

bool may_change(std::int32_t section, std::int32_t change) {
  if (change > 0) return change <= section;
  return section + change >= 1 && -2 * change <= section;
}

std::int32_t sections_to_begin(std::int32_t live, std::int32_t count, bool in_pairs) {
  const std::int32_t change = count - live;
  if (live < 1 || change == 0) return 0;
  const auto sections_of = [&](std::int32_t each) {
    const std::int32_t sections = std::abs(change) / each;
    const bool whole = sections > 0 && std::abs(change) % each == 0 && live % sections == 0;
    return whole && may_change(live / sections, change > 0 ? each : -each) ? sections : 0;
  };
  const std::int32_t first = in_pairs ? 2 : 1;
  const std::int32_t sections = sections_of(first);
  return sections > 0 ? sections : sections_of(3 - first);
}

std::optional<FoundSegments> find_segments(const SegmentTask& task) { return SegmentSearch(task).found(); }

}  // namespace knit
