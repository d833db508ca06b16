#include "knit/import/check_topology.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>

#include "knit/mesh/edge_table.h"

namespace knit {

namespace {

struct Surface {
  std::span<const Triangle> triangles;
  std::span<const VertexId> twin;
  std::vector<HalfEdge> across;  // the next use of the same edge, round in a circle; itself at a boundary
  std::vector<std::uint8_t> crowded;  // per vertex: 1 if an edge of three or more triangles ends here

  [[nodiscard]] VertexId corner(std::size_t triangle, std::size_t k) const {
    return twin[triangles[triangle][k % 3]];
  }
  [[nodiscard]] VertexId origin(HalfEdge h) const { return corner(h / 3, h % 3); }
  [[nodiscard]] bool upward(HalfEdge h) const { return origin(h) < corner(h / 3, h % 3 + 1); }
};

using Edge = std::array<VertexId, 2>;

// Joins the uses of each edge into circles; collects the edges of one triangle and of more than two.
std::vector<Edge> link_edges(Surface& surface, Topology& topology) {
  const EdgeTable table = make_edge_table(surface.triangles, surface.twin);
  surface.across.resize(3 * surface.triangles.size());
  surface.crowded.assign(surface.twin.size(), 0);
  std::vector<Edge> open;
  for (std::size_t v = 0; v < surface.twin.size(); ++v) {
    for (std::uint32_t i = table.first[v], end = i; i < table.first[v + 1]; i = end) {
      while (end < table.first[v + 1] && table.uses[end].high == table.uses[i].high) ++end;
      for (std::uint32_t use = i; use < end; ++use)
        surface.across[table.uses[use].half_edge] = table.uses[use + 1 < end ? use + 1 : i].half_edge;
      const Edge edge{static_cast<VertexId>(v), table.uses[i].high};
      if (end - i == 1) open.push_back(edge);
      if (end - i > 2) {
        topology.crowded_edges.push_back(edge);
        surface.crowded[edge[0]] = surface.crowded[edge[1]] = 1;
      }
    }
  }
  return open;
}

// The lowest vertex of each connected set of edges, ascending.
std::vector<VertexId> lowest_of_each_loop(const std::vector<Edge>& edges) {
  std::vector<VertexId> vertices;
  for (const Edge& edge : edges) vertices.insert(vertices.end(), edge.begin(), edge.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

  std::vector<std::size_t> parent(vertices.size());
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = i;
  const auto root = [&](VertexId v) {
    auto i =
        static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& [a, b] : edges) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    parent[high] = low;
  }
  std::vector<VertexId> lowest;
  for (std::size_t i = 0; i < parent.size(); ++i)
    if (parent[i] == i) lowest.push_back(vertices[i]);
  return lowest;
}

// Floods each piece; a triangle's side says whether it must be flipped to agree with the piece's first.
void flood(const Surface& surface, Topology& topology) {
  constexpr std::uint8_t unseen = 2;
  const std::size_t count = surface.triangles.size();
  std::vector<std::uint8_t> side(count, unseen);
  std::vector<std::size_t> reached;
  for (std::size_t seed = 0; seed < count; ++seed) {
    if (side[seed] != unseen || collapsed(twins_of(surface.triangles[seed], surface.twin))) continue;
    SurfacePiece piece;
    std::size_t flipped = 0;
    side[seed] = 0;
    reached.assign(1, seed);
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const std::size_t t = reached[i];
      flipped += side[t];
      for (std::size_t k = 0; k < 3; ++k) {
        const auto h = static_cast<HalfEdge>(3 * t + k);
        const HalfEdge other = surface.across[h];
        piece.lowest = std::min(piece.lowest, surface.corner(t, k));
        if (other == h) continue;
        const bool agree = surface.upward(h) != surface.upward(other);
        const auto wanted = static_cast<std::uint8_t>(agree ? side[t] : 1 - side[t]);
        if (side[other / 3] == unseen) {
          side[other / 3] = wanted;
          reached.push_back(other / 3);
        } else if (side[other / 3] != wanted) {
          topology.one_sided_at = std::min(topology.one_sided_at, surface.corner(t, k));
        }
      }
    }
    piece.triangles = reached.size();
    const std::uint8_t fewer = 2 * flipped <= reached.size() ? 1 : 0;
    for (const std::size_t t : reached)
      if (side[t] == fewer) topology.minority.push_back(t);
    topology.pieces.push_back(piece);
  }
  std::sort(topology.minority.begin(), topology.minority.end());
}

// Walks the fan of triangles around the vertex at corner `start` of its triangle, beginning across `exit`,
// one of that corner's two sides. Returns how many further triangles there are, and whether it came back
// round.
std::size_t walk_fan(const Surface& surface, HalfEdge start, HalfEdge exit, bool& closed) {
  const VertexId vertex = surface.origin(start);
  std::size_t passed = 0;
  for (HalfEdge out = exit;;) {
    const HalfEdge in = surface.across[out];
    closed = in / 3 == start / 3;
    if (closed || in == out) break;
    ++passed;
    const HalfEdge base = in / 3 * 3;
    out = surface.origin(in) == vertex ? base + (in % 3 + 2) % 3 : base + (in % 3 + 1) % 3;
  }
  // An edge of one triangle leads back to that triangle too, yet it is a border.
  closed = closed && !(passed == 0 && surface.across[exit] == exit);
  return passed;
}

void find_pinched(const Surface& surface, Topology& topology) {
  std::vector<std::uint32_t> corners(surface.twin.size(), 0);
  std::vector<HalfEdge> first(surface.twin.size(), UINT32_MAX);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (collapsed(twins_of(surface.triangles[t], surface.twin))) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId v = surface.corner(t, k);
      if (corners[v]++ == 0) first[v] = static_cast<HalfEdge>(3 * t + k);
    }
  }
  for (std::size_t v = 0; v < corners.size(); ++v) {
    if (corners[v] == 0 || surface.crowded[v]) continue;
    const HalfEdge start = first[v];
    bool closed = false;
    std::size_t fan = 1 + walk_fan(surface, start, start, closed);
    if (!closed) fan += walk_fan(surface, start, start / 3 * 3 + (start % 3 + 2) % 3, closed);
    if (fan != corners[v]) topology.pinched.push_back(static_cast<VertexId>(v));
  }
}

}  // namespace

