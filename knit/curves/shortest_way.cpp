#include "knit/curves/shortest_way.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <utility>

namespace knit {
namespace {

constexpr double cosine_of_40 = 0.766044443118978;

// The side of a triangle that two of its nodes share, or 3. Nodes 0 to 2 are corners, the others lie on sides.
std::size_t shared_side(std::size_t a, std::size_t b) {
  if (a > b) std::swap(a, b);
  if (b < 3) return (a + 1) % 3 == b ? a : b;
  const std::size_t side = (b - 3) / ShortestWays::per_edge;
  if (a >= 3) return (a - 3) / ShortestWays::per_edge == side ? side : 3;
  return a == side || a == (side + 1) % 3 ? side : 3;
}

glm::dvec3 unit_normal(const Mesh& mesh, const Triangle& t) {
  const auto& p = mesh.positions;
  const glm::dvec3 cross = glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
  const double length = glm::length(cross);
  return length > 0.0 ? cross / length : glm::dvec3(0.0);
}

}  // namespace

ShortestWays::ShortestWays(const Mesh& mesh, double creases) : mesh_(mesh), edges_(edges_of(mesh.triangles)) {
  const auto vertices = static_cast<Node>(mesh.positions.size());
  positions_ = mesh.positions;
  for (std::uint32_t e = 0; e < edges_.size(); ++e)
    for (std::uint32_t j = 0; j < per_edge; ++j)
      positions_.push_back(place(vertices + e * per_edge + j).position(mesh));
  triangles_of_.resize(positions_.size());
  for (const Triangle& t : mesh.triangles) {
    std::array<Node, per_triangle> nodes{t[0], t[1], t[2]};
    std::array<std::uint32_t, 3> sides{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = std::lower_bound(edges_.begin(), edges_.end(), edge_key(t[k], t[(k + 1) % 3]));
      sides[k] = static_cast<std::uint32_t>(found - edges_.begin());
      for (std::uint32_t j = 0; j < per_edge; ++j)
        nodes[3 + k * per_edge + j] = vertices + sides[k] * per_edge + j;
    }
    for (const Node node : nodes) triangles_of_[node].push_back(static_cast<std::uint32_t>(nodes_.size()));
    nodes_.push_back(nodes);
    side_edges_.push_back(sides);
  }
  measure_creases(creases);
}

void ShortestWays::measure_creases(double creases) {
  cost_.assign(edges_.size(), 1.0);
  constexpr std::uint32_t none = UINT32_MAX;
  std::vector<std::uint32_t> first(edges_.size(), none);
  for (std::uint32_t t = 0; t < nodes_.size(); ++t) {
    for (const std::uint32_t edge : side_edges_[t]) {
      if (first[edge] == none) {
        first[edge] = t;
        continue;
      }
      const glm::dvec3 one = unit_normal(mesh_, mesh_.triangles[first[edge]]);
      if (glm::dot(one, unit_normal(mesh_, mesh_.triangles[t])) < cosine_of_40) cost_[edge] = creases;
    }
  }
}

EdgePlace ShortestWays::place(Node node) const {
  const auto vertices = static_cast<Node>(mesh_.positions.size());
  if (node < vertices) return at_vertex(node);
  const EdgeKey& edge = edges_[(node - vertices) / per_edge];
  return {edge.first, edge.second, ((node - vertices) % per_edge + 1.0) / (per_edge + 1.0)};
}

ShortestWays::Found ShortestWays::search(std::span<const VertexId> sources, VertexId until) const {
  Found found{std::vector<double>(positions_.size(), std::numeric_limits<double>::infinity()),
              std::vector<Node>(positions_.size(), no_node)};
  using Waiting = std::pair<double, Node>;
  std::set<Waiting> queue;  // nearest first; nodes are numbered
  for (const VertexId source : sources) {
    found.length[source] = 0.0;
    queue.insert({0.0, source});
  }
  while (!queue.empty()) {
    const auto [length, node] = *queue.begin();
    queue.erase(queue.begin());
    if (length > found.length[node]) continue;
    if (node == until) break;
    for (const std::uint32_t t : triangles_of_[node]) {
      const auto& nodes = nodes_[t];
      const auto own = static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
      for (std::size_t i = 0; i < per_triangle; ++i) {
        if (i == own) continue;
        const std::size_t side = shared_side(own, i);
        const double cost = side < 3 ? cost_[side_edges_[t][side]] : 1.0;
        const double next = length + cost * glm::length(positions_[nodes[i]] - positions_[node]);
        // Shorter by rounding alone is no reason for one more stop along an edge.
        if (next >= (1.0 - 1e-12) * found.length[nodes[i]]) continue;
        found.length[nodes[i]] = next;
        found.before[nodes[i]] = node;
        queue.insert({next, nodes[i]});
      }
    }
  }
  return found;
}

std::vector<EdgePlace> ShortestWays::way(VertexId from, VertexId to) const {
  const Found found = search(std::span(&from, 1), to);
  if (from != to && found.before[to] == no_node) return {};
  std::vector<EdgePlace> places;
  for (Node node = to; node != no_node; node = found.before[node]) places.push_back(place(node));
  std::reverse(places.begin(), places.end());
  return places;
}

std::vector<double> ShortestWays::distances(std::span<const VertexId> sources) const {
  std::vector<double> lengths = search(sources, no_vertex).length;
  lengths.resize(mesh_.positions.size());
  return lengths;
}

}  // namespace knit
