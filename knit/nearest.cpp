#include "knit/nearest.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace knit {

namespace {

constexpr std::int32_t most_mains = 6;

double squared(const Stitch& a, const Stitch& b) {
  const glm::dvec3 d = a.position - b.position;
  return d.x * d.x + d.y * d.y + d.z * d.z;
}

std::vector<std::int32_t> mains_of(const NearestRows& rows) {
  if (!rows.mains.empty()) return {rows.mains.begin(), rows.mains.end()};
  const auto size = static_cast<std::int32_t>(rows.below.size());
  const std::int32_t count = std::min(size, most_mains);
  std::vector<std::int32_t> mains;
  mains.reserve(static_cast<std::size_t>(count));
  for (std::int32_t i = 0; i < count; ++i) mains.push_back(i * size / count);
  return mains;
}

// How many stitches of a closed row lie between a stitch and the nearest main before it, and after it.
struct MainDistance {
  std::int32_t before = 0, after = 0;
};

std::vector<MainDistance> distances_to_mains(std::span<const std::int32_t> mains, std::int32_t size) {
  std::vector<MainDistance> distances(static_cast<std::size_t>(size), {size, size});
  for (const std::int32_t main : mains) {
    distances[static_cast<std::size_t>(main)] = {0, 0};
  }
  for (std::int32_t i = 0; i < 2 * size; ++i) {
    auto& here = distances[static_cast<std::size_t>(i % size)];
    const auto& last = distances[static_cast<std::size_t>((i + size - 1) % size)];
    here.before = std::min(here.before, last.before + 1);
    auto& back = distances[static_cast<std::size_t>((2 * size - 1 - i) % size)];
    const auto& next = distances[static_cast<std::size_t>((2 * size - i) % size)];
    back.after = std::min(back.after, next.after + 1);
  }
  return distances;
}

class Matcher {
 public:
  Matcher(const NearestRows& rows, const NearestPenalties& penalties, std::span<const std::int32_t> mains)
      : rows_(rows),
        penalties_(penalties),
        grows_(rows.above.size() >= rows.below.size()),
        small_(grows_ ? rows.below : rows.above),
        big_(grows_ ? rows.above : rows.below),
        to_mains_(distances_to_mains(mains, static_cast<std::int32_t>(rows.below.size()))) {}

  // The stitches of the smaller row that get two links, rising.
  [[nodiscard]] std::vector<std::size_t> doubled() const {
    const std::size_t stitches = small_.size();
    const std::size_t doublings = big_.size() - stitches;
    const std::size_t width = doublings + 1;
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> cost(width, never);
    cost[0] = 0.0;
    std::vector<std::uint8_t> took(stitches * width, 0);
    for (std::size_t j = 0; j < stitches; ++j) {
      std::vector<double> next(width, never);
      for (std::size_t k = 0; k < width; ++k) {
        if (cost[k] == never) continue;
        const double one = cost[k] + squared(small_[j], big_[j + k]);
        if (one < next[k]) {
          next[k] = one;
          took[j * width + k] = 0;
        }
        if (k == doublings) continue;
        const double two = one + squared(small_[j], big_[j + k + 1]) + penalty(j, j + k);
        if (two < next[k + 1]) {
          next[k + 1] = two;
          took[j * width + k + 1] = 1;
        }
      }
      cost = std::move(next);
    }
    return walk_back(took, stitches, doublings);
  }

 private:
  static std::vector<std::size_t> walk_back(const std::vector<std::uint8_t>& took, std::size_t stitches,
                                            std::size_t doublings) {
    std::vector<std::size_t> found;
    std::size_t k = doublings;
    for (std::size_t j = stitches; j-- > 0;) {
      if (took[j * (doublings + 1) + k] == 0) continue;
      found.push_back(j);
      --k;
    }
    std::reverse(found.begin(), found.end());
    return found;
  }

  // For doubling stitch `j` of the smaller row over cells `cell` and `cell + 1` of the larger.
  [[nodiscard]] double penalty(std::size_t j, std::size_t cell) const {
    const std::size_t first = grows_ ? j : cell;  // stitches of the row below that take part
    const std::size_t last = grows_ ? j : cell + 1;
    double sum = 0.0;
    if (!rows_.shaped_below.empty() && (rows_.shaped_below[first] != 0 || rows_.shaped_below[last] != 0))
      sum += penalties_.stacking;
    if (penalties_.from_mains > 0.0) {
      const double away = std::min(to_mains_[first].before, to_mains_[last].after);
      sum += penalties_.from_mains * away * away;
    }
    return sum;
  }