Topology study_topology(std::span<const Triangle> triangles, std::span<const VertexId> twin) {
  Topology topology;
  Surface surface{triangles, twin, {}, {}};
  const std::vector<Edge> open = link_edges(surface, topology);
  topology.open_edges = open.size();
  topology.holes = lowest_of_each_loop(open);
  flood(surface, topology);
  find_pinched(surface, topology);
  return topology;
}

std::size_t handles_of(const Input& input) {
  std::ptrdiff_t vertices = 0;
  for (const HalfEdge corner : input.first_corner) vertices += corner != no_half_edge ? 1 : 0;
  std::ptrdiff_t sides = 0;
  for (const HalfEdge other : input.across) sides += other != no_half_edge ? 1 : 0;
  // Each rim closed by a cone: as many triangles and edges as it has vertices, and the apex.
  for (const MeshRim& rim : input.rims) {
    ++vertices;
    sides += 4 * static_cast<std::ptrdiff_t>(rim.vertices.size());
  }
  // A triangle has three sides, an edge two.
  const std::ptrdiff_t euler = vertices - sides / 2 + sides / 3;
  return euler < 2 ? static_cast<std::size_t>(2 - euler) / 2 : 0;
}

double signed_volume(const Mesh& mesh, const Bounds& bounds) {
  const glm::dvec3 centre = bounds.centre();
  const double scale = 1.0 / bounds.diagonal();
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 a = (mesh.positions[t[0]] - centre) * scale;
    const glm::dvec3 b = (mesh.positions[t[1]] - centre) * scale;
    const glm::dvec3 c = (mesh.positions[t[2]] - centre) * scale;
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum / 6.0;
}

Bounds bounds_of_used(const Mesh& mesh) {
  std::vector<glm::dvec3> corners;
  corners.reserve(mesh.positions.size());
  std::vector<std::uint8_t> used(mesh.positions.size(), 0);
  for (const Triangle& triangle : mesh.triangles)
    for (const VertexId v : triangle) used[v] = 1;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v] != 0) corners.push_back(mesh.positions[v]);
  return bounds_of(corners);
}

}  // namespace knit
