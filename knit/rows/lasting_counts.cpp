#include "knit/rows/lasting_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "knit/model/ties.h"

namespace knit {

namespace {

// Towards which a row's count may change without undoing anything.
enum class Heading : std::uint8_t { up, down };
constexpr std::array headings{Heading::up, Heading::down};
Heading turned_from(Heading heading) { return heading == Heading::up ? Heading::down : Heading::up; }
std::size_t slot_of(Heading heading) { return heading == Heading::up ? 0 : 1; }

struct CountCost {
  std::int32_t undone = 0;
  double misfit = std::numeric_limits<double>::infinity();
};
bool is_better(const CountCost& a, const CountCost& b) {
  if (a.misfit == std::numeric_limits<double>::infinity()) return false;
  if (b.misfit == std::numeric_limits<double>::infinity()) return true;
  return a.undone != b.undone ? a.undone < b.undone : clearly_less(a.misfit, b.misfit, 1.0);
}

// The row's count and heading once the row before is left.
struct NextCount {
  std::size_t row = 0;
  std::int32_t count = 0;
  Heading heading = Heading::up;
};

// What a row may hold, from `low` on, and for each heading the least cost of it and the rows above.
struct CountsOfRow {
  std::int32_t low = 0, high = 0;
  std::vector<double> misfits;
  std::array<std::vector<CountCost>, 2> costs;
  std::array<std::vector<NextCount>, 2> next;
  // Of counts on the heading's side of one, itself among them: the count with the least cost, the nearest of equals.
  std::array<std::vector<std::int32_t>, 2> best_from;

  [[nodiscard]] bool has(std::int32_t count) const { return low <= count && count <= high; }
  [[nodiscard]] double misfit(std::int32_t count) const {
    return misfits[static_cast<std::size_t>(count - low)];
  }
  [[nodiscard]] const CountCost& cost(std::int32_t count, Heading heading) const {
    return costs[slot_of(heading)][static_cast<std::size_t>(count - low)];
  }
  // 0: none lies there.
  [[nodiscard]] std::int32_t best_towards(std::int32_t count, Heading heading) const {
    const std::int32_t from = heading == Heading::up ? std::max(count, low) : std::min(count, high);
    return has(from) ? best_from[slot_of(heading)][static_cast<std::size_t>(from - low)] : 0;
  }
};

// From the last row down: F(r, n, up) is the row's misfit and the least of
//   F(r + 1, n', up), n' >= n;   F(r + 8, n, down) and the misfit of n in the rows between;
//   F(r + 1, n', down), n' < n, and one change undone.
// F(r, n, down) alike. Time and memory: rows times the counts that a row may have.
class LastingSearch {
 public:
  explicit LastingSearch(std::span<const double> ideals) : ideals_(ideals), rows_(ideals.size()) {
    for (std::size_t row = rows_.size(); row-- > 0;) weigh_row(row);
  }

  [[nodiscard]] std::vector<std::int32_t> counts() const {
    std::vector<std::int32_t> all;
    NextCount at = first();
    while (all.size() < rows_.size()) {
      while (all.size() <= at.row) all.push_back(at.count);
      const CountsOfRow& row = rows_[at.row];
      at = row.next[slot_of(at.heading)][static_cast<std::size_t>(at.count - row.low)];
    }
    return all;
  }

 private:
  void weigh_row(std::size_t row) {
    CountsOfRow& here = rows_[row];
    const double ideal = ideals_[row];
    const std::int32_t nearest = nearest_count(ideal);
    const auto whole = [](double stitches) { return static_cast<std::int32_t>(std::min(stitches, 2e6)); };
    here.low = std::min(nearest, std::max(3, whole(std::ceil((1.0 - lasting_tolerance) * ideal - tie))));
    here.high = std::max(nearest, whole(std::floor((1.0 + lasting_tolerance) * ideal + tie)));
    for (std::int32_t count = here.low; count <= here.high; ++count)
      here.misfits.push_back(misfit_of(ideal, count));
    for (const Heading heading : headings) {
      for (std::int32_t count = here.low; count <= here.high; ++count) weigh(row, count, heading);
      rank(here, heading);
    }
  }

