#include "knit/stitches/nearest.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>

#include "knit/model/ties.h"

namespace knit {

namespace {

double squared(const Stitch& a, const Stitch& b) {
  const glm::dvec3 d = a.position - b.position;
  return d.x * d.x + d.y * d.y + d.z * d.z;
}

// Of the row's stitch to stitch lengths: what sums of squares are compared by.
double round_squares(std::span<const Stitch> row) {
  double sum = squared(row.back(), row.front());
  for (std::size_t i = 1; i < row.size(); ++i) sum += squared(row[i - 1], row[i]);
  return sum;
}

std::vector<std::int32_t> mains_of(const NearestRows& rows) {
  const auto size = static_cast<std::int32_t>(rows.below.size());
  if (!rows.mains.empty()) return {rows.mains.begin(), rows.mains.end()};
  std::int32_t count = std::min(size, most_mains);
  // The main opposite the first needs a stitch that stands there.
  if (count % 2 == 0 && size % 2 != 0) --count;
  const auto nearest_place = [&](std::int32_t i) { return (2 * i * size + count) / (2 * count); };
  std::vector<std::int32_t> mains;
  mains.reserve(static_cast<std::size_t>(count));
  for (std::int32_t i = 0; i < count; ++i)
    mains.push_back(2 * i <= count ? nearest_place(i) : size - nearest_place(count - i));
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
        scale_(round_squares(big_)),
        to_mains_(distances_to_mains(mains, static_cast<std::int32_t>(rows.below.size()))) {}

  // The stitches of the smaller row that get two links, rising.
  [[nodiscard]] std::vector<std::size_t> doubled() const {
    const std::size_t stitches = small_.size();
    const std::size_t doublings = big_.size() - stitches;
    const std::size_t width = doublings + 1;
    constexpr double never = std::numeric_limits<double>::infinity();
    if (doublings == stitches) return every(stitches);
    std::vector<double> cost(width, never);
    cost[0] = squared(small_[0], big_[0]);
    std::vector<std::uint8_t> took(stitches * width, 0);
    if (rows_.first_may_double && doublings > 0) {
      cost[1] = cost[0] + squared(small_[0], big_[1]) + penalty(0, 0);
      took[1] = 1;
    }
    for (std::size_t j = 1; j < stitches; ++j) {
      std::vector<double> next(width, never);
      for (std::size_t k = 0; k < width; ++k) {
        if (cost[k] == never) continue;
        const double one = cost[k] + squared(small_[j], big_[j + k]);
        if (clearly_less(one, next[k], scale_)) {
          next[k] = one;
          took[j * width + k] = 0;
        }
        if (k == doublings) continue;
        const double two = one + squared(small_[j], big_[j + k + 1]) + penalty(j, j + k);
        next[k + 1] = two;  // the first way there
        took[j * width + k + 1] = 1;
      }
      cost = std::move(next);
    }
    return walk_back(took, stitches, doublings);
  }

 private:
  static std::vector<std::size_t> every(std::size_t stitches) {
    std::vector<std::size_t> found(stitches);
    std::iota(found.begin(), found.end(), std::size_t{0});
    return found;
  }

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
  double scale_;
  std::vector<MainDistance> to_mains_;
};

// Gives labels to the cells of the larger row, whose links are made.
class Labeller {
 public:
  Labeller(const NearestRows& rows, Join& t)
      : t_(t),
        grows_(t.above >= t.below),
        small_(grows_ ? rows.below : rows.above),
        big_(grows_ ? rows.above : rows.below),
        is_main_(big_.size(), 0) {}

  void label(std::span<const std::int32_t> mains_below) {
    for (const std::int32_t main : mains_below) is_main_[cell_of_main(main)] = 1;
    t_.labels.assign(big_.size(), Label::knit);
    t_.partner.resize(big_.size());
    std::vector<std::int32_t> main_cells;
    for (std::size_t cell = 0; cell < big_.size(); ++cell) {
      t_.partner[cell] = static_cast<std::int32_t>(cell);
      if (is_main_[cell] == 0) continue;
      t_.labels[cell] = Label::main;
      main_cells.push_back(static_cast<std::int32_t>(cell));
    }
    const auto to_mains = distances_to_mains(main_cells, static_cast<std::int32_t>(big_.size()));
    for (std::size_t cell = 0; cell + 1 < big_.size(); ++cell)
      if (t_.link[cell] == t_.link[cell + 1]) label_pair(cell, to_mains);
    for (const std::int32_t cell : main_cells) {
      const std::int32_t above = grows_ ? cell : t_.link[static_cast<std::size_t>(cell)];
      if (t_.mains.empty() || t_.mains.back() != above) t_.mains.push_back(above);
    }
  }

