#include "knit/rows/ring.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/model/ties.h"
#include "knit/rows/frame.h"

namespace knit {

namespace {

struct Frame : RowFrame {
  glm::dvec3 centre;
};

Frame frame_of(const Input& input, const Ends& ends, std::span<const VertexId> places,
               const std::optional<glm::dvec3>& start_direction) {
  const RowFrame frame = row_frame(ends.direction, start_direction);
  glm::dvec3 centre(0.0);
  for (const VertexId v : places) centre += input.mesh.positions[v];
  return {frame, centre / static_cast<double>(places.size())};
}

// Rises with the angle about the centre without needing it: in [-2, 2], 0 at the start direction, 1 a quarter
// turn ahead, 2 apart when opposite (the path round a diamond). Close to 0 it is the angle in radians.
constexpr double half_turn = 2.0;
double turn_of(const Frame& frame, const glm::dvec3& position) {
  const glm::dvec3 offset = position - frame.centre;
  const double x = glm::dot(offset, frame.right);
  const double y = glm::dot(offset, frame.ahead);
  const double size = std::abs(x) + std::abs(y);
  if (size == 0.0) return 0.0;
  return y >= 0.0 ? 1.0 - x / size : x / size - 1.0;
}

// One vertex a place, the lowest index.
std::vector<VertexId> distinct_places(const Input& input, std::span<const VertexId> level) {
  std::vector<VertexId> places;
  for (const VertexId v : level) {
    if (input.twin[v] == v) places.push_back(v);
  }
  return places;
}

struct AngledPlace {
  double turn = 0.0;
  VertexId vertex = no_vertex;
};

// Rising by angle; equal angles by index.
std::vector<AngledPlace> by_angle(const Input& input, const Frame& frame,
                                  const std::vector<VertexId>& places) {
  std::vector<AngledPlace> sorted;
  sorted.reserve(places.size());
  for (const VertexId v : places) sorted.push_back({turn_of(frame, input.mesh.positions[v]), v});
  std::sort(sorted.begin(), sorted.end(), [](const AngledPlace& a, const AngledPlace& b) {
    return a.turn != b.turn ? a.turn < b.turn : a.vertex < b.vertex;
  });
  return sorted;
}

// The vertex of smallest angle to the start direction; ties, to about a millionth of a radian, go to the
// lower index.
VertexId first_of(const std::vector<AngledPlace>& places) {
  double best = std::abs(places.front().turn);
  for (const AngledPlace& place : places) best = std::min(best, std::abs(place.turn));
  VertexId first = no_vertex;
  for (const AngledPlace& place : places) {
    if (std::abs(place.turn) <= best + 1e-6) first = std::min(first, place.vertex);
  }
  return first;
}

// The widest turn between neighbours round the centre.
double widest_gap(const std::vector<AngledPlace>& places) {
  double widest = places.front().turn + 2 * half_turn - places.back().turn;
  for (std::size_t i = 1; i < places.size(); ++i)
    widest = std::max(widest, places[i].turn - places[i - 1].turn);
  return widest;
}

bool neighbours_all_round(const Input& input, const std::vector<VertexId>& order) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (!input.adjacent(order[i], order[(i + 1) % order.size()])) return false;
  }
  return true;
}

struct EdgeWalk {
  std::vector<VertexId> order;  // one closed loop through all places, if there is one
  std::int32_t loops = 0;
  std::int32_t edges = 0;  // between vertices of the level
};

std::vector<VertexId> within(const Input& input, const std::vector<VertexId>& sorted_places, VertexId v) {
  std::vector<VertexId> found;
  for (const VertexId n : input.neighbours_of(v)) {
    if (std::binary_search(sorted_places.begin(), sorted_places.end(), n)) found.push_back(n);
  }
  return found;
}

