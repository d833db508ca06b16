// The dynamic programme against all lists of segments, on short pieces.
#include "knit/rhythm/segment_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/catch.h"
#include "tests/support/rough_sphere.h"

using namespace knit;
using Catch::Matchers::WithinAbs;
using test_support::Dice;

namespace {

// Of a whole list, row by row: nothing of it is shared with the search.
double cost_of(const SegmentTask& task, std::int32_t first, const std::vector<RhythmSegment>& segments) {
  const std::vector<std::int32_t> counts = counts_of(first, segments);
  double cost = 0.0;
  for (std::size_t row = 0; row < counts.size(); ++row) {
    const double off = counts[row] - task.ideals[row];
    cost += std::min(1.0, task.ideals[row] / 12.0) * off * off;
  }
  bool changed = false;
  for (const RhythmSegment& segment : segments) {
    if (segment.kind == SegmentKind::plain) {
      cost += task.prices.plain;
      changed = false;
      continue;
    }
    const bool single = task.family.two && std::abs(segment.change) == task.family.sections;
    cost += task.prices.rhythm + (single ? task.prices.single : 0.0) + segment.times * task.prices.change;
    const bool at_once = changed && (segment.kind == SegmentKind::post || segment.rows == 1);
    cost += ((at_once ? 1 : 0) + (segment.rows == 1 ? segment.times - 1 : 0)) * task.prices.unrested;
    changed = segment.kind == SegmentKind::pre;
  }
  return cost;
}

// Goes through all lists that fill the rows.
class AllLists {
 public:
  explicit AllLists(const SegmentTask& task)
      : task_(task), rows_(static_cast<std::int32_t>(task.ideals.size())) {}

  double least() {
    const std::int32_t sections = task_.family.sections;
    highest_ =
        sections * (static_cast<std::int32_t>(std::ceil(
                        1.12 * *std::max_element(task_.ideals.begin(), task_.ideals.end()) / sections)) +
                    1);
    const double most = std::max(12.0, 2.6 * task_.ideals.front());
    for (std::int32_t first = sections; first <= std::min<double>(most, highest_); first += sections) {
      if (first < 3) continue;
      first_ = first;
      go_on(0, first);
    }
    return least_;
  }
  std::size_t lists = 0;

 private:
  void go_on(std::int32_t row, std::int32_t count) {
    if (row == rows_ - 1) {
      if (count > std::max(12.0, 2.6 * task_.ideals.back())) return;
      ++lists;
      least_ = std::min(least_, cost_of(task_, first_, segments_));
      return;
    }
    if (segments_.empty() || segments_.back().kind != SegmentKind::plain) {
      for (std::int32_t length = 1; row + length < rows_; ++length)
        with({SegmentKind::plain, length}, row + length, count);
    }
    for (const std::int32_t each : {1, -1, 2, -2}) {
      if (!(std::abs(each) == 1 ? task_.family.one : task_.family.two)) continue;
      for (std::int32_t turn = 1; row + turn < rows_; ++turn) {
        std::int32_t now = count;
        for (std::int32_t times = 1; row + turn * times < rows_; ++times) {
          const std::int32_t change = each * task_.family.sections;
          if (!may_change(now / task_.family.sections, each) || now + change > highest_) break;
          now += change;
          with({SegmentKind::pre, turn, change, times}, row + turn * times, now);
          if (turn > 1) with({SegmentKind::post, turn, change, times}, row + turn * times, now);
        }
      }
    }
  }
  void with(const RhythmSegment& segment, std::int32_t row, std::int32_t count) {
    segments_.push_back(segment);
    go_on(row, count);
    segments_.pop_back();
  }

  const SegmentTask& task_;
  std::int32_t rows_ = 0, first_ = 0, highest_ = 0;
  std::vector<RhythmSegment> segments_;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace

TEST_CASE("of all lists of segments the search finds one with the least cost") {
  Dice dice(3);
  std::size_t lists = 0;
  for (int i = 0; i < 30; ++i) {
    std::vector<double> ideals{dice.between(4.0, 14.0)};
    const std::size_t rows = 6 + dice.below(3);
    while (ideals.size() < rows) ideals.push_back(std::max(4.0, ideals.back() + dice.between(-4.0, 6.0)));
    RhythmPrices prices;
    // Every third has no prices: the least sum of squares.
    if (i % 3 != 0) {
      prices = {dice.between(0.0, 9.0), dice.between(0.0, 4.0), 0.3, dice.between(0.0, 1.5), 0.0};
      prices.single = 0.3 * prices.rhythm;
    }
    const bool both = i % 5 == 0 && rows < 8;
    const RhythmFamily family{3 + static_cast<std::int32_t>(dice.below(4)), true, both};
    const SegmentTask task{ideals, family, prices};
    const auto found = find_segments(task);
    REQUIRE(found);
    AllLists all(task);
    INFO("piece " << i << ", " << rows << " rows, " << family.sections << " sections");
    CHECK_THAT(found->cost, WithinAbs(all.least(), 1e-6));
    CHECK_THAT(found->cost, WithinAbs(cost_of(task, found->first, found->segments), 1e-6));
    lists += all.lists;
  }
  CHECK(lists > 10000);
}

TEST_CASE("the last count may be said, and what cannot be reached is no plan") {
  const std::vector<double> ideals{8.0, 10.0, 13.0, 16.0, 19.0, 22.0, 24.0};
  SegmentTask task{ideals, {4, true, false}, {}};
  task.last = 16;
  auto found = find_segments(task);
  REQUIRE(found);
  CHECK(counts_of(found->first, found->segments).back() == 16);
  task.last = 18;
  CHECK(!find_segments(task));
  task.last = 0;
  task.start.count = 6;
  CHECK(!find_segments(task));
}

TEST_CASE("a section doubles or halves at most") {
  CHECK(may_change(1, 1));
  CHECK(!may_change(1, 2));
  CHECK(may_change(2, 2));
  CHECK(!may_change(1, -1));
  CHECK(may_change(2, -1));
  CHECK(!may_change(3, -2));
  CHECK(may_change(4, -2));
}

TEST_CASE("segments are counts, roles and words, and mirror") {
  const std::vector<RhythmSegment> opening{
      {SegmentKind::pre, 2, 8, 2}, {SegmentKind::post, 3, 8, 1}, {SegmentKind::plain, 2}};
  CHECK(counts_of(8, opening) == std::vector<std::int32_t>{8, 8, 16, 16, 24, 32, 32, 32, 32, 32});
  using Role = RowRole;
  CHECK(roles_of(opening) == std::vector<Role>{Role::first, Role::rest, Role::change, Role::rest,
                                               Role::change, Role::change, Role::rest, Role::rest,
                                               Role::plain, Role::plain});
  const std::vector<RhythmSegment> all = with_mirror(opening, 19);
  CHECK(segments_text(all) == "+8/2x2; +8/3x1'; knit 4; -8/3x1; -8/2x2'");
  const std::vector<std::int32_t> counts = counts_of(8, all);
  CHECK(counts.size() == 19);
  CHECK(std::equal(counts.begin(), counts.end(), counts.rbegin()));
}
