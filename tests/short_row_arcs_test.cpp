// The arcs of short rows as they are looked for, against the rule as it is written.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <tuple>
#include <variant>
#include <vector>

#include "knit/mesh/elementary.h"
#include "knit/model/ties.h"
#include "knit/short_rows/arcs.h"
#include "knit/short_rows/chart_mirror.h"
#include "tests/support/catch.h"
#include "tests/support/hand_chart.h"
#include "tests/support/repeated.h"
#include "tests/support/rough_sphere.h"

using namespace knit;
using namespace test_support;

namespace {

// The rule as it is written above arcs.h, without a short cut: each turn makes every column dearer, each arc is weighed whole.
class PlainArcs {
 public:
  PlainArcs(const TubeChart& chart, const FullRounds& rounds, const ArcSearch& search,
            const PairSettings& settings)
      : search_(search), settings_(settings), mirror_(chart.mirror), count_(chart.columns) {
    const auto k = static_cast<std::size_t>(search.gap);
    const std::vector<double> heights = heights_at(chart, rounds.levels[k + 1]);
    const double middle = 0.5 * (rounds.levels[k] + rounds.levels[k + 1]);
    for (std::size_t j = 0; j < size(); ++j) {
      const auto column = static_cast<double>(j);
      lag_.push_back((0.5 * (heights[j] + heights[(j + 1) % size()]) - (search.gap + 1) * rounds.spacing) /
                     rounds.wanted);
      width_.push_back(glm::length(point_at(chart, middle, column + 1.0) - point_at(chart, middle, column)));
    }
    if (mirror_) {
      for (std::vector<double>* cells : {&lag_, &width_}) {
        const std::vector<double> sides = *cells;
        for (std::size_t c = 0; c < size(); ++c)
          (*cells)[c] =
              0.5 * (sides[c] + sides[(static_cast<std::size_t>(*mirror_) + 2 * size() - 1 - c) % size()]);
      }
    }
    for (const double width : width_) position_.push_back(position_.back() + width);
    stitches_ = std::max(3.0, rounded(position_.back()));
  }

  [[nodiscard]] PairArc best() const {
    std::vector<double> gains{0.0}, arcs{0.0}, penalty(size(), 0.0);
    for (std::size_t i = 0; i < 2 * size(); ++i) {
      const std::size_t c = i % size();
      gains.push_back(gains.back() + (lag_[c] - 2.0 * search_.covered[c] - 1.0) * width_[c]);
      arcs.push_back(arcs.back() + width_[c]);
    }
    for (const PairArc& arc : search_.arcs) {
      const std::int32_t age = search_.gap - arc.gap;
      if (age > 4) continue;
      for (const std::int32_t turn : {arc.from, arc.to})
        for (std::int32_t j = 0; j < count_; ++j)
          penalty[static_cast<std::size_t>(j)] += 2.0 * (1.0 - age / 5.0) * closeness(j, turn);
    }
    std::optional<PairArc> found;
    for (std::int32_t from = 0; from < count_; ++from) {
      for (std::int32_t to = from + 1; to < from + count_; ++to) {
        const auto b = static_cast<std::size_t>(from), a = static_cast<std::size_t>(to);
        const double length = arcs[a] - arcs[b];
        if (length < settings_.shortest - tie || length > stitches_ - 3.0 + tie) continue;
        PairArc arc{search_.gap,
                    from,
                    to,
                    gains[a] - gains[b],
                    settings_.turn_cost + penalty[b] + penalty[a % size()],
                    0.0};
        if (mirror_ && !add_image(arc)) continue;
        if (!found || before(arc, *found)) found = arc;
      }
    }
    return found.value_or(PairArc{search_.gap, 0, 0, 0.0, 0.0, 0.0});
  }

