#include "knit/curves/embed.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <set>

#include "knit/mesh/closest_point.h"
#include "knit/mesh/edge_table.h"

namespace knit {
namespace {

using Polygon = std::vector<VertexId>;

double twice_area(const Mesh& mesh, VertexId a, VertexId b, VertexId c) {
  const auto& p = mesh.positions;
  return glm::length(glm::cross(p[b] - p[a], p[c] - p[a]));
}

// The fan whose least triangle is greatest.
void add_fan(const Mesh& mesh, const Polygon& polygon, std::vector<Triangle>& out) {
  const std::size_t n = polygon.size();
  std::size_t best = 0;
  double greatest = -1.0;
  for (std::size_t turn = 0; turn < n; ++turn) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i + 1 < n; ++i)
      least = std::min(least,
                       twice_area(mesh, polygon[turn], polygon[(turn + i) % n], polygon[(turn + i + 1) % n]));
    if (least > greatest) {
      greatest = least;
      best = turn;
    }
  }
  for (std::size_t i = 1; i + 1 < n; ++i)
    out.push_back({polygon[best], polygon[(best + i) % n], polygon[(best + i + 1) % n]});
}

// Splits the first of the polygons that has both ends, if they are not neighbours there.
void split_along(std::vector<Polygon>& polygons, VertexId a, VertexId b) {
  for (Polygon& polygon : polygons) {
    const auto at_a = std::find(polygon.begin(), polygon.end(), a);
    const auto at_b = std::find(polygon.begin(), polygon.end(), b);
    if (at_a == polygon.end() || at_b == polygon.end()) continue;
    const auto first = std::min(at_a, at_b);
    const auto second = std::max(at_a, at_b);
    const auto gap = static_cast<std::size_t>(second - first);
    if (gap == 1 || gap + 1 == polygon.size()) return;
    Polygon one(first, second + 1);
    Polygon other(second, polygon.end());
    other.insert(other.end(), polygon.begin(), first + 1);
    polygon = std::move(one);
    polygons.push_back(std::move(other));
    return;
  }
}

// The places that are no vertices yet, by edge and then from its low end.
using NewOnEdges = std::map<EdgeKey, std::map<double, VertexId>>;

Polygon with_new(const Triangle& triangle, const NewOnEdges& made) {
  Polygon polygon;
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId a = triangle[k];
    const VertexId b = triangle[(k + 1) % 3];
    polygon.push_back(a);
    const auto found = made.find(edge_key(a, b));
    if (found == made.end()) continue;
    const std::size_t before = polygon.size();
    for (const auto& [along, vertex] : found->second) polygon.push_back(vertex);
    if (a > b) std::reverse(polygon.begin() + static_cast<std::ptrdiff_t>(before), polygon.end());
  }
  return polygon;
}

void split_triangles(Mesh& mesh, const NewOnEdges& made, const std::set<EdgeKey>& pieces) {
  std::map<VertexId, std::vector<VertexId>> from;
  for (const auto& [low, high] : pieces) from[low].push_back(high);
  std::vector<Triangle> out;
  out.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    std::vector<Polygon> polygons{with_new(triangle, made)};
    if (polygons.front().size() == 3) {
      out.push_back(triangle);
      continue;
    }
    const Polygon all = polygons.front();
    for (const VertexId a : all) {
      const auto found = from.find(a);
      if (found == from.end()) continue;
      for (const VertexId b : found->second) split_along(polygons, a, b);
    }
    for (const Polygon& polygon : polygons) add_fan(mesh, polygon, out);
  }
  mesh.triangles = std::move(out);
}

std::array<glm::dvec3, 3> corners_of(const Mesh& mesh, const Triangle& t) {
  return {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
}

struct NearestPlace {
  std::size_t triangle = 0;
  glm::dvec3 at{0.0};
};

NearestPlace nearest_place(const Mesh& mesh, const glm::dvec3& point) {
  NearestPlace nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::dvec3 at = closest_on_triangle(point, corners_of(mesh, mesh.triangles[t]));
    const double length = glm::length(at - point);
    if (length >= least) continue;
    least = length;
    nearest = {t, at};
  }
  return nearest;
}

}  // namespace

