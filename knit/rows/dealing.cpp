#include "knit/rows/dealing.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "knit/fabric/edges.h"
#include "knit/mesh/closest_point.h"
#include "knit/model/bug.h"
#include "knit/model/ties.h"
#include "knit/rows/follow.h"

namespace knit {

namespace {

double squared_length(const glm::dvec3& v) { return glm::dot(v, v); }

std::vector<double> squares_to(std::span<const Stitch> loop, const Ring& curve) {
  std::vector<double> squares;
  squares.reserve(loop.size());
  for (const Stitch& stitch : loop)
    squares.push_back(squared_length(point_at(curve, nearest_arc(curve, stitch.position)) - stitch.position));
  return squares;
}

// The middle of each stitch and the one after it.
std::vector<glm::dvec3> middles_of(std::span<const Stitch> loop) {
  std::vector<glm::dvec3> middles;
  middles.reserve(loop.size());
  for (const auto& [i, next] : Edges(loop.size(), true))
    middles.push_back(0.5 * (loop[i].position + loop[next].position));
  return middles;
}

std::vector<StitchRef> refs_of(const LiveStitches& live) {
  std::vector<StitchRef> refs;
  for (const StitchSpan& span : live.spans) {
    for (std::int32_t i = 0; i < span.count; ++i) refs.push_back({span.row, span.first + i});
  }
  return refs;
}

// Whether an edge may join these two live stitches already: along a row, over a bridge, or because one hangs on a loop that
// has the other (its row took it, which a stitch of a bridge outlives).
class Joined {
 public:
  explicit Joined(const Fabric& fabric) : fabric_(fabric) {}
  [[nodiscard]] bool operator()(const StitchRef& a, const StitchRef& b) const {
    return a == b || beside(a, b) || share_a_face(a, b) || hangs_on(a, b) || hangs_on(b, a);
  }

