#include "knit/short_rows/arcs.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>

#include "knit/mesh/elementary.h"
#include "knit/model/ties.h"

namespace knit {

namespace {

constexpr std::int32_t most_pairs = 8;  // of a gap
constexpr std::int32_t look_back = 4;   // gaps
constexpr double free_lag = 1.0;        // rows that may be missing
constexpr double turn_penalty = 2.0;
constexpr double left_over = 3.0;   // stitches of the round beside an arc
constexpr double far_apart = 26.0;  // squared turn steps; exp(-26) is nothing

// A gap as its arcs are weighed. Cells lie between a column and the next.
struct Gap {
  std::vector<double> lag;       // of each cell, in rows, before the pairs
  std::vector<double> width;     // of each cell, in stitches
  std::vector<double> position;  // of each column, in stitches from column 0; and the whole round
  double stitches = 0.0;         // of the round, a whole number
  std::optional<std::int32_t> mirror = {};
  [[nodiscard]] std::int32_t columns() const { return static_cast<std::int32_t>(lag.size()); }
  [[nodiscard]] std::int32_t wrapped(std::int32_t column) const {
    return (column % columns() + columns()) % columns();
  }
  [[nodiscard]] double apart(std::size_t a, std::size_t b) const {  // columns, in stitches
    const double one_way = std::abs(position[a] - position[b]);
    return std::min(one_way, position.back() - one_way);
  }
};

// Of both sides the mean, for each cell.
void make_alike(std::vector<double>& cells, std::int32_t mirror) {
  const std::vector<double> sides = cells;
  const std::size_t count = cells.size();
  for (std::size_t c = 0; c < count; ++c)
    cells[c] = 0.5 * (sides[c] + sides[(static_cast<std::size_t>(mirror) + 2 * count - 1 - c) % count]);
}

Gap measure(const TubeChart& chart, const FullRounds& rounds, double stitch_width, std::int32_t gap) {
  const auto k = static_cast<std::size_t>(gap);
  const auto count = static_cast<std::size_t>(chart.columns);
  const std::vector<double> heights = heights_at(chart, rounds.levels[k + 1]);
  const double due = (gap + 1) * rounds.spacing;
  const double middle = 0.5 * (rounds.levels[k] + rounds.levels[k + 1]);
  Gap made;
  made.position.push_back(0.0);
  for (std::size_t j = 0; j < count; ++j) {
    made.lag.push_back((0.5 * (heights[j] + heights[(j + 1) % count]) - due) / rounds.wanted);
    const auto column = static_cast<double>(j);
    made.width.push_back(
        glm::length(point_at(chart, middle, column + 1.0) - point_at(chart, middle, column)) / stitch_width);
  }
  made.mirror = chart.mirror;
  if (made.mirror) {
    make_alike(made.lag, *made.mirror);
    make_alike(made.width, *made.mirror);
  }
  for (const double width : made.width) made.position.push_back(made.position.back() + width);
  made.stitches = std::max(3.0, rounded(made.position.back()));
  return made;
}

// A turn at `column` makes turns dearer that are near: those above it and below it, both ways round, until one is far.
void add_turn(const Gap& gap, std::int32_t column, double weight, double turn_step,
              std::vector<double>& penalty) {
  const std::size_t count = penalty.size(), at = static_cast<std::size_t>(column) % count;
  const auto add = [&](std::size_t j) {
    const double steps = gap.apart(j, at) / turn_step;
    if (!(steps * steps < far_apart)) return false;
    penalty[j] += weight * exponential(-steps * steps);
    return true;
  };
  std::size_t above = at, below = at;  // the first, and the one after the last, that are not done
  while (above < count && add(above)) ++above;
  for (std::size_t j = count; j > above + 1 && add(j - 1);) --j;
  while (below > 0 && add(below - 1)) --below;
  for (std::size_t j = 0; j + 1 < below && add(j);) ++j;
}

void add_turns(const Gap& gap, const PairArc& arc, std::int32_t gap_number, double turn_step,
               std::vector<double>& penalty) {
  const double weight = turn_penalty * (1.0 - static_cast<double>(gap_number - arc.gap) / (look_back + 1));
  for (const std::int32_t turn : {arc.from, arc.to}) add_turn(gap, turn, weight, turn_step, penalty);
}

// What a turn at each column costs, for the turns that are near.
std::vector<double> penalties(const Gap& gap, const ArcSearch& search, double turn_step) {
  std::vector<double> penalty(gap.lag.size(), 0.0);
  const auto near = std::partition_point(search.arcs.begin(), search.arcs.end(), [&](const PairArc& arc) {
    return search.gap - arc.gap > look_back;
  });
  for (auto arc = near; arc != search.arcs.end(); ++arc) add_turns(gap, *arc, search.gap, turn_step, penalty);
  return penalty;
}

// How far the middle of an arc is from column 0, in half columns.
std::int32_t off_middle(const PairArc& arc, std::int32_t columns) {
  const std::int32_t middle = (arc.from + arc.to) % (2 * columns);
  return std::min(middle, 2 * columns - middle);
}

// Whether `a` goes before `b`, that gains as much.
bool by_rule(const PairArc& a, const PairArc& b, std::int32_t columns) {
  const std::int32_t off_a = off_middle(a, columns), off_b = off_middle(b, columns);
  if (off_a != off_b) return off_a < off_b;
  if (a.to - a.from != b.to - b.from) return a.to - a.from < b.to - b.from;
  return (a.from + a.to) % (2 * columns) < (b.from + b.to) % (2 * columns);
}

// The mirror image.
PairArc image_of(const PairArc& arc, const Gap& gap) {
  PairArc image = arc;
  image.from = gap.wrapped(*gap.mirror - arc.to);
  image.to = image.from + (arc.to - arc.from);
  return image;
}

bool is_own_image(const PairArc& arc, const Gap& gap) {
  return gap.wrapped(arc.from + arc.to - *gap.mirror) == 0;
}

// Across the mirror as far to both sides, or clear of its own image.
bool may_be_mirrored(const PairArc& arc, const Gap& gap) {
  const std::int32_t off = gap.wrapped(arc.from + arc.to - *gap.mirror);  // from the image
  return off == 0 || std::min(off, gap.columns() - off) >= arc.to - arc.from;
}

// What the turns of an arc and of its image cost each other, a half.
double half_price_of_image(const PairArc& arc, const Gap& gap, double turn_step) {
  const PairArc image = image_of(arc, gap);
  double price = 0.0;
  for (const std::int32_t turn : {arc.from, arc.to}) {
    for (const std::int32_t other : {image.from, image.to}) {
      const double steps = gap.apart(static_cast<std::size_t>(gap.wrapped(turn)),
                                     static_cast<std::size_t>(gap.wrapped(other))) /
                           turn_step;
      if (steps * steps < far_apart) price += 0.5 * turn_penalty * exponential(-steps * steps);
    }
  }
  return price;
}

// The image of the last arc, if it is still to come.
std::optional<PairArc> image_due(const Gap& gap, const ArcSearch& search) {
  if (!gap.mirror) return std::nullopt;
  const auto one_sided = std::count_if(search.arcs.begin(), search.arcs.end(), [&](const PairArc& arc) {
    return arc.gap == search.gap && !is_own_image(arc, gap);
  });
  if (one_sided % 2 == 0) return std::nullopt;
  return image_of(search.arcs.back(), gap);
}

// The best arc of a gap; none where no arc is as long, or as short, as it must be.
PairArc best_arc(const Gap& gap, std::span<const double> penalty, const ArcSearch& search,
                 const PairSettings& settings) {
  const auto columns = static_cast<std::int32_t>(gap.lag.size());
  const std::size_t count = gap.lag.size();
  std::vector<double> gains{0.0}, arcs{0.0};
  for (std::size_t i = 0; i < 2 * count; ++i) {
    const std::size_t c = i % count;
    gains.push_back(gains.back() + (gap.lag[c] - 2.0 * search.covered[c] - free_lag) * gap.width[c]);
    arcs.push_back(arcs.back() + gap.width[c]);
  }
  const double scale = gap.stitches;
  PairArc best{search.gap, 0, 0, 0.0, 0.0, 0.0};
  bool found = false;
  for (std::int32_t from = 0; from < columns; ++from) {
    for (std::int32_t to = from + 1; to < from + columns; ++to) {
      const auto b = static_cast<std::size_t>(from), a = static_cast<std::size_t>(to);
      const double length = arcs[a] - arcs[b];
      if (length < static_cast<double>(settings.shortest) - tie || length > gap.stitches - left_over + tie)
        continue;
      PairArc arc{
          search.gap, from, to, gains[a] - gains[b], settings.turn_cost + penalty[b] + penalty[a % count],
          0.0};
      // What may be added only makes it dearer.
      if (found && clearly_less(arc.gain - arc.price, best.gain - best.price, scale)) continue;
      if (gap.mirror && !may_be_mirrored(arc, gap)) continue;
      if (gap.mirror && !is_own_image(arc, gap) && clearly_less(arc.price, arc.gain, scale))
        arc.price += half_price_of_image(arc, gap, settings.turn_step);
      const double net = arc.gain - arc.price, net_of_best = best.gain - best.price;
      if (!found || clearly_less(net_of_best, net, scale) ||
          (!clearly_less(net, net_of_best, scale) && by_rule(arc, best, columns))) {
        best = arc;
        found = true;
      }
    }
  }
  for (std::int32_t c = best.from; c < best.to; ++c) {
    const std::size_t cell = static_cast<std::size_t>(c) % count;
    best.lag = std::max(best.lag, gap.lag[cell] - 2.0 * search.covered[cell]);
  }
  return best;
}

void close_gap(const Gap& gap, const FullRounds& rounds, ArcSearch& search) {
  for (std::size_t c = 0; c < gap.lag.size(); ++c)
    search.greatest_lag = std::max(search.greatest_lag, std::abs(gap.lag[c] - 2.0 * search.covered[c]));
  search.measured = false;
  ++search.gap;
  search.done = search.gap >= rounds.gaps();
}

LagMeasured measure_lag(const Gap& gap, ArcSearch& search) {
  search.measured = true;
  LagMeasured lag{search.gap, 0, -INFINITY, INFINITY};
  for (std::size_t c = 0; c < gap.lag.size(); ++c) {
    const double missing = gap.lag[c] - 2.0 * search.covered[c];
    if (missing > lag.greatest) lag.column = static_cast<std::int32_t>(c);
    lag.greatest = std::max(lag.greatest, missing);
    lag.least = std::min(lag.least, missing);
  }
  return lag;
}

// Keeps the penalties up, if the arc is taken.
ArcConsidered consider_best(const Gap& gap, const FullRounds& rounds, const PairSettings& settings,
                            std::vector<double>& penalty, ArcSearch& search) {
  const std::optional<PairArc> image = image_due(gap, search);
  const PairArc best = image ? *image : best_arc(gap, penalty, search, settings);
  const bool taken = best.to > best.from && clearly_less(best.price, best.gain, gap.stitches);
  if (taken) {
    for (std::int32_t c = best.from; c < best.to; ++c)
      ++search.covered[static_cast<std::size_t>(c) % search.covered.size()];
    search.arcs.push_back(best);
    add_turns(gap, best, search.gap, settings.turn_step, penalty);
  }
  const auto in_gap = std::count_if(search.arcs.begin(), search.arcs.end(),
                                    [&](const PairArc& arc) { return arc.gap == search.gap; });
  const ArcConsidered considered{search.gap, best.from, best.to, taken, best.gain, best.price};
  if (!taken || (in_gap >= most_pairs && !image_due(gap, search))) close_gap(gap, rounds, search);
  return considered;
}

}  // namespace

ArcStep advance_arcs(const TubeChart& chart, const FullRounds& rounds, double stitch_width,
                     const PairSettings& settings, ArcSearch& search) {
  search.covered.resize(static_cast<std::size_t>(chart.columns), 0);
  const Gap gap = measure(chart, rounds, stitch_width, search.gap);
  if (!search.measured) return measure_lag(gap, search);
  std::vector<double> penalty = penalties(gap, search, settings.turn_step);
  return consider_best(gap, rounds, settings, penalty, search);
}

ArcSearch choose_arcs(const TubeChart& chart, const FullRounds& rounds, double stitch_width,
                      const PairSettings& settings) {
  ArcSearch search;
  search.covered.resize(static_cast<std::size_t>(chart.columns), 0);
  while (!search.done) {
    const std::int32_t number = search.gap;
    const Gap gap = measure(chart, rounds, stitch_width, number);
    measure_lag(gap, search);
    std::vector<double> penalty = penalties(gap, search, settings.turn_step);
    while (search.gap == number) consider_best(gap, rounds, settings, penalty, search);
  }
  return search;
}

double middle_of_arcs(const ArcSearch& search, std::optional<std::int32_t> mirror) {
  const auto columns = static_cast<double>(search.covered.size());
  double x = 0.0, y = 0.0;
  for (std::size_t c = 0; c < search.covered.size(); ++c) {
    const double angle = 2.0 * std::numbers::pi * (static_cast<double>(c) + 0.5) / columns;
    x += search.covered[c] * cosine(angle);
    y += search.covered[c] * sine(angle);
  }
  double middle = 0.0;
  if (hypotenuse(x, y) >= tie * columns) {
    const double turn = angle_to(x, std::abs(y)) / (2.0 * std::numbers::pi);
    middle = (y < 0.0 ? -turn : turn) * columns;
  }
  if (!mirror || search.arcs.empty()) return middle;
  // The nearest column on the mirror.
  const double half = 0.5 * columns, on_mirror = 0.5 * *mirror;
  const double nearest = on_mirror + half * rounded((middle - on_mirror) / half);
  return nearest > half - tie ? nearest - columns : nearest;
}

}  // namespace knit