glm::dvec3 EdgePlace::position(const Mesh& mesh) const {
  if (vertex()) return mesh.positions[low];
  return (1.0 - along) * mesh.positions[low] + along * mesh.positions[high];
}

EdgePlace at_vertex(VertexId vertex) { return {vertex, vertex, 0.0}; }

EdgePlace on_edge(VertexId a, VertexId b, double from_a) {
  return a < b ? EdgePlace{a, b, from_a} : EdgePlace{b, a, 1.0 - from_a};
}

Mesh sewn(const Mesh& mesh) {
  Mesh out{.name = mesh.name, .positions = mesh.positions, .triangles = {}, .edges = {}};
  const std::vector<VertexId> twin = find_twins(mesh.positions);
  for (const Triangle& triangle : mesh.triangles) {
    const Triangle by_twins = twins_of(triangle, twin);
    if (!collapsed(by_twins)) out.triangles.push_back(by_twins);
  }
  return out;
}

std::vector<VertexId> embed(Mesh& mesh, std::span<const EdgePlace> places, bool closed) {
  NewOnEdges made;
  std::vector<VertexId> chain;
  for (const EdgePlace& place : places) {
    if (place.vertex()) {
      chain.push_back(place.low);
      continue;
    }
    const auto next = static_cast<VertexId>(mesh.positions.size());
    const auto [entry, fresh] = made[{place.low, place.high}].try_emplace(place.along, next);
    if (fresh) mesh.positions.push_back(place.position(mesh));
    chain.push_back(entry->second);
  }
  std::set<EdgeKey> pieces;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) pieces.insert(edge_key(chain[i], chain[i + 1]));
  if (closed) pieces.insert(edge_key(chain.back(), chain.front()));
  split_triangles(mesh, made, pieces);
  return chain;
}

VertexId insert_point(Mesh& mesh, const glm::dvec3& point) {
  const NearestPlace nearest = nearest_place(mesh, point);
  const Triangle t = mesh.triangles[nearest.triangle];
  const std::array<glm::dvec3, 3> corners = corners_of(mesh, t);
  double around = 0.0;
  std::size_t corner = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    around += glm::length(corners[k] - corners[(k + 1) % 3]);
    if (glm::length(corners[k] - nearest.at) < glm::length(corners[corner] - nearest.at)) corner = k;
  }
  if (glm::length(corners[corner] - nearest.at) < 0.05 * around / 3.0) return t[corner];
  const double whole = glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 side = corners[(k + 1) % 3] - corners[k];
    const double part = glm::length(glm::cross(side, nearest.at - corners[k]));
    if (part >= 0.02 * whole) continue;
    const double along =
        std::clamp(glm::dot(nearest.at - corners[k], side) / glm::dot(side, side), 0.02, 0.98);
    const EdgePlace place = on_edge(t[k], t[(k + 1) % 3], along);
    return embed(mesh, std::span(&place, 1), false).front();
  }
  const auto made = static_cast<VertexId>(mesh.positions.size());
  mesh.positions.push_back(nearest.at);
  mesh.triangles[nearest.triangle] = {t[0], t[1], made};
  mesh.triangles.push_back({t[1], t[2], made});
  mesh.triangles.push_back({t[2], t[0], made});
  return made;
}

EdgeKey edge_key(VertexId a, VertexId b) { return a < b ? EdgeKey{a, b} : EdgeKey{b, a}; }

std::vector<EdgeKey> edges_of(std::span<const Triangle> triangles) {
  std::vector<EdgeKey> edges;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(edge_key(t[k], t[(k + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<std::vector<VertexId>> boundary_rings(std::span<const Triangle> triangles) {
  std::set<EdgeKey> sides;  // as they run
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) sides.insert({t[k], t[(k + 1) % 3]});
  std::map<VertexId, std::vector<VertexId>> next;
  for (const auto& [a, b] : sides)
    if (!sides.contains({b, a})) next[a].push_back(b);
  std::vector<std::vector<VertexId>> rings;
  while (!next.empty()) {
    std::vector<VertexId> ring;
    VertexId at = next.begin()->first;
    for (auto found = next.begin(); found != next.end(); found = next.find(at)) {
      ring.push_back(at);
      at = found->second.back();
      found->second.pop_back();
      if (found->second.empty()) next.erase(found);
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace knit
