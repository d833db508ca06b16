#include "knit/curves/cut.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "knit/curves/embed.h"
#include "knit/curves/level_loop.h"
#include "knit/curves/refused.h"
#include "knit/curves/shortest_way.h"
#include "knit/mesh/closest_point.h"
#include "knit/mesh/surface_distance.h"

namespace knit {
namespace {

using Ring = std::vector<VertexId>;
constexpr double infinite = std::numeric_limits<double>::infinity();

// The clicks' nearest places on the surface.
std::vector<glm::dvec3> on_surface(const Mesh& mesh, const Cycle& cycle, const CutSizes& sizes) {
  std::vector<glm::dvec3> places;
  for (const glm::dvec3& point : cycle.points) {
    double least = infinite;
    glm::dvec3 nearest = point;
    for (const Triangle& t : mesh.triangles) {
      const glm::dvec3 at =
          closest_on_triangle(point, {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
      const double length = glm::length(at - point);
      if (length >= least) continue;
      least = length;
      nearest = at;
    }
    places.push_back(nearest);
    if (least <= 0.01 * sizes.diagonal) continue;
    throw CurveRefused(called(cycle) + ": point " + std::to_string(places.size()) + " is " +
                       three_digits(least) + " away from the surface, more than 1 % of its size (" +
                       three_digits(0.01 * sizes.diagonal) + "). Was the mesh moved or scaled?");
  }
  return places;
}

Ring cut_boundary(const Mesh& mesh, const Cycle& cycle, const CutSizes& sizes,
                  const std::vector<glm::dvec3>& places) {
  const std::vector<Ring> rings = boundary_rings(mesh.triangles);
  if (rings.empty()) throw CurveRefused(called(cycle) + ": the mesh has no edge; it is closed.");
  // How far it is from the click, or how high it lies.
  const auto rank = [&](const Ring& ring) {
    double least = infinite;
    double height = 0.0;
    for (const VertexId v : ring) {
      if (!places.empty()) least = std::min(least, glm::length(mesh.positions[v] - places.front()));
      height += glm::dot(mesh.positions[v], sizes.up) / static_cast<double>(ring.size());
    }
    return places.empty() ? height : least;
  };
  return *std::min_element(rings.begin(), rings.end(),
                           [&](const Ring& a, const Ring& b) { return rank(a) < rank(b); });
}

[[noreturn]] void refuse_touching_edge(const Cycle& cycle) {
  throw CurveRefused(called(cycle) + ": a cycle may not touch an edge of the mesh.");
}

Ring cut_at_level(Mesh& mesh, const Cycle& cycle, const std::vector<double>& values, double level,
                  const glm::dvec3& near) {
  const LevelLines lines = level_lines(mesh, values, level);
  const auto nearest_of = [&](const std::vector<std::vector<EdgePlace>>& all) {
    std::pair<double, const std::vector<EdgePlace>*> nearest{infinite, nullptr};
    for (const std::vector<EdgePlace>& line : all)
      for (const EdgePlace& place : line)
        nearest = std::min(nearest, {glm::length(place.position(mesh) - near), &line},
                           [](const auto& a, const auto& b) { return a.first < b.first; });
    return nearest;
  };
  const auto [ring_away, ring] = nearest_of(lines.rings);
  const auto [open_away, open] = nearest_of(lines.open);
  if (open != nullptr && (ring == nullptr || open_away < ring_away)) refuse_touching_edge(cycle);
  if (ring == nullptr) throw CurveRefused(called(cycle) + ": the cut meets no part of the surface.");
  return embed(mesh, *ring, true);
}

// From the nearest of `sources`, exact up to a bit beyond `radius`.
std::vector<double> exact_distances(const Mesh& mesh, const Ring& sources, double radius) {
  double longest = 0.0;
  for (const auto& [a, b] : edges_of(mesh.triangles))
    longest = std::max(longest, glm::length(mesh.positions[a] - mesh.positions[b]));
  const std::shared_ptr<const Input> input = make_input(mesh);
  Ring all(mesh.positions.size());
  std::iota(all.begin(), all.end(), 0U);
  std::vector<double> least(all.size(), not_reached);
  for (const VertexId source : sources) {
    const std::vector<double> found = surface_distances(*input, source, all, radius + 2.0 * longest);
    for (std::size_t v = 0; v < all.size(); ++v) least[v] = std::min(least[v], found[v]);
  }
  return least;
}

Ring cut_at_distance(Mesh& mesh, const Cycle& cycle, const Ring& sources, double radius) {
  if (radius <= 0.0) throw CurveRefused(called(cycle) + ": the radius must be above 0.");
  const glm::dvec3 near = mesh.positions[sources.front()];
  const std::vector<double> values = exact_distances(mesh, sources, radius);
  double farthest = 0.0;
  for (const double value : values)
    if (value != not_reached) farthest = std::max(farthest, value);
  if (radius >= farthest)
    throw CurveRefused(called(cycle) + ": the radius " + three_digits(radius) +
                       " reaches beyond the farthest point of the surface (" + three_digits(farthest) + ").");
  return cut_at_level(mesh, cycle, values, radius, near);
}

// Shortest ways from each of `through` to the next; each place once, a closed line's last not joined.
std::vector<EdgePlace> line_through(const Mesh& mesh, const Ring& through, bool closed) {
  const ShortestWays ways(mesh);
  std::vector<EdgePlace> line;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < through.size(); ++i) {
    const VertexId from = through[i];
    const VertexId to = through[(i + 1) % through.size()];
    if (from == to) continue;
    const std::vector<EdgePlace> way = ways.way(from, to);
    if (way.empty()) throw CurveRefused("Points on different pieces of the mesh cannot be joined.");
    line.insert(line.end(), way.begin(), way.end() - 1);
  }
  if (!closed) line.push_back(at_vertex(through.back()));
  return line;
}

Ring inserted(Mesh& mesh, const std::vector<glm::dvec3>& places) {
  Ring through;
  for (const glm::dvec3& place : places) through.push_back(insert_point(mesh, place));
  return through;
}

Ring cut_band(Mesh& mesh, const Cycle& cycle, const std::vector<glm::dvec3>& places) {
  const double radius = cycle.radius.value_or(0.0);
  if (radius <= 0.0) throw CurveRefused(called(cycle) + ": the radius must be above 0.");
  if (places.empty()) throw CurveRefused(called(cycle) + ": a band needs a point at least.");
  const Ring through = inserted(mesh, places);
  const Ring line = embed(mesh, line_through(mesh, through, false), false);
  return cut_at_distance(mesh, cycle, line, radius);
}

Ring cut_plane(Mesh& mesh, const Cycle& cycle, const std::vector<glm::dvec3>& places) {
  if (places.empty() || (!cycle.normal && places.size() != 3))
    throw CurveRefused(called(cycle) + ": a plane needs 3 points, or a point and a normal.");
  const glm::dvec3 normal =
      cycle.normal ? *cycle.normal : glm::cross(places[1] - places[0], places[2] - places[0]);
  const double length = glm::length(normal);
  const double size = cycle.normal ? 1.0 : glm::dot(places[1] - places[0], places[1] - places[0]);
  if (length <= 1e-9 * size)
    throw CurveRefused(called(cycle) + (cycle.normal ? ": a normal without length gives no plane."
                                                     : ": three points on one line give no plane."));
  std::vector<double> values;
  for (const glm::dvec3& position : mesh.positions) values.push_back(glm::dot(position, normal / length));
  return cut_at_level(mesh, cycle, values, glm::dot(places[0], normal / length), places[0]);
}

Ring cut_path(Mesh& mesh, const Cycle& cycle, const std::vector<glm::dvec3>& places) {
  if (places.size() < 3) throw CurveRefused(called(cycle) + ": a closed path needs at least 3 points.");
  const std::vector<EdgePlace> line = line_through(mesh, inserted(mesh, places), true);
  std::set<EdgePlace> met;
  for (const EdgePlace& place : line)
    if (!met.insert(place).second)
      throw CurveRefused(called(cycle) + ": the path meets itself near " + place_text(place.position(mesh)) +
                         ". Set the points in their order round the shape.");
  if (line.size() < 3) throw CurveRefused(called(cycle) + ": the points of the path lie too near together.");
  Ring ring = embed(mesh, line, true);
  const std::vector<EdgeKey> edges = edges_of(mesh.triangles);
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (!std::binary_search(edges.begin(), edges.end(), edge_key(ring[i], ring[(i + 1) % ring.size()])))
      throw CurveRefused(called(cycle) +
                         ": the path crosses itself. Set the points in their order round the shape.");
  return ring;
}

Ring cut_vertex(Mesh& mesh, const Cycle& cycle, const CutSizes& sizes) {
  if (cycle.vertex >= mesh.positions.size())
    throw CurveRefused(called(cycle) + ": the mesh has no vertex " + std::to_string(cycle.vertex) + ".");
  const VertexId vertex = find_twins(mesh.positions)[cycle.vertex];
  return cut_at_distance(mesh, cycle, {vertex}, cycle.radius.value_or(sizes.radius));
}

// Whatever is no edge of the mesh already.
Ring cut_inside(Mesh& mesh, const Cycle& cycle, const CutSizes& sizes,
                const std::vector<glm::dvec3>& places) {
  switch (cycle.kind) {
    case CycleKind::band:
      return cut_band(mesh, cycle, places);
    case CycleKind::plane:
      return cut_plane(mesh, cycle, places);
    case CycleKind::path:
      return cut_path(mesh, cycle, places);
    case CycleKind::vertex:
      return cut_vertex(mesh, cycle, sizes);
    default:
      break;
  }
  if (places.size() != 1) throw CurveRefused(called(cycle) + ": a circle needs a point.");
  const double radius = cycle.radius.value_or(sizes.radius);
  if (radius <= 0.0) throw CurveRefused(called(cycle) + ": the radius must be above 0.");
  return cut_at_distance(mesh, cycle, inserted(mesh, places), radius);
}

}  // namespace

std::vector<VertexId> cut_cycle(Mesh& mesh, const Cycle& cycle, const CutSizes& sizes) {
  const std::vector<glm::dvec3> places = on_surface(mesh, cycle, sizes);
  if (cycle.kind == CycleKind::boundary) return cut_boundary(mesh, cycle, sizes, places);
  std::vector<VertexId> ring = cut_inside(mesh, cycle, sizes, places);
  const std::set<VertexId> on_ring(ring.begin(), ring.end());
  for (const Ring& edge : boundary_rings(mesh.triangles))
    if (std::any_of(edge.begin(), edge.end(), [&](VertexId v) { return on_ring.contains(v); }))
      refuse_touching_edge(cycle);
  return ring;
}

}  // namespace knit
