// A level curve of a tube, by the edges that it crosses.
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <iterator>
#include <numeric>
#include <utility>

#include "knit/model/bug.h"
#include "knit/tubes/graph.h"

namespace knit {

namespace {

// Where a triangle is crossed: the edges, lower vertex first, by which a curve in working order comes and goes.
struct CurveCrossing {
  std::array<VertexId, 2> from, to;
};

std::array<VertexId, 2> curve_edge(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

// Between the vertices of rank below `rank` and the others.
std::vector<CurveCrossing> crossings_at(const TubeGraph& graph, std::int32_t tube, std::uint32_t rank) {
  const MorseSurface& surface = graph.surface;
  const auto first = graph.first_piece.begin() + tube;
  const auto begin = graph.pieces.begin() + *first;
  const auto end = std::partition_point(begin, graph.pieces.begin() + *std::next(first),
                                        [&](const TubePiece& piece) { return piece.low < rank; });
  std::vector<CurveCrossing> crossings;
  for (auto piece = begin; piece != end; ++piece) {
    if (piece->high < rank) continue;
    const Triangle& t = surface.triangles[piece->triangle];
    const std::array<bool, 3> above{surface.rank[t[0]] >= rank, surface.rank[t[1]] >= rank,
                                    surface.rank[t[2]] >= rank};
    const std::size_t alone = above[1] == above[2] ? 0 : above[2] == above[0] ? 1 : 2;
    const auto next = curve_edge(t[alone], t[(alone + 1) % 3]);
    const auto previous = curve_edge(t[alone], t[(alone + 2) % 3]);
    crossings.push_back(above[alone] ? CurveCrossing{previous, next} : CurveCrossing{next, previous});
  }
  return crossings;
}

// The edges of the one loop that the crossings make, from the first one's on.
std::vector<std::array<VertexId, 2>> linked(const std::vector<CurveCrossing>& crossings) {
  std::vector<std::uint32_t> coming(crossings.size());
  std::iota(coming.begin(), coming.end(), 0U);
  std::vector<std::uint32_t> going = coming;
  std::sort(coming.begin(), coming.end(),
            [&](std::uint32_t a, std::uint32_t b) { return crossings[a].from < crossings[b].from; });
  std::sort(going.begin(), going.end(),
            [&](std::uint32_t a, std::uint32_t b) { return crossings[a].to < crossings[b].to; });
  std::vector<std::uint32_t> next(crossings.size());
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    if (crossings[going[i]].to != crossings[coming[i]].from) throw Bug("a level curve of a tube is open");
    next[going[i]] = coming[i];
  }
  std::vector<std::array<VertexId, 2>> edges;
  edges.reserve(crossings.size());
  std::uint32_t at = 0;
  do {
    edges.push_back(crossings[at].from);
    at = next[at];
  } while (at != 0 && edges.size() < crossings.size());
  if (at != 0 || edges.size() != crossings.size()) throw Bug("a level set of a tube is not one loop");
  return edges;
}

// Without those that are as good as the one before, unless fewer than three would be left.
std::vector<glm::dvec3> without_repetitions(const std::vector<glm::dvec3>& points, double scale) {
  const double least = 1e-12 * scale;
  std::vector<glm::dvec3> kept;
  kept.reserve(points.size());
  for (const glm::dvec3& point : points)
    if (kept.empty() || glm::distance(point, kept.back()) > least) kept.push_back(point);
  while (kept.size() > 1 && glm::distance(kept.front(), kept.back()) <= least) kept.pop_back();
  return kept.size() >= 3 ? kept : points;
}

}  // namespace

std::vector<glm::dvec3> curve_at(const TubeGraph& graph, std::int32_t tube, double value) {
  const MorseSurface& surface = graph.surface;
  const auto& [bottom, top] = graph.tubes[static_cast<std::size_t>(tube)];
  const auto rank_of = [&](std::int32_t node) {
    return surface.rank[graph.nodes[static_cast<std::size_t>(node)].vertex];
  };
  // At an open edge on top the curve is the edge itself, below all that has its value.
  const GraphNode& end = graph.nodes[static_cast<std::size_t>(top)];
  const bool on_rim = end.rim && value >= end.value;
  const auto above = std::partition_point(surface.by_rank.begin(), surface.by_rank.end(), [&](VertexId v) {
    return on_rim ? surface.values[v] < end.value : surface.values[v] <= value;
  });
  const auto rank = std::clamp(static_cast<std::uint32_t>(above - surface.by_rank.begin()),
                               rank_of(bottom) + 1, rank_of(top));
  const std::vector<CurveCrossing> crossings = crossings_at(graph, tube, rank);
  if (crossings.empty()) throw Bug("a tube has no level curve");
  std::vector<glm::dvec3> points;
  points.reserve(crossings.size());
  double scale = 0.0;
  for (const auto& [a, b] : linked(crossings)) {
    const auto [low, high] = surface.rank[a] < surface.rank[b] ? std::pair(a, b) : std::pair(b, a);
    const double rise = surface.values[high] - surface.values[low];
    const double inside = std::clamp(value, surface.values[low], surface.values[high]);
    const double share = rise > 0.0 ? (inside - surface.values[low]) / rise : 0.5;
    points.push_back((1.0 - share) * surface.positions[low] + share * surface.positions[high]);
    scale = std::max(scale, glm::distance(surface.positions[low], surface.positions[high]));
  }
  return without_repetitions(points, scale);
}

}  // namespace knit
