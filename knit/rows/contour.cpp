#include "knit/rows/contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/model/ties.h"
#include "knit/rows/follow.h"

namespace knit {

namespace {

using Edge = std::array<VertexId, 2>;  // places, the lower number first

// Where a triangle is cut: from one of its edges to another.
struct Segment {
  std::array<Edge, 2> ends;
};

Edge edge_of(const Input& input, VertexId a, VertexId b) {
  const VertexId p = input.twin[a];
  const VertexId q = input.twin[b];
  return {std::min(p, q), std::max(p, q)};
}

// How many of the values lie at or below each vertex: it is above exactly these cuts.
std::vector<std::uint32_t> cuts_below(const Input& input, const std::vector<double>& field,
                                      std::span<const double> values) {
  std::vector<std::uint32_t> below(field.size());
  for (std::size_t v = 0; v < field.size(); ++v) {
    const double value = field[input.twin[v]];
    below[v] =
        static_cast<std::uint32_t>(std::upper_bound(values.begin(), values.end(), value) - values.begin());
  }
  return below;
}

std::vector<std::vector<Segment>> cut_triangles(const Input& input, const std::vector<double>& field,
                                                std::span<const double> values) {
  const std::vector<std::uint32_t> below = cuts_below(input, field, values);
  std::vector<std::vector<Segment>> cuts(values.size());
  for (const Triangle& t : input.mesh.triangles) {
    const auto [low, high] = std::minmax({below[t[0]], below[t[1]], below[t[2]]});
    if (low == high) continue;
    const Triangle p{input.twin[t[0]], input.twin[t[1]], input.twin[t[2]]};
    if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) continue;
    for (std::uint32_t cut = low; cut < high; ++cut) {
      Segment segment{};
      std::size_t found = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if ((below[t[i]] > cut) != (below[t[j]] > cut)) segment.ends[found++] = edge_of(input, t[i], t[j]);
      }
      cuts[cut].push_back(segment);
    }
  }
  return cuts;
}

// Joins segments that end on the same edge. A loop is the edges it crosses, in order.
std::vector<std::vector<Edge>> link(const std::vector<Segment>& segments) {
  struct End {
    Edge edge;
    std::uint32_t segment;
  };
  std::vector<End> ends;
  ends.reserve(2 * segments.size());
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    for (const Edge& edge : segments[s].ends) ends.push_back({edge, s});
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.segment < b.segment;
  });
  const auto across = [&](const Edge& edge, std::uint32_t from) {
    const auto first = std::lower_bound(ends.begin(), ends.end(), edge,
                                        [](const End& end, const Edge& e) { return end.edge < e; });
    for (auto it = first; it != ends.end() && it->edge == edge; ++it) {
      if (it->segment != from) return it->segment;
    }
    return from;  // an open edge, which a checked mesh does not have
  };
  std::vector<std::vector<Edge>> loops;
  std::vector<std::uint8_t> seen(segments.size(), 0);
  for (std::uint32_t first = 0; first < segments.size(); ++first) {
    if (seen[first] != 0) continue;
    std::vector<Edge> loop;
    Edge edge = segments[first].ends[1];
    for (std::uint32_t s = first; seen[s] == 0; s = across(edge, s)) {
      seen[s] = 1;
      if (s != first) edge = segments[s].ends[segments[s].ends[0] == edge ? 1 : 0];
      loop.push_back(edge);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

// The crossed points, without repetitions.
std::vector<glm::dvec3> points_on(const Input& input, const std::vector<double>& field, double value,
                                  const std::vector<Edge>& loop) {
  std::vector<glm::dvec3> points;
  points.reserve(loop.size());
  for (const auto& [a, b] : loop) {
    const double share = (value - field[a]) / (field[b] - field[a]);
    // Exact at both ends, so that a cut through a vertex finds it once.
    const glm::dvec3 point = (1.0 - share) * input.mesh.positions[a] + share * input.mesh.positions[b];
    if (points.empty() || point != points.back()) points.push_back(point);
  }
  while (points.size() > 1 && points.front() == points.back()) points.pop_back();
  return points;
}

Ring ring_from(std::vector<glm::dvec3> points, const RowFrame& frame,
               const std::optional<glm::dvec3>& below) {
  Ring ring;
  ring.ordered_by = OrderedBy::cut;
  ring.points = std::move(points);
  if (runs_backwards(ring.points, frame, centre_of(ring)))
    std::reverse(ring.points.begin(), ring.points.end());
  measure_arcs(ring);
  return begun_at(ring, arc_towards(ring, frame, below));
}

}  // namespace

std::vector<Cut> cut_surface(const Input& input, const std::vector<double>& field,
                             std::span<const double> values, std::span<const double> times,
                             const RowFrame& frame) {
  const auto segments = cut_triangles(input, field, values);
  // Shorter ones are points, but for rounding.
  const double least_length = 1e-9 * input.bounds.diagonal();
  std::vector<Cut> cuts;
  std::optional<glm::dvec3> below;
  for (std::size_t i = 0; i < values.size(); ++i) {
    Cut cut{times[i], static_cast<std::int32_t>(segments[i].size()), {}};
    std::vector<Ring> rings;
    for (const std::vector<Edge>& loop : link(segments[i])) {
      std::vector<glm::dvec3> points = points_on(input, field, values[i], loop);
      // Two points are a tube pressed flat, there and back; one is a pinch.
      if (points.size() < 2) continue;
      Ring ring = ring_from(std::move(points), frame, below);
      if (ring.length > least_length) rings.push_back(std::move(ring));
    }
    sort_by_rule(
        rings, [](const Ring& ring) { return -ring.length; }, input.bounds.diagonal());
    for (Ring& ring : rings) cut.loops.emplace_back(std::move(ring));
    if (!cut.loops.empty()) below = cut.loops.front()->points.front();
    cuts.push_back(std::move(cut));
  }
  return cuts;
}

}  // namespace knit