 private:
  [[nodiscard]] bool beside(const StitchRef& a, const StitchRef& b) const {
    if (a.row != b.row) return false;
    const std::int32_t step = std::abs(a.stitch - b.stitch);
    return step == 1 || (!is_bridge(a) && step + 1 == size_of(fabric_.row(a.row)));
  }
  [[nodiscard]] bool share_a_face(const StitchRef& a, const StitchRef& b) const {
    const std::uint32_t p = number(a), q = number(b);
    for (const auto& deal : fabric_.deals()) {
      for (const Face& face : deal->faces) {
        const auto end = face.corners.begin() + face.corner_count;
        if (std::find(face.corners.begin(), end, p) != end && std::find(face.corners.begin(), end, q) != end)
          return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool hangs_on(const StitchRef& above, const StitchRef& below) const {
    if (is_bridge(above)) return false;
    const std::vector<StitchRef> taken = refs_of(fabric_.row(above.row).on);
    return std::find(taken.begin(), taken.end(), below) != taken.end();
  }
  [[nodiscard]] std::uint32_t number(const StitchRef& ref) const { return fabric_.path_index(ref); }
  const Fabric& fabric_;
};

// The two sides of a deal: of a split its arcs, of a join its loops from the gap round to it.
struct Sides {
  std::array<LiveStitches, 2> part;
  glm::dvec3 from{0.0}, to{0.0};  // the middles of the gaps that the bridge leads from and to
};

// What must not be joined yet, for a deal without a bridge: its two closing edges.
std::int32_t least_bridge(const DealAt& at, const Sides& sides, DealKind kind) {
  const std::vector<StitchRef> one = refs_of(sides.part[0]), two = refs_of(sides.part[1]);
  std::vector<StitchRef> ends{one.front(), one.back(), two.front(), two.back()};
  std::sort(ends.begin(), ends.end());
  if (std::adjacent_find(ends.begin(), ends.end()) != ends.end()) return 2;
  const Joined joined(at.fabric);
  const bool again = kind == DealKind::split
                         ? joined(one.back(), one.front()) || joined(two.back(), two.front())
                         : joined(one.back(), two.front()) || joined(two.back(), one.front());
  return again ? 1 : 0;
}

void build_bridge(const DealAt& at, const Sides& sides, std::int32_t least, Deal& deal) {
  const double up = glm::distance(sides.from, deal.saddle);
  const double down = glm::distance(deal.saddle, sides.to);
  deal.gap = up + down;
  const auto wanted = static_cast<std::int32_t>(rounded(deal.gap / at.stitch_width)) - 1;
  const std::int32_t stitches = std::max({0, wanted, least});
  for (std::int32_t i = 1; i <= stitches; ++i) {
    const double way = deal.gap * i / (stitches + 1);
    const glm::dvec3 place = way <= up && up > 0.0 ? sides.from + (way / up) * (deal.saddle - sides.from)
                                                   : deal.saddle + ((way - up) / std::max(down, 1e-300)) *
                                                                       (sides.to - deal.saddle);
    deal.bridge.push_back({closest_on_surface(at.input, place), no_vertex});
  }
}

LiveStitches bridge_of(const Fabric& fabric, const Deal& deal, bool backwards) {
  const RowId row = bridge_row(static_cast<std::int32_t>(fabric.deals().size()) + 1);
  const auto count = static_cast<std::int32_t>(deal.bridge.size());
  LiveStitches bridge;
  for (std::int32_t i = 0; i < count; ++i) bridge.append({row, backwards ? count - 1 - i : i, 1});
  return bridge;
}

// Corners by the knitting path; the bridge comes next on it.
void add_faces(const DealAt& at, const Sides& sides, Deal& deal) {
  const std::vector<std::uint32_t> one = at.fabric.path_indices(sides.part[0]);
  const std::vector<std::uint32_t> two = at.fabric.path_indices(sides.part[1]);
  const bool split = deal.kind == DealKind::split;
  if (deal.bridge.empty()) {
    deal.faces.push_back({split ? std::array{one.back(), one.front(), two.back(), two.front()}
                                : std::array{one.back(), two.front(), two.back(), one.front()},
                          4, 0, Label::knit});
    return;
  }
  const auto first = static_cast<std::uint32_t>(at.fabric.stitch_count());
  const std::uint32_t last = first + static_cast<std::uint32_t>(deal.bridge.size()) - 1;
  deal.faces.push_back({{one.back(), first, split ? two.front() : one.front(), 0}, 3, 0, Label::knit});
  deal.faces.push_back({{two.back(), last, split ? one.front() : two.front(), 0}, 3, 0, Label::knit});
}

Deal begin_deal(const DealAt& at, DealKind kind) {
  const TubeEvent& event = at.plan.event(at.event);
  Deal deal;
  deal.kind = kind;
  deal.event = at.event;
  deal.after = at.fabric.row_count();
  deal.from = event.below;
  deal.to = event.above;
  deal.saddle = event.position;
  for (const TubeId tube : deal.from) deal.taken.push_back(at.fabric.live(tube));
  return deal;
}

// Of an arc, where a round begins that does not begin there yet: shaping gathers at the saddle and opposite it, and may not
// cross the beginning.
std::int32_t aside(std::int32_t stitches) { return stitches / 4; }

std::size_t nearest_gap(const std::vector<glm::dvec3>& middles, const glm::dvec3& saddle, double scale) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < middles.size(); ++i) {
    if (clearly_less(squared_length(middles[i] - saddle), squared_length(middles[best] - saddle), scale))
      best = i;
  }
  return best;
}

}  // namespace

ArcFound find_arc(std::span<const Stitch> loop, const std::array<const Ring*, 2>& children,
                  const glm::dvec3& saddle) {
  const auto n = static_cast<std::int32_t>(loop.size());
  const std::vector<double> to_one = squares_to(loop, *children[0]), to_two = squares_to(loop, *children[1]);
  const std::vector<glm::dvec3> middles = middles_of(loop);
  const auto at_saddle = [&](std::int32_t gap) {  // the gap before stitch `gap`
    return squared_length(middles[static_cast<std::size_t>((gap + n - 1) % n)] - saddle);
  };
  // Of stitches 0 .. i of the loop twice round: how much more it costs to give them to child 1.
  std::vector<double> more(2 * static_cast<std::size_t>(n) + 1, 0.0);
  double scale = 0.0;
  for (std::size_t i = 0; i + 1 < more.size(); ++i) {
    const std::size_t stitch = i % static_cast<std::size_t>(n);
    more[i + 1] = more[i] + to_one[stitch] - to_two[stitch];
    scale += to_one[stitch] + to_two[stitch];
  }
  const std::int32_t least = std::min(3, n / 2);
  ArcFound best{0, 0, std::numeric_limits<double>::infinity(), 0};
  for (std::int32_t first = 0; first < n; ++first) {
    for (std::int32_t count = least; count <= n - least; ++count) {
      const double cost = more[static_cast<std::size_t>(first + count)] -
                          more[static_cast<std::size_t>(first)] + at_saddle(first) +
                          at_saddle((first + count) % n);
      ++best.tried;
      if (!clearly_less(cost, best.cost, scale)) continue;
      best = {first, count, cost, best.tried};
    }
  }
  return best;
}

Deal deal_split(const DealAt& at, const ArcFound& arc) {
  Deal deal = begin_deal(at, DealKind::split);
  const LiveStitches& loop = deal.taken.front();
  const std::int32_t n = loop.size();
  Sides sides;
  sides.part = {stretch_of(loop, arc.first, arc.count),
                stretch_of(loop, (arc.first + arc.count) % n, n - arc.count)};
  const std::vector<glm::dvec3> middles = middles_of(at.fabric.stitches_of(loop));
  sides.from = middles[static_cast<std::size_t>((arc.first + arc.count + n - 1) % n)];
  sides.to = middles[static_cast<std::size_t>((arc.first + n - 1) % n)];
  deal.arcs = {arc.count, n - arc.count};
  const std::int32_t least =
      std::max(3 - std::min(arc.count, n - arc.count), least_bridge(at, sides, DealKind::split));
  build_bridge(at, sides, least, deal);
  add_faces(at, sides, deal);
  for (const std::size_t child : {std::size_t{0}, std::size_t{1}}) {
    LiveStitches given = sides.part[child];
    given.append(bridge_of(at.fabric, deal, child == 1));
    const std::int32_t begins = place_in(given, loop.at(0));
    const bool has_beginning = begins >= 0;
    const std::int32_t other = at.from_pinch ? 0 : aside(sides.part[child].size());
    deal.given.push_back(begun_at(given, has_beginning ? begins : other));
  }
  return deal;
}

namespace {

std::ptrdiff_t worked_last_at(const TubePlan& plan, const std::vector<TubeId>& order, TubeId tube) {
  std::ptrdiff_t last = -1;
  if (plan.tube(tube).rows() > 0) return std::find(order.begin(), order.end(), tube) - order.begin();
  for (const TubeId below : plan.event(plan.tube(tube).bottom).below)
    last = std::max(last, worked_last_at(plan, order, below));
  return last;
}

}  // namespace

std::size_t yarn_bringer(const TubePlan& plan, const std::vector<TubeId>& order, const TubeEvent& join) {
  return worked_last_at(plan, order, join.below[0]) > worked_last_at(plan, order, join.below[1]) ? 0 : 1;
}

Deal deal_join(const DealAt& at, std::size_t brings_yarn) {
  Deal deal = begin_deal(at, DealKind::join);
  Sides sides;
  for (const std::size_t foot : {std::size_t{0}, std::size_t{1}}) {
    const LiveStitches& loop = deal.taken[foot];
    const std::vector<glm::dvec3> middles = middles_of(at.fabric.stitches_of(loop));
    const std::size_t gap = nearest_gap(middles, deal.saddle, squared_length(middles.front() - deal.saddle));
    sides.part[foot] = begun_at(loop, static_cast<std::int32_t>(gap + 1) % loop.size());
    (foot == 0 ? sides.from : sides.to) = middles[gap];
    deal.arcs[foot] = loop.size();
  }
  build_bridge(at, sides, least_bridge(at, sides, DealKind::join), deal);
  add_faces(at, sides, deal);
  LiveStitches given = sides.part[0];
  given.append(bridge_of(at.fabric, deal, false));
  given.append(sides.part[1]);
  given.append(bridge_of(at.fabric, deal, true));
  deal.given.push_back(begun_at(given, place_in(given, deal.taken[brings_yarn].at(0))));
  return deal;
}

namespace {

LiveStitches turned_round(const LiveStitches& live) {
  std::vector<StitchRef> refs = refs_of(live);
  LiveStitches turned;
  for (std::size_t i = refs.size(); i-- > 0;) turned.append({refs[i].row, refs[i].stitch, 1});
  return turned;
}

// Cells of the larger round, each with the stitch of the smaller that it is joined to; `turn` of the upper one.
RoundMatch match_any(std::span<const glm::dvec3> lower, std::span<const glm::dvec3> upper) {
  const std::size_t small = std::min(lower.size(), upper.size()),
                    large = std::max(lower.size(), upper.size());
  if (large <= 2 * small) return match_round(lower, upper, static_cast<std::int32_t>(upper.size()));
  RoundMatch spread;  // more than two on a stitch: as even as can be
  for (std::size_t cell = 0; cell < large; ++cell)
    spread.link.push_back(static_cast<std::int32_t>(cell * small / large));
  return spread;
}

std::vector<glm::dvec3> places_of(const Fabric& fabric, const LiveStitches& live) {
  std::vector<glm::dvec3> places;
  for (const Stitch& stitch : fabric.stitches_of(live)) places.push_back(stitch.position);
  return places;
}

void add_strip(const Fabric& fabric, const LiveStitches& lower, const LiveStitches& upper, Deal& deal) {
  const RoundMatch match = match_any(places_of(fabric, lower), places_of(fabric, upper));
  const std::vector<std::uint32_t> below = fabric.path_indices(lower);
  const std::vector<std::uint32_t> above = fabric.path_indices(begun_at(upper, match.turn));
  const bool grows = above.size() >= below.size();
  const std::vector<std::uint32_t>& large = grows ? above : below;
  const std::vector<std::uint32_t>& small = grows ? below : above;
  for (const auto& [cell, next] : Edges(large.size(), true)) {
    const std::uint32_t b = large[cell], b_next = large[next];
    const std::uint32_t s = small[static_cast<std::size_t>(match.link[cell])];
    const std::uint32_t s_next = small[static_cast<std::size_t>(match.link[next])];
    deal.column_edges.push_back(grows ? std::array{s, b} : std::array{b, s});
    Face face{{}, s == s_next ? 3 : 4, 0, Label::knit};
    if (s == s_next) {
      face.corners = grows ? std::array{s, b, b_next, 0U} : std::array{b, s, b_next, 0U};
    } else {
      face.corners = grows ? std::array{s, b, b_next, s_next} : std::array{b, s, s_next, b_next};
    }
    deal.faces.push_back(face);
  }
}

LiveStitches first_row_of(const Fabric& fabric, TubeId tube) {
  for (const auto& row : fabric.rows()) {
    if (row->tube == tube) return all_of(*row);
  }
  throw Bug("a ring's tube has no row");
}

}  // namespace

Deal deal_ring(const DealAt& at) {
  const TubeEvent& event = at.plan.event(at.event);
  const bool cast_on = event.kind == EventKind::ring_cast_on;
  Deal deal = begin_deal(at, cast_on ? DealKind::ring_cast_on : DealKind::ring_bind_off);
  deal.to.clear();
  if (cast_on) {
    deal.from = event.above;
    deal.taken = {first_row_of(at.fabric, event.above[0]), first_row_of(at.fabric, event.above[1])};
    add_strip(at.fabric, turned_round(deal.taken[0]), deal.taken[1], deal);
  } else {
    add_strip(at.fabric, deal.taken[0], turned_round(deal.taken[1]), deal);
  }
  deal.arcs = {deal.taken[0].size(), deal.taken[1].size()};
  return deal;
}

}  // namespace knit
