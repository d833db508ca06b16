#include "knit/rows/follow.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "knit/fabric/edges.h"
#include "knit/model/ties.h"

namespace knit {

namespace {

constexpr double unreachable = std::numeric_limits<double>::infinity();

double square_between(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = a - b;
  return glm::dot(d, d);
}

double squared_round(std::span<const glm::dvec3> round) {
  double sum = square_between(round.back(), round.front());
  for (std::size_t i = 1; i < round.size(); ++i) sum += square_between(round[i - 1], round[i]);
  return sum;
}

// Two rounds that begin together; keeps its tables from turn to turn.
class TurnMatcher {
 public:
  TurnMatcher(std::span<const glm::dvec3> below, std::span<const glm::dvec3> above)
      : below_(below),
        above_(above),
        grows_(above.size() >= below.size()),
        stitches_(std::min(below.size(), above.size())),
        doublings_(std::max(below.size(), above.size()) - stitches_),
        scale_(squared_round(grows_ ? above : below)) {}

  // Of the best matching with stitch `turn` of the row on the first live stitch.
  double cost_of(std::size_t turn) {
    const std::size_t width = doublings_ + 1;
    cost_.assign(width, unreachable);
    took_.assign(stitches_ * width, 0);
    cost_[0] = distance(0, 0, turn);
    if (doublings_ > 0) {
      cost_[1] = cost_[0] + distance(0, 1, turn);
      took_[1] = 1;
    }
    for (std::size_t j = 1; j < stitches_; ++j) add_stitch(j, turn);
    return cost_[doublings_];
  }

  // Of the last cost_of().
  [[nodiscard]] std::vector<std::int32_t> links() const {
    std::vector<std::int32_t> link(stitches_ + doublings_);
    std::size_t cell = link.size(), k = doublings_;
    for (std::size_t j = stitches_; j-- > 0;) {
      link[--cell] = static_cast<std::int32_t>(j);
      if (took_[j * (doublings_ + 1) + k] == 0) continue;
      link[--cell] = static_cast<std::int32_t>(j);
      --k;
    }
    return link;
  }
  [[nodiscard]] double scale() const { return scale_; }

 private:
  // cost(., k) of stitch j from that of j - 1: with k doublings before it and none at it, or k - 1 and one at it.
  void add_stitch(std::size_t j, std::size_t turn) {
    next_.assign(doublings_ + 1, unreachable);
    const std::size_t most = std::min(doublings_, j);
    for (std::size_t k = 0; k <= most; ++k) {
      if (cost_[k] == unreachable) continue;
      const double one = cost_[k] + distance(j, j + k, turn);
      if (clearly_less(one, next_[k], scale_)) {
        next_[k] = one;
        took_[j * (doublings_ + 1) + k] = 0;
      }
      if (k == doublings_) continue;
      next_[k + 1] = one + distance(j, j + k + 1, turn);
      took_[j * (doublings_ + 1) + k + 1] = 1;
    }
    std::swap(cost_, next_);
  }

  [[nodiscard]] double distance(std::size_t small, std::size_t cell, std::size_t turn) const {
    const std::size_t on_row = (grows_ ? cell : small) + turn;
    const glm::dvec3& row = above_[on_row < above_.size() ? on_row : on_row - above_.size()];
    return square_between(row, below_[grows_ ? small : cell]);
  }

