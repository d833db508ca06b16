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

// How far the wales are from being `height` long: the sum of the squares.
double off_height(std::span<const glm::dvec3> below, std::span<const glm::dvec3> above,
                  const RoundMatch& match, double height) {
  const bool grows = above.size() >= below.size();
  double sum = 0.0;
  for (std::size_t cell = 0; cell < match.link.size(); ++cell) {
    const auto on = static_cast<std::size_t>(match.link[cell]);
    const std::size_t stitch = ((grows ? cell : on) + static_cast<std::size_t>(match.turn)) % above.size();
    const double off = glm::distance(below[grows ? on : cell], above[stitch]) - height;
    sum += off * off;
  }
  return sum;
}

// A wider window finds nothing else on sound curves and costs its share.
constexpr std::int32_t most_turns = 12;
constexpr std::int32_t most_turns_tried = 96;    // where any will do
constexpr std::int32_t most_phases = 8;          // of a stitch, where a row may be set down anywhere
constexpr std::int32_t stitches_set_down = 800;  // of all phases, so that long rounds stay cheap
constexpr double better_phase = 0.95;            // another phase must be better by this much: less is noise
constexpr std::int32_t passes = 3;
constexpr std::int32_t most_slides = 4;                       // of a row whose links are known
constexpr double slowest_offset = 0.5, fastest_offset = 4.0;  // against the slide

// A row of `count` stitches on a curve, set down above live stitches.
class RowFollower {
 public:
  RowFollower(const Ring& curve, std::int32_t count, std::span<const Stitch> below, double height)
      : curve_(curve), count_(count), height_(height), first_(nearest_arc(curve, below.front().position)) {
    live_.reserve(below.size());
    for (const Stitch& stitch : below) live_.push_back(stitch.position);
  }

  // From where the live stitches begin, within a few stitches.
  BegunRound near_the_first() {
    const std::int32_t window = std::clamp(count_ / 8, std::int32_t{3}, most_turns);
    return slide_from(first_, window, 2, [](double sum, const RoundMatch&) { return sum; }).begun;
  }
  // At any turn. Sliding ends in another place for each phase that it begins at; of their ends the one is taken whose wales
  // come nearest to the height, as the least sum of squares may be that of one short wale beside a long one.
  BegunRound anywhere() {
    const std::int32_t phases = std::clamp(stitches_set_down / count_, std::int32_t{1}, most_phases);
    SlidTo best;
    for (std::int32_t phase = 0; phase < phases; ++phase) {
      const double start = first_ + curve_.length / count_ * phase / phases;
      const SlidTo found = slide_from(start, count_, count_, [&](double, const RoundMatch& match) {
        return off_height(live_, row_, match, height_);
      });
      if (phase == 0 || found.cost < better_phase * best.cost) best = found;
    }
    return best.begun;
  }

  // With its first stitch on the first live one, and the others by these links. About a pole the mean offset changes up to twice as
  // fast as the row slides: from the second slide on the secant tells how fast.
  BegunRound hanging_by(std::span<const std::int32_t> links) {
    const double scale = curve_.length * curve_.length / count_;
    const RoundMatch match{0, 0.0, {links.begin(), links.end()}};
    BegunRound best{0.0, 0.0, unreachable, 0};
    double slid = 0.0, slid_before = 0.0, offset_before = 0.0;
    for (std::int32_t pass = 0; pass < most_slides; ++pass) {
      row_ = set_down(curve_, count_, first_ + slid);
      const double sum = off_height(live_, row_, match, 0.0);
      if (clearly_less(sum, best.sum_of_squares, scale)) best = {first_ + slid, slid, sum, pass + 1};
      const double offset = mean_offset(live_, row_, match);
      const double moved = slid - slid_before;
      const double speed =
          moved != 0.0 ? std::clamp((offset_before - offset) / moved, slowest_offset, fastest_offset) : 1.0;
      slid_before = slid;
      offset_before = offset;
      slid += offset / speed;
    }
    return best;
  }

 private:
  struct SlidTo {
    BegunRound begun{0.0, 0.0, unreachable, 0};
    double cost = unreachable;
  };

  template <class Cost>
  SlidTo slide_from(double start, std::int32_t window, std::int32_t window_after, Cost cost_of) {
    const double scale = curve_.length * curve_.length / count_;
    SlidTo best;
    double least = unreachable;
    for (std::int32_t pass = 0; pass < passes; ++pass) {
      row_ = set_down(curve_, count_, start);
      const RoundMatch match = match_round(live_, row_, pass == 0 ? window : window_after);
      if (!clearly_less(match.sum_of_squares, least, scale)) break;
      least = match.sum_of_squares;
      const double cost = cost_of(least, match);
      if (clearly_less(cost, best.cost, scale))
        best = {{start + curve_.length * match.turn / count_, start - first_, least, pass + 1}, cost};
      start += mean_offset(live_, row_, match);
    }
    return best;
  }

  const Ring& curve_;
  std::int32_t count_;
  double height_;
  double first_;
  std::vector<glm::dvec3> live_, row_;
};

BegunRound within_curve(BegunRound begun, const Ring& curve) {
  begun.arc = std::fmod(begun.arc, curve.length);
  if (begun.arc < 0.0) begun.arc += curve.length;
  return begun;
}

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

BegunRound follow_wale(const Ring& curve, std::int32_t count, std::span<const Stitch> below, bool free,
                       double height) {
  RowFollower follower(curve, count, below, height);
  return within_curve(free ? follower.anywhere() : follower.near_the_first(), curve);
}

BegunRound follow_links(const Ring& curve, std::int32_t count, std::span<const Stitch> below,
                        std::span<const std::int32_t> links) {
  RowFollower follower(curve, count, below, 0.0);
  return within_curve(follower.hanging_by(links), curve);
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