EdgeWalk walk_edges(const Input& input, const std::vector<VertexId>& places) {
  std::vector<VertexId> sorted = places;
  std::sort(sorted.begin(), sorted.end());
  EdgeWalk result;
  bool all_of_degree_two = true;
  for (const VertexId v : sorted) {
    const auto degree = within(input, sorted, v).size();
    result.edges += static_cast<std::int32_t>(degree);
    all_of_degree_two = all_of_degree_two && degree == 2;
  }
  result.edges /= 2;
  if (!all_of_degree_two) return result;
  std::vector<std::uint8_t> seen(sorted.size(), 0);
  const auto index_of = [&](VertexId v) {
    return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), v) - sorted.begin());
  };
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (seen[i] != 0) continue;
    ++result.loops;
    result.order.clear();
    VertexId at = sorted[i];
    VertexId from = no_vertex;
    while (seen[index_of(at)] == 0) {
      seen[index_of(at)] = 1;
      result.order.push_back(at);
      const std::vector<VertexId> next = within(input, sorted, at);
      const VertexId ahead = next[0] != from ? next[0] : next[1];
      from = at;
      at = ahead;
    }
  }
  return result;
}

// Turns a walked loop so that it runs in working order.
void orient(const Input& input, const Frame& frame, std::vector<VertexId>& order) {
  std::vector<glm::dvec3> points;
  points.reserve(order.size());
  for (const VertexId v : order) points.push_back(input.mesh.positions[v]);
  if (runs_backwards(points, frame, frame.centre)) std::reverse(order.begin(), order.end());
}

// From places to the ring: begin at `first`, put other vertices at the same places back, copies of the first
// at the end.
Ring assemble(const Input& input, std::span<const VertexId> level, std::vector<VertexId> order,
              VertexId first, OrderedBy by) {
  std::rotate(order.begin(), std::find(order.begin(), order.end(), first), order.end());
  Ring ring;
  ring.ordered_by = by;
  if (order.size() == level.size()) {
    ring.vertices = std::move(order);
  } else {
    std::vector<std::pair<VertexId, VertexId>> copies;  // place, vertex
    for (const VertexId v : level) {
      if (input.twin[v] != v) copies.emplace_back(input.twin[v], v);
    }
    std::sort(copies.begin(), copies.end());
    const auto append_copies = [&](VertexId place) {
      auto it = std::lower_bound(copies.begin(), copies.end(), std::pair{place, VertexId{0}});
      for (; it != copies.end() && it->first == place; ++it) ring.vertices.push_back(it->second);
    };
    for (const VertexId place : order) {
      ring.vertices.push_back(place);
      if (place != first) append_copies(place);
    }
    append_copies(first);
  }
  ring.points.reserve(ring.vertices.size());
  for (const VertexId v : ring.vertices) ring.points.push_back(input.mesh.positions[v]);
  measure_arcs(ring);
  return ring;
}

}  // namespace

std::variant<Ring, NotARing> order_ring(const Input& input, const Ends& ends, std::span<const VertexId> level,
                                        const std::optional<glm::dvec3>& start_direction) {
  const std::vector<VertexId> places = distinct_places(input, level);
  const auto count = static_cast<std::int32_t>(places.size());
  if (count < 3) return NotARing{count, 0};
  const Frame frame = frame_of(input, ends, places, start_direction);
  const std::vector<AngledPlace> sorted = by_angle(input, frame, places);
  const VertexId first = first_of(sorted);
  std::vector<VertexId> order;
  order.reserve(sorted.size());
  for (const AngledPlace& place : sorted) order.push_back(place.vertex);
  if (neighbours_all_round(input, order))
    return assemble(input, level, std::move(order), first, OrderedBy::angle);

  EdgeWalk walk = walk_edges(input, places);
  if (walk.loops == 1) {
    orient(input, frame, walk.order);
    return assemble(input, level, std::move(walk.order), first, OrderedBy::edges);
  }
  if (walk.loops > 1 || walk.edges > 0) return NotARing{count, walk.loops};
  // No edges within the level: nothing contradicts the order by angle, if the places go round the centre.
  if (widest_gap(sorted) >= half_turn) return NotARing{count, 0};
  return assemble(input, level, std::move(order), first, OrderedBy::angle);
}

std::vector<Stitch> spread_evenly(const Ring& ring, std::int32_t count) {
  std::vector<Stitch> stitches;
  stitches.reserve(static_cast<std::size_t>(count));
  for (std::int32_t i = 0; i < count; ++i)
    stitches.push_back({point_at(ring, ring.length * i / count), no_vertex});
  return stitches;
}

}  // namespace knit