  std::span<const glm::dvec3> below_, above_;
  bool grows_;
  std::size_t stitches_, doublings_;
  double scale_;
  std::vector<double> cost_, next_;
  std::vector<std::uint8_t> took_;
};

std::vector<glm::dvec3> set_down(const Ring& curve, std::int32_t count, double start) {
  std::vector<glm::dvec3> places;
  places.reserve(static_cast<std::size_t>(count));
  for (std::int32_t i = 0; i < count; ++i)
    places.push_back(point_at(curve, start + curve.length * i / count));
  return places;
}

// By how much the stitches below stand further along the row than those that hang on them, on the mean.
double mean_offset(std::span<const glm::dvec3> below, std::span<const glm::dvec3> above,
                   const RoundMatch& match) {
  const bool grows = above.size() >= below.size();
  const std::size_t n = above.size();
  double sum = 0.0;
  for (std::size_t cell = 0; cell < match.link.size(); ++cell) {
    const auto on = static_cast<std::size_t>(match.link[cell]);
    const std::size_t stitch = ((grows ? cell : on) + static_cast<std::size_t>(match.turn)) % n;
    const glm::dvec3 along = above[(stitch + 1) % n] - above[(stitch + n - 1) % n];
    const double length = glm::length(along);
    if (length > 0.0) sum += glm::dot(below[grows ? on : cell] - above[stitch], along) / length;
  }
  return sum / static_cast<double>(match.link.size());
}

// A wider window finds nothing else on sound curves and costs its share.
constexpr std::int32_t most_turns = 12;
constexpr std::int32_t most_turns_tried = 96;  // where any will do

}  // namespace

RoundMatch match_round(std::span<const glm::dvec3> below, std::span<const glm::dvec3> above,
                       std::int32_t turns) {
  const auto n = static_cast<std::int32_t>(above.size());
  TurnMatcher matcher(below, above);
  RoundMatch best{0, unreachable, {}};
  const auto try_turns = [&](std::int32_t first, std::int32_t last, std::int32_t step) {
    for (std::int32_t turn = first; turn <= last; turn += step) {
      const std::int32_t at = ((turn % n) + n) % n;
      const double cost = matcher.cost_of(static_cast<std::size_t>(at));
      if (clearly_less(cost, best.sum_of_squares, matcher.scale())) best = {at, cost, matcher.links()};
    }
  };
  if (2 * turns < n) {
    try_turns(-turns, turns, 1);
    return best;
  }
  // Any turn. Of long rounds every few first, then those between about the best of them.
  const std::int32_t stride = (n + most_turns_tried - 1) / most_turns_tried;
  try_turns(0, n - 1, stride);
  const std::int32_t near = best.turn;
  if (stride > 1) try_turns(near - stride + 1, near + stride - 1, 1);
  return best;
}

BegunRound follow_wale(const Ring& curve, std::int32_t count, std::span<const Stitch> below, bool free) {
  std::vector<glm::dvec3> live;
  live.reserve(below.size());
  for (const Stitch& stitch : below) live.push_back(stitch.position);
  constexpr std::int32_t passes = 3;
  const std::int32_t window = free ? count : std::clamp(count / 8, std::int32_t{3}, most_turns);
  double start = nearest_arc(curve, live.front());
  const double first = start;
  BegunRound best{0.0, 0.0, unreachable, 0};
  for (std::int32_t pass = 0; pass < passes; ++pass) {
    const std::vector<glm::dvec3> row = set_down(curve, count, start);
    const RoundMatch match = match_round(live, row, pass == 0 || free ? window : 2);
    if (!clearly_less(match.sum_of_squares, best.sum_of_squares, curve.length * curve.length / count)) break;
    best = {start + curve.length * match.turn / count, start - first, match.sum_of_squares, pass + 1};
    start += mean_offset(live, row, match);
  }
  best.arc = std::fmod(best.arc, curve.length);
  if (best.arc < 0.0) best.arc += curve.length;
  return best;
}

double arc_towards(const Ring& curve, const RowFrame& frame, const std::optional<glm::dvec3>& below) {
  const glm::dvec3 centre = centre_of(curve);
  std::optional<double> best;
  double best_rank = 0.0;
  std::size_t farthest = 0;
  for (const auto& [i, next] : Edges(curve.points.size(), true)) {
    const glm::dvec3 a = curve.points[i] - centre, b = curve.points[next] - centre;
    if (clearly_less(glm::dot(curve.points[farthest] - centre, frame.right), glm::dot(a, frame.right),
                     glm::length(a)))
      farthest = i;
    const double from = glm::dot(a, frame.ahead), to = glm::dot(b, frame.ahead);
    if ((from < 0.0) == (to < 0.0)) continue;
    const double share = from / (from - to);
    const glm::dvec3 place = a + share * (b - a);
    const double out = glm::dot(place, frame.right);
    if (out <= 0.0) continue;
    const double rank = below ? glm::distance(centre + place, *below) : -out;
    if (best && !clearly_less(rank, best_rank, out)) continue;
    best = curve.arc[i] + share * glm::length(b - a);
    best_rank = rank;
  }
  return best.value_or(curve.arc[farthest]);
}

Ring begun_at(const Ring& curve, double arc) {
  Ring begun;
  begun.ordered_by = curve.ordered_by;
  const std::size_t n = curve.points.size();
  const auto after = std::upper_bound(curve.arc.begin(), curve.arc.end(), arc);
  auto next = static_cast<std::size_t>(after - curve.arc.begin());
  // A corner that the round begins at is there once.
  const double least = 1e-12 * curve.length;
  const bool at_last = next > 0 && arc - curve.arc[next - 1] <= least;
  const bool at_next = !at_last && (next < n ? curve.arc[next] : curve.length) - arc <= least;
  begun.points.push_back(at_last   ? curve.points[next - 1]
                         : at_next ? curve.points[next % n]
                                   : point_at(curve, arc));
  if (at_next) ++next;
  const std::size_t more = at_last || at_next ? n - 1 : n;
  for (std::size_t i = 0; i < more; ++i) begun.points.push_back(curve.points[(next + i) % n]);
  measure_arcs(begun);
  return begun;
}

}  // namespace knit