  const NearestRows& rows_;
  const NearestPenalties& penalties_;
  bool grows_;
  std::span<const Stitch> small_, big_;
  std::vector<MainDistance> to_mains_;
};

// The shaping of cells `cell` and `cell + 1`, which share a stitch: the label stands on the one nearer to the
// nearest main and works with the other; a main itself never carries it while the other can.
void label_pair(Transition& t, std::size_t cell, bool grows, const std::vector<std::uint8_t>& is_main,
                const std::vector<MainDistance>& to_mains) {
  const Label after = grows ? Label::m1r : Label::ssk;
  const Label before = grows ? Label::m1l : Label::k2tog;
  const bool main_behind = to_mains[cell].before <= to_mains[cell + 1].after;
  std::size_t labelled = main_behind ? cell : cell + 1;
  if (is_main[cell] != 0)
    labelled = cell + 1;
  else if (is_main[cell + 1] != 0)
    labelled = cell;
  t.labels[labelled] = main_behind ? after : before;
  t.partner[labelled] = static_cast<std::int32_t>(labelled == cell ? cell + 1 : cell);
}

void link_and_label(Transition& t, const std::vector<std::size_t>& doubled,
                    std::span<const std::int32_t> mains_below, bool grows) {
  const auto cells = static_cast<std::size_t>(std::max(t.below, t.above));
  std::vector<std::uint8_t> is_double(static_cast<std::size_t>(std::min(t.below, t.above)), 0);
  for (const std::size_t j : doubled) is_double[j] = 1;
  std::vector<std::size_t> pairs;
  for (std::size_t j = 0; j < is_double.size(); ++j) {
    if (is_double[j] != 0) pairs.push_back(t.link.size());
    t.link.insert(t.link.end(), is_double[j] != 0 ? 2U : 1U, static_cast<std::int32_t>(j));
  }
  std::vector<std::uint8_t> is_main(cells, 0);
  for (const std::int32_t main : mains_below) {
    // A main goes on in the first cell that hangs on it.
    const auto cell = grows ? std::lower_bound(t.link.begin(), t.link.end(), main) - t.link.begin() : main;
    is_main[static_cast<std::size_t>(cell)] = 1;
  }
  t.labels.assign(cells, Label::knit);
  t.partner.resize(cells);
  std::vector<std::int32_t> main_cells;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    t.partner[cell] = static_cast<std::int32_t>(cell);
    if (is_main[cell] == 0) continue;
    t.labels[cell] = Label::main;
    main_cells.push_back(static_cast<std::int32_t>(cell));
  }
  const auto to_mains = distances_to_mains(main_cells, static_cast<std::int32_t>(cells));
  for (const std::size_t cell : pairs) label_pair(t, cell, grows, is_main, to_mains);
  for (const std::int32_t cell : main_cells) {
    const std::int32_t above = grows ? cell : t.link[static_cast<std::size_t>(cell)];
    if (t.mains.empty() || t.mains.back() != above) t.mains.push_back(above);
  }
}

}  // namespace

Transition plan_nearest(const NearestRows& rows, const NearestPenalties& penalties, std::int32_t row) {
  Transition t;
  t.row = row;
  t.below = static_cast<std::int32_t>(rows.below.size());
  t.above = static_cast<std::int32_t>(rows.above.size());
  t.rule = Rule::nearest;
  const bool grows = t.above >= t.below;
  const std::vector<std::int32_t> mains = mains_of(rows);
  link_and_label(t, Matcher(rows, penalties, mains).doubled(), mains, grows);
  for (const bool shaping : {false, true}) {
    for (std::size_t cell = 0; cell < t.labels.size(); ++cell) {
      if (shaping ? is_shaping(t.labels[cell]) : t.labels[cell] == Label::main)
        t.placed.push_back({static_cast<std::int32_t>(cell), t.labels[cell]});
    }
  }
  const std::span<const Stitch> small = grows ? rows.below : rows.above;
  const std::span<const Stitch> big = grows ? rows.above : rows.below;
  for (std::size_t cell = 0; cell < big.size(); ++cell) {
    const double square = squared(small[static_cast<std::size_t>(t.link[cell])], big[cell]);
    t.sum_of_squares += square;
    t.longest_square = std::max(t.longest_square, square);
  }
  return t;
}

std::vector<std::uint8_t> shaped_by(const Transition& t) {
  std::vector<std::uint8_t> shaped(static_cast<std::size_t>(t.above), 0);
  const bool grows = t.change() >= 0;
  for (std::size_t cell = 0; cell < t.labels.size(); ++cell) {
    if (!is_shaping(t.labels[cell])) continue;
    const auto partner = static_cast<std::size_t>(t.partner[cell]);
    for (const std::size_t c : {cell, partner}) shaped[grows ? c : static_cast<std::size_t>(t.link[c])] = 1;
  }
  return shaped;
}

}  // namespace knit