 private:
  // Of two cells on one stitch: whether the first is the nearer to it.
  [[nodiscard]] bool first_is_nearer(std::size_t cell) const {
    const Stitch& shared = small_[static_cast<std::size_t>(t_.link[cell])];
    return !clearly_less(squared(shared, big_[cell + 1]), squared(shared, big_[cell]),
                         squared(big_[cell], big_[cell + 1]));
  }

  // A doubled main goes on in the nearer of its cells; where every stitch is doubled in the first, which hangs on it in
  // the mirror too.
  [[nodiscard]] std::size_t cell_of_main(std::int32_t main) const {
    if (!grows_) return static_cast<std::size_t>(main);
    const auto [first, end] = std::equal_range(t_.link.begin(), t_.link.end(), main);
    const auto cell = static_cast<std::size_t>(first - t_.link.begin());
    const bool all_doubled = big_.size() == 2 * small_.size();
    return end - first == 1 || all_doubled || first_is_nearer(cell) ? cell : cell + 1;
  }

  // The shaping of cells `cell` and `cell + 1`, which share a stitch: the label stands on the one nearer to the
  // nearest main, or to the stitch where two mains are equally near, and works with the other; a main itself never
  // carries it while the other can.
  void label_pair(std::size_t cell, const std::vector<MainDistance>& to_mains) {
    const std::int32_t behind = to_mains[cell].before, ahead = to_mains[cell + 1].after;
    const bool main_behind = behind == ahead ? first_is_nearer(cell) : behind < ahead;
    const bool on_first = main_behind ? is_main_[cell] == 0 : is_main_[cell + 1] != 0;
    const std::size_t labelled = on_first ? cell : cell + 1;
    if (grows_)
      t_.labels[labelled] = main_behind ? Label::m1r : Label::m1l;
    else
      t_.labels[labelled] = main_behind ? Label::ssk : Label::k2tog;
    t_.partner[labelled] = static_cast<std::int32_t>(on_first ? cell + 1 : cell);
  }

  Join& t_;
  bool grows_;
  std::span<const Stitch> small_, big_;
  std::vector<std::uint8_t> is_main_;
};

std::vector<std::int32_t> links_of(const std::vector<std::size_t>& doubled, std::size_t stitches) {
  std::vector<std::int32_t> link;
  auto next = doubled.begin();
  for (std::size_t j = 0; j < stitches; ++j) {
    const bool twice = next != doubled.end() && *next == j;
    if (twice) ++next;
    link.insert(link.end(), twice ? 2U : 1U, static_cast<std::int32_t>(j));
  }
  return link;
}

}  // namespace

Join plan_nearest(const NearestRows& rows, const NearestPenalties& penalties, std::int32_t row) {
  Join t;
  t.to = row;
  t.below = static_cast<std::int32_t>(rows.below.size());
  t.above = static_cast<std::int32_t>(rows.above.size());
  t.rule = Rule::nearest;
  const bool grows = t.above >= t.below;
  const std::vector<std::int32_t> mains = mains_of(rows);
  t.link =
      links_of(Matcher(rows, penalties, mains).doubled(), std::min(rows.below.size(), rows.above.size()));
  Labeller(rows, t).label(mains);
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

std::vector<std::int32_t> thinned_mains(std::span<const std::int32_t> mains, std::int32_t size) {
  if (mains.size() <= most_mains) return {mains.begin(), mains.end()};
  std::vector<std::int32_t> kept;
  std::size_t next = 0;
  for (std::int32_t i = 0; i < most_mains; ++i) {
    const std::size_t last =
        mains.size() - static_cast<std::size_t>(most_mains - i);  // leaves enough for the others
    std::size_t best = next;
    for (std::size_t main = next; main <= last; ++main) {
      const auto away = [&](std::size_t m) { return std::abs(most_mains * mains[m] - i * size); };
      if (away(main) < away(best)) best = main;
    }
    kept.push_back(mains[best]);
    next = best + 1;
  }
  return kept;
}

std::vector<std::uint8_t> shaped_by(const Join& join) {
  std::vector<std::uint8_t> shaped(static_cast<std::size_t>(join.above), 0);
  const bool grows = join.change() >= 0;
  for (std::size_t cell = 0; cell < join.labels.size(); ++cell) {
    if (!is_shaping(join.labels[cell])) continue;
    const auto partner = static_cast<std::size_t>(join.partner[cell]);
    for (const std::size_t c : {cell, partner})
      shaped[grows ? c : static_cast<std::size_t>(join.link[c])] = 1;
  }
  return shaped;
}

}  // namespace knit
