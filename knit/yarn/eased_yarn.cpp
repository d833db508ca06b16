#include "knit/yarn/eased_yarn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

namespace knit {

namespace {

constexpr std::size_t places_a_point = 2;
constexpr double farther = 1.2;  // than to the mean
constexpr double length_weight = 1.0, bending_weight = 0.25, contact_weight = 2.0, home_weight = 0.02;
constexpr double near_along = 0.75;  // in stitch widths: what lies so near along the yarn never touches
constexpr double reach = 1.15;       // of a diameter: how near pairs are looked for
constexpr int pairs_last = 10;       // iterations

using Cell = std::array<std::int32_t, 3>;

class Easing {
 public:
  Easing(const Yarn& yarn, double stitch_width)
      : diameter_(2.0 * yarn.curves.front().radius), apart_(near_along * stitch_width) {
    double along = 0.0;
    for (const YarnCurve& curve : yarn.curves) {
      const std::vector<glm::dvec3> places = sampled(curve, places_a_point);
      along += apart_;  // of another yarn
      for (std::size_t i = 0; i < places.size(); ++i) {
        rest_.push_back(i > 0 ? glm::distance(places[i - 1], places[i]) : -1.0);
        along += std::max(rest_.back(), 0.0);
        along_.push_back(along);
      }
      places_.insert(places_.end(), places.begin(), places.end());
      along += apart_;
    }
    home_ = places_;
  }

  void run(int iterations) {
    for (int i = 0; i < iterations; ++i) {
      if (i % pairs_last == 0) find_pairs();
      iterate();
    }
  }
  [[nodiscard]] const std::vector<glm::dvec3>& places() const { return places_; }

 private:
  struct Pull {
    glm::dvec3 by{0.0};
    double weight = 0.0;
    void add(const glm::dvec3& way, double of_weight) {
      by += of_weight * way;
      weight += of_weight;
    }
  };

  void iterate() {
    std::vector<Pull> pulls(places_.size());
    for (std::size_t i = 1; i < places_.size(); ++i) {
      if (rest_[i] < 0.0) continue;
      move_apart(pulls, i - 1, i, rest_[i], length_weight);
      if (i + 1 < places_.size() && rest_[i + 1] >= 0.0)
        pulls[i].add(0.5 * (0.5 * (places_[i - 1] + places_[i + 1]) - places_[i]), bending_weight);
    }
    for (const auto& [a, b] : pairs_) {
      if (glm::distance(places_[a], places_[b]) < diameter_)
        move_apart(pulls, a, b, diameter_, contact_weight);
    }
    for (std::size_t i = 0; i < places_.size(); ++i) {
      pulls[i].add(home_[i] - places_[i], home_weight);
      places_[i] += farther / pulls[i].weight * pulls[i].by;
    }
  }

  // To `asked` between them, each by half. Points in one place stay: there is no way apart.
  void move_apart(std::vector<Pull>& pulls, std::size_t a, std::size_t b, double asked, double weight) const {
    const glm::dvec3 way = places_[b] - places_[a];
    const double now = glm::length(way);
    if (!(now > 0.0)) return;
    const glm::dvec3 by = 0.5 * (1.0 - asked / now) * way;
    pulls[a].add(by, weight);
    pulls[b].add(-by, weight);
  }

  [[nodiscard]] Cell cell_of(const glm::dvec3& place, const glm::dvec3& low) const {
    Cell cell{};
    for (int axis = 0; axis < 3; ++axis)
      cell[static_cast<std::size_t>(axis)] =
          static_cast<std::int32_t>(std::min((place[axis] - low[axis]) / (reach * diameter_), 1e9));
    return cell;
  }

  // In order of the first of a pair, then of cells.
  void find_pairs() {
    glm::dvec3 low = places_.front();
    for (const glm::dvec3& place : places_) low = glm::min(low, place);
    std::vector<std::pair<Cell, std::size_t>> by_cell;
    for (std::size_t i = 0; i < places_.size(); ++i) by_cell.emplace_back(cell_of(places_[i], low), i);
    std::sort(by_cell.begin(), by_cell.end());
    pairs_.clear();
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Cell cell = cell_of(places_[i], low);
      for (std::int32_t x = cell[0] - 1; x <= cell[0] + 1; ++x) {
        for (std::int32_t y = cell[1] - 1; y <= cell[1] + 1; ++y) add_pairs(i, {x, y, cell[2]}, by_cell);
      }
    }
  }
  // With what lies in three cells of a column.
  void add_pairs(std::size_t i, const Cell& middle,
                 const std::vector<std::pair<Cell, std::size_t>>& by_cell) {
    const Cell first{middle[0], middle[1], middle[2] - 1}, last{middle[0], middle[1], middle[2] + 1};
    auto at = std::lower_bound(by_cell.begin(), by_cell.end(), std::pair<Cell, std::size_t>{first, 0});
    for (; at != by_cell.end() && at->first <= last; ++at) {
      const std::size_t other = at->second;
      if (other > i && along_[other] - along_[i] > apart_ &&
          glm::distance(places_[i], places_[other]) < reach * diameter_)
        pairs_.emplace_back(i, other);
    }
  }

  double diameter_, apart_;
  std::vector<glm::dvec3> places_, home_;
  std::vector<double> rest_;   // to the place before; -1 at the beginning of a yarn
  std::vector<double> along_;  // where each lies along all yarns, one behind the other
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

// A point's share of the curve half way between it and the next one of its neighbours, and of that beyond them.
constexpr double half_near = 9.0 / 16.0, half_far = -1.0 / 16.0;

// Points whose curve comes as near as can be to all places, those between two points too: least squares by ten steps of
// gradient descent.
std::vector<glm::dvec3> points_through(std::span<const glm::dvec3> places) {
  constexpr int steps = 10;
  constexpr double step = 0.6;
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < places.size(); i += places_a_point) points.push_back(places[i]);
  const std::size_t count = points.size();
  if (count < 4) return points;
  for (int round = 0; round < steps; ++round) {
    std::vector<glm::dvec3> by(count);
    for (std::size_t i = 0; i < count; ++i) by[i] = places[i * places_a_point] - points[i];
    for (std::size_t i = 1; i + 2 < count; ++i) {
      const glm::dvec3 half =
          half_near * (points[i] + points[i + 1]) + half_far * (points[i - 1] + points[i + 2]);
      const glm::dvec3 off = places[i * places_a_point + 1] - half;
      by[i - 1] += half_far * off;
      by[i] += half_near * off;
      by[i + 1] += half_near * off;
      by[i + 2] += half_far * off;
    }
    for (std::size_t i = 0; i < count; ++i) points[i] += step * by[i];
  }
  return points;
}

}  // namespace

Yarn eased_yarn(Yarn yarn, double stitch_width, int iterations) {
  if (yarn.curves.empty() || iterations <= 0) return yarn;
  Easing easing(yarn, stitch_width);
  easing.run(iterations);
  const std::span<const glm::dvec3> places = easing.places();
  std::size_t first = 0;
  for (YarnCurve& curve : yarn.curves) {
    if (curve.points.empty()) continue;
    const std::size_t count = (curve.points.size() - 1) * places_a_point + 1;
    curve.points = points_through(places.subspan(first, count));
    first += count;
  }
  return yarn;
}

}  // namespace knit