 private:
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(count_); }
  [[nodiscard]] std::int32_t wrapped(std::int32_t column) const {
    return (column % count_ + count_) % count_;
  }
  [[nodiscard]] double closeness(std::int32_t one, std::int32_t other) const {
    const double way = std::abs(position_[static_cast<std::size_t>(wrapped(one))] -
                                position_[static_cast<std::size_t>(wrapped(other))]);
    const double steps = std::min(way, position_.back() - way) / settings_.turn_step;
    return steps * steps < 26.0 ? exponential(-steps * steps) : 0.0;
  }
  // False: it may not stand beside its image.
  [[nodiscard]] bool add_image(PairArc& arc) const {
    const std::int32_t off = wrapped(arc.from + arc.to - *mirror_);
    if (off == 0) return true;
    if (std::min(off, count_ - off) < arc.to - arc.from) return false;
    const std::int32_t from = wrapped(*mirror_ - arc.to), to = from + arc.to - arc.from;
    double half = 0.0;
    for (const std::int32_t turn : {arc.from, arc.to})
      for (const std::int32_t other : {from, to}) half += 0.5 * 2.0 * closeness(turn, other);
    if (clearly_less(arc.price, arc.gain, stitches_)) arc.price += half;
    return true;
  }
  [[nodiscard]] bool before(const PairArc& a, const PairArc& b) const {
    const double net = a.gain - a.price, other = b.gain - b.price;
    if (clearly_less(other, net, stitches_) || clearly_less(net, other, stitches_)) return net > other;
    const auto rank = [&](const PairArc& arc) {
      const std::int32_t middle = (arc.from + arc.to) % (2 * count_);
      return std::tuple(std::min(middle, 2 * count_ - middle), arc.to - arc.from, middle);
    };
    return rank(a) < rank(b);
  }

  const ArcSearch& search_;
  const PairSettings& settings_;
  std::optional<std::int32_t> mirror_;
  std::int32_t count_;
  std::vector<double> lag_, width_, position_{0.0};
  double stitches_ = 0.0;
};

// Steps through all gaps; how many arcs were weighed by the plain rule too, all but images.
std::size_t check_against_plain(const TubeChart& chart, const PairSettings& settings) {
  const FullRounds rounds = full_rounds(chart, 1.0);
  ArcSearch search;
  std::size_t weighed = 0, one_sided = 0;
  while (!search.done) {
    const ArcSearch before = search;
    const ArcStep step = advance_arcs(chart, rounds, 1.0, settings, search);
    const auto* considered = std::get_if<ArcConsidered>(&step);
    if (considered == nullptr) {
      one_sided = 0;
      continue;
    }
    if (one_sided % 2 == 0) {
      const PairArc plain = PlainArcs(chart, rounds, before, settings).best();
      CHECK(considered->from == plain.from);
      CHECK(considered->to == plain.to);
      CHECK(considered->gain == plain.gain);
      CHECK(considered->price == plain.price);
      ++weighed;
    }
    const std::int32_t columns = chart.columns;
    if (chart.mirror && considered->taken &&
        (considered->from + considered->to - *chart.mirror + 2 * columns) % columns != 0)
      ++one_sided;
  }
  CHECK(search == choose_arcs(chart, rounds, 1.0, settings));
  return weighed;
}

}  // namespace

TEST_CASE(
    "short rows: looking at near columns and at arcs that can win comes to the plain rule, to the bit") {
  Dice dice(9);
  std::size_t weighed = 0;
  for (int run = 0; run < repeated(12); ++run) {
    const auto count = 24 + dice.below(60);
    std::vector<double> ends;
    const double tall = dice.between(1.0, 6.0), off = dice.between(0.0, 40.0);
    const double waves = run % 3 == 0 ? 2.0 : 1.0;
    for (std::size_t j = 0; j < count; ++j)
      ends.push_back(14.0 -
                     tall * std::cos(2.0 * std::numbers::pi * waves * (static_cast<double>(j) - off) /
                                     static_cast<double>(count)) +
                     (run % 2 == 0 ? 0.0 : dice.between(0.0, 0.5)));
    TubeChart chart = hand_chart(ends, 113);
    if (run % 2 == 0) chart.mirror = mirror_of(chart, 1.0);
    weighed += check_against_plain(chart, {dice.between(0.0, 5.0), dice.between(1.0, 6.0), 4});
  }
  CHECK(weighed > static_cast<std::size_t>(repeated(12)) * 12);
}