  void weigh(std::size_t row, std::int32_t count, Heading heading) {
    CountCost best{0, 0.0};
    NextCount then{row + 1, count, heading};
    if (row + 1 < rows_.size()) {
      best = {};
      const CountsOfRow& above = rows_[row + 1];
      const auto take = [&](const CountCost& cost, const NextCount& next) {
        if (is_better(cost, best)) std::tie(best, then) = std::tuple(cost, next);
      };
      if (const std::int32_t on = above.best_towards(count, heading); on > 0)
        take(above.cost(on, heading), {row + 1, on, heading});
      take(turned(row, count, heading), {row + lasting_rounds, count, turned_from(heading)});
      const std::int32_t back = count + (heading == Heading::up ? -1 : 1);
      if (const std::int32_t on = above.best_towards(back, turned_from(heading)); on > 0) {
        CountCost undone = above.cost(on, turned_from(heading));
        ++undone.undone;
        take(undone, {row + 1, on, turned_from(heading)});
      }
    }
    best.misfit += rows_[row].misfit(count);
    rows_[row].costs[slot_of(heading)].push_back(best);
    rows_[row].next[slot_of(heading)].push_back(then);
  }

  // With the count kept for eight rounds; infinite where one of them cannot have it.
  [[nodiscard]] CountCost turned(std::size_t row, std::int32_t count, Heading heading) const {
    const std::size_t last = row + lasting_rounds;
    if (last >= rows_.size() || !rows_[last].has(count)) return {};
    CountCost cost = rows_[last].cost(count, turned_from(heading));
    for (std::size_t kept = row + 1; kept < last; ++kept) {
      if (!rows_[kept].has(count)) return {};
      cost.misfit += rows_[kept].misfit(count);
    }
    return cost;
  }

  static void rank(CountsOfRow& row, Heading heading) {
    std::vector<std::int32_t>& best = row.best_from[slot_of(heading)];
    best.resize(static_cast<std::size_t>(row.high - row.low) + 1);
    const std::int32_t step = heading == Heading::up ? 1 : -1;
    std::int32_t count = heading == Heading::up ? row.high : row.low;
    for (std::int32_t last = 0; row.has(count); count -= step) {
      const bool ahead = last > 0 && is_better(row.cost(last, heading), row.cost(count, heading));
      if (!ahead) last = count;
      best[static_cast<std::size_t>(count - row.low)] = last;
    }
  }

  [[nodiscard]] NextCount first() const {
    const CountsOfRow& row = rows_.front();
    CountCost best;
    NextCount found;
    for (const Heading heading : headings) {
      for (std::int32_t count = row.low; count <= row.high; ++count) {
        if (!is_better(row.cost(count, heading), best)) continue;
        best = row.cost(count, heading);
        found = {0, count, heading};
      }
    }
    return found;
  }

  std::span<const double> ideals_;
  std::vector<CountsOfRow> rows_;
};

}  // namespace

std::int32_t nearest_count(double ideal) {
  const auto whole = static_cast<std::int32_t>(std::clamp(rounded(ideal), 3.0, 1e6));
  std::int32_t best = whole;
  for (const std::int32_t count : {whole - 1, whole + 1}) {
    if (count >= 3 && clearly_less(misfit_of(ideal, count), misfit_of(ideal, best), 1.0)) best = count;
  }
  return best;
}

double misfit_of(double ideal, std::int32_t count) {
  const double off = ideal / count - 1.0;
  return count * off * off;
}

bool is_undone(std::span<const std::int32_t> counts, std::size_t level) {
  if (level == 0 || counts[level] == counts[level - 1]) return false;
  const bool rises = counts[level] > counts[level - 1];
  const std::size_t end = std::min(counts.size(), level + lasting_rounds + 1);
  for (std::size_t above = level + 1; above < end; ++above) {
    if (rises ? counts[above] < counts[above - 1] : counts[above] > counts[above - 1]) return true;
  }
  return false;
}

std::vector<std::int32_t> lasting_counts(std::span<const double> ideals) {
  std::vector<std::int32_t> counts;
  for (const double ideal : ideals) counts.push_back(nearest_count(ideal));
  bool any = false;
  for (std::size_t row = 0; row < counts.size() && !any; ++row) any = is_undone(counts, row);
  return any ? LastingSearch(ideals).counts() : counts;
}

}  // namespace knit
