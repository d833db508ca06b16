#include "knit/mesh/evening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "knit/mesh/edge_table.h"

namespace knit {

namespace {

using TriangleId = std::uint32_t;

glm::dvec3 onto_rim(const Rim& rim, const glm::dvec3& place) {
  const double part = rim.radius / std::sqrt(place.x * place.x + place.z * place.z);
  return {part * place.x, rim.y, part * place.z};
}

// Cuts the triangles that lie across the rim, near it in height, so that it runs along edges. What is added comes last.
// Invariant: of a triangle's three sides two cross the cylinder above the rim or none; both triangles of a side get the
// same new vertex.
Mesh cut_along(const Mesh& mesh, const Rim& rim, double nearness) {
  Mesh made = mesh;
  made.triangles.clear();
  std::map<std::array<VertexId, 2>, VertexId> on_side;
  const auto beyond = [&](VertexId v) {
    const glm::dvec3& p = mesh.positions[v];
    return p.x * p.x + p.z * p.z > rim.radius * rim.radius;
  };
  const auto crossing = [&](VertexId a, VertexId b) {
    const auto [at, is_new] = on_side.try_emplace({std::min(a, b), std::max(a, b)}, no_vertex);
    if (is_new) {
      at->second = static_cast<VertexId>(made.positions.size());
      made.positions.push_back(onto_rim(rim, 0.5 * (mesh.positions[a] + mesh.positions[b])));
    }
    return at->second;
  };
  for (const Triangle& t : mesh.triangles) {
    const auto high = [&](VertexId v) { return mesh.positions[v].y > rim.y - nearness; };
    std::size_t k = 0;  // the corner that is alone on its side
    while (k < 3 && (beyond(t[k]) == beyond(t[(k + 1) % 3]) || beyond(t[k]) == beyond(t[(k + 2) % 3]))) ++k;
    if (k == 3 || !std::all_of(t.begin(), t.end(), high)) {
      made.triangles.push_back(t);
      continue;
    }
    const VertexId next = t[(k + 1) % 3];
    const VertexId last = t[(k + 2) % 3];
    const VertexId p = crossing(t[k], next);
    const VertexId q = crossing(t[k], last);
    made.triangles.insert(made.triangles.end(), {Triangle{t[k], p, q}, {p, next, last}, {p, last, q}});
  }
  return made;
}

// A closed mesh that changes: triangles, and per vertex those around it. What has gone is empty or marked.
// Invariant of the rim, if there is one: its vertices are a cycle of edges, and no other edge joins two of them.
class Net {
 public:
  // Of the mesh's vertices those from `first_of_rim` on are on the rim.
  Net(const Mesh& mesh, const Solid& solid, const std::optional<Rim>& rim, std::size_t first_of_rim);

  // Draws short edges together, the shortest first, until none is left that may go. Returns how many went.
  std::size_t collapse(double shortest, double longest);
  // Turns edges until the angles across each add up to half a turn at most.
  void flip();
  // Moves vertices towards the middle of their neighbours, along the surface.
  void relax(int newton);
  [[nodiscard]] Mesh mesh(const std::string& name) const;

 private:
  struct Side {
    TriangleId triangle = 0;
    VertexId opposite = 0;  // the corner that is not on the edge
  };

  [[nodiscard]] glm::dvec3 normal(const Triangle& t) const {
    return glm::cross(positions_[t[1]] - positions_[t[0]], positions_[t[2]] - positions_[t[0]]);
  }
  [[nodiscard]] std::vector<VertexId> neighbours(VertexId v) const;
  // The triangle that runs along the edge from a to b, if there is such an edge.
  [[nodiscard]] std::optional<Side> side(VertexId a, VertexId b) const;
  [[nodiscard]] bool may_move(VertexId v, VertexId but_for, const glm::dvec3& to, double longest) const;
  [[nodiscard]] bool may_collapse(VertexId a, VertexId b, const glm::dvec3& to, double longest) const;
  [[nodiscard]] bool keeps_rim(VertexId a, VertexId b) const;
  [[nodiscard]] glm::dvec3 meeting_place(VertexId a, VertexId b) const;
  [[nodiscard]] glm::dvec3 relaxed(VertexId v, int newton) const;
  [[nodiscard]] std::vector<VertexId> around_rim() const;
  void draw_together(VertexId a, VertexId b, const glm::dvec3& to);
  bool flip_if_better(VertexId a, VertexId b);
  void forget(VertexId v, TriangleId t) { std::erase(around_[v], t); }

  const Solid& solid_;
  std::optional<Rim> rim_;
  std::vector<glm::dvec3> positions_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint8_t> gone_;    // per triangle
  std::vector<std::uint8_t> on_rim_;  // per vertex
  std::vector<std::vector<TriangleId>> around_;
};

Net::Net(const Mesh& mesh, const Solid& solid, const std::optional<Rim>& rim, std::size_t first_of_rim)
    : solid_(solid),
      rim_(rim),
      positions_(mesh.positions),
      triangles_(mesh.triangles),
      gone_(mesh.triangles.size(), 0),
      on_rim_(mesh.positions.size(), 0),
      around_(mesh.positions.size()) {
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (const VertexId v : triangles_[t]) around_[v].push_back(static_cast<TriangleId>(t));
  std::fill(on_rim_.begin() + static_cast<std::ptrdiff_t>(first_of_rim), on_rim_.end(), std::uint8_t{1});
  for (std::size_t v = 0; v < first_of_rim; ++v) positions_[v] = onto_surface(solid_, positions_[v], 1);
}

std::vector<VertexId> Net::neighbours(VertexId v) const {
  std::vector<VertexId> found;
  for (const TriangleId t : around_[v])
    for (const VertexId other : triangles_[t])
      if (other != v) found.push_back(other);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::optional<Net::Side> Net::side(VertexId a, VertexId b) const {
  for (const TriangleId t : around_[a]) {
    const Triangle& corners = triangles_[t];
    for (std::size_t k = 0; k < 3; ++k)
      if (corners[k] == a && corners[(k + 1) % 3] == b) return Side{t, corners[(k + 2) % 3]};
  }
  return std::nullopt;
}

// Whether the triangles of v that do not have the other vertex too keep facing the same way and grow no edge longer
// than `longest`.
bool Net::may_move(VertexId v, VertexId but_for, const glm::dvec3& to, double longest) const {
  for (const TriangleId t : around_[v]) {
    const Triangle& corners = triangles_[t];
    std::size_t k = 0;
    while (corners[k] != v) ++k;
    const VertexId next = corners[(k + 1) % 3];
    const VertexId last = corners[(k + 2) % 3];
    if (next == but_for || last == but_for) continue;
    const glm::dvec3 before = normal(corners);
    const glm::dvec3 after = glm::cross(positions_[next] - to, positions_[last] - to);
    if (!(glm::dot(before, after) > 0.5 * glm::length(before) * glm::length(after))) return false;
    if (glm::distance(to, positions_[next]) > longest) return false;
  }
  return true;
}

// Where one of two is on the rim and takes in the other: that other has no neighbours there that the first has not, so
// no edge comes to lie across.
bool Net::keeps_rim(VertexId a, VertexId b) const {
  if (on_rim_[a] == on_rim_[b]) return true;
  const VertexId rim = on_rim_[a] != 0 ? a : b;
  const std::vector<VertexId> others = neighbours(rim == a ? b : a);
  return std::all_of(others.begin(), others.end(),
                     [&](VertexId v) { return on_rim_[v] == 0 || v == rim || side(v, rim).has_value(); });
}

glm::dvec3 Net::meeting_place(VertexId a, VertexId b) const {
  const glm::dvec3 middle = 0.5 * (positions_[a] + positions_[b]);
  if (on_rim_[a] != 0 && on_rim_[b] != 0) return onto_rim(*rim_, middle);
  if (on_rim_[a] != on_rim_[b]) return positions_[on_rim_[a] != 0 ? a : b];
  return onto_surface(solid_, middle, 1);
}

// The link condition: a and b have just the two neighbours in common that their two triangles have, so no handle is
// closed and no two triangles fall onto each other.
bool Net::may_collapse(VertexId a, VertexId b, const glm::dvec3& to, double longest) const {
  const std::vector<VertexId> of_a = neighbours(a);
  const std::vector<VertexId> of_b = neighbours(b);
  std::vector<VertexId> common;
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(common));
  if (common.size() != 2) return false;
  for (const VertexId v : common)
    if (around_[v].size() <= 4) return false;
  return keeps_rim(a, b) && may_move(a, b, to, longest) && may_move(b, a, to, longest);
}

void Net::draw_together(VertexId a, VertexId b, const glm::dvec3& to) {
  const std::vector<TriangleId> of_b = std::move(around_[b]);
  around_[b].clear();
  for (const TriangleId t : of_b) {
    Triangle& corners = triangles_[t];
    if (std::find(corners.begin(), corners.end(), a) != corners.end()) {
      gone_[t] = 1;
      for (const VertexId v : corners)
        if (v != b) forget(v, t);
    } else {
      std::replace(corners.begin(), corners.end(), b, a);
      around_[a].push_back(t);
    }
  }
  positions_[a] = to;
  on_rim_[a] = std::max(on_rim_[a], on_rim_[b]);
}

std::size_t Net::collapse(double shortest, double longest) {
  std::vector<std::tuple<double, VertexId, VertexId>> edges;  // all different: their order is one
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (gone_[t] != 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId a = triangles_[t][k];
      const VertexId b = triangles_[t][(k + 1) % 3];
      const double length = glm::distance(positions_[a], positions_[b]);
      if (a < b && length < shortest) edges.emplace_back(length, a, b);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::size_t count = 0;
  for (const auto& [was, a, b] : edges) {
    if (!side(a, b) || glm::distance(positions_[a], positions_[b]) >= shortest) continue;
    const glm::dvec3 to = meeting_place(a, b);
    if (!may_collapse(a, b, to, longest)) continue;
    draw_together(a, b, to);
    ++count;
  }
  return count;
}

// The angles at c and d across the edge a b add up to more than half a turn when the sum of their cotangents is
// negative. No edge is made that exists already, nothing folds
// over, and the rim stays.
bool Net::flip_if_better(VertexId a, VertexId b) {
  const std::optional<Side> left = side(a, b);
  const std::optional<Side> right = side(b, a);
  if (!left || !right) return false;
  const VertexId c = left->opposite;
  const VertexId d = right->opposite;
  const auto cotangent = [&](VertexId at) {
    const glm::dvec3 to_a = positions_[a] - positions_[at];
    const glm::dvec3 to_b = positions_[b] - positions_[at];
    return glm::dot(to_a, to_b) / glm::length(glm::cross(to_a, to_b));
  };
  if (!(cotangent(c) + cotangent(d) < -1e-9)) return false;
  if ((on_rim_[a] != 0 && on_rim_[b] != 0) || (on_rim_[c] != 0 && on_rim_[d] != 0)) return false;
  if (around_[a].size() <= 4 || around_[b].size() <= 4 || side(c, d) || side(d, c)) return false;
  const Triangle first{a, d, c};
  const Triangle second{d, b, c};
  const glm::dvec3 before = normal(triangles_[left->triangle]) + normal(triangles_[right->triangle]);
  for (const Triangle& made : {first, second}) {
    const glm::dvec3 after = normal(made);
    if (!(glm::dot(before, after) > 0.5 * glm::length(before) * glm::length(after))) return false;
  }
  triangles_[left->triangle] = first;
  triangles_[right->triangle] = second;
  forget(b, left->triangle);
  around_[d].push_back(left->triangle);
  forget(a, right->triangle);
  around_[c].push_back(right->triangle);
  return true;
}

void Net::flip() {
  constexpr int most =
      10;  // flips in the plane end by themselves; on a curved surface two could undo each other
  bool changed = true;
  for (int pass = 0; pass < most && changed; ++pass) {
    changed = false;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < 3 && gone_[t] == 0; ++k)
        changed = flip_if_better(triangles_[t][k], triangles_[t][(k + 1) % 3]) || changed;
    }
  }
}

// p <- p + 0.7 (m - p) along the surface, m the mean of the neighbours; then back onto it. On the rim only neighbours
// there count.
glm::dvec3 Net::relaxed(VertexId v, int newton) const {
  const bool of_rim = on_rim_[v] != 0;
  glm::dvec3 sum(0.0);
  glm::dvec3 out(0.0);
  double count = 0.0;
  for (const TriangleId t : around_[v]) {  // each neighbour is in two of them
    out += normal(triangles_[t]);
    for (const VertexId other : triangles_[t]) {
      if (other == v || (of_rim && on_rim_[other] == 0)) continue;
      sum += positions_[other];
      count += 1.0;
    }
  }
  const glm::dvec3 way = sum / count - positions_[v];
  if (of_rim) return onto_rim(*rim_, positions_[v] + 0.7 * way);
  const double square = glm::dot(out, out);
  if (!(square > 0.0)) return positions_[v];
  const glm::dvec3 along = way - out * (glm::dot(out, way) / square);
  return onto_surface(solid_, positions_[v] + 0.7 * along, newton);
}

// All from the old places.
void Net::relax(int newton) {
  std::vector<glm::dvec3> moved = positions_;
  for (std::size_t v = 0; v < positions_.size(); ++v)
    if (!around_[v].empty()) moved[v] = relaxed(static_cast<VertexId>(v), newton);
  positions_ = std::move(moved);
}

// The rim's vertices in order.
std::vector<VertexId> Net::around_rim() const {
  std::vector<VertexId> order;
  std::vector<std::uint8_t> met(positions_.size(), 0);
  std::size_t first = 0;
  while (first < positions_.size() && (on_rim_[first] == 0 || around_[first].empty())) ++first;
  std::optional<VertexId> at;
  if (first < positions_.size()) at = static_cast<VertexId>(first);
  while (at) {
    order.push_back(*at);
    met[*at] = 1;
    const std::vector<VertexId> beside = neighbours(*at);
    const auto next = std::find_if(beside.begin(), beside.end(),
                                   [&](VertexId v) { return on_rim_[v] != 0 && met[v] == 0; });
    at = next == beside.end() ? std::nullopt : std::optional(*next);
  }
  return order;
}

Mesh Net::mesh(const std::string& name) const {
  Mesh made;
  made.name = name;
  std::vector<VertexId> number(positions_.size(), no_vertex);
  const auto add = [&](VertexId v) {
    number[v] = static_cast<VertexId>(made.positions.size());
    made.positions.push_back(positions_[v] + 0.0);  // never -0
  };
  for (std::size_t v = 0; v < positions_.size(); ++v)
    if (!around_[v].empty() && on_rim_[v] == 0) add(static_cast<VertexId>(v));
  for (const VertexId v : around_rim()) add(v);
  std::vector<std::array<VertexId, 2>> edges;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (gone_[t] != 0) continue;
    Triangle corners = triangles_[t];
    for (VertexId& v : corners) v = number[v];
    made.triangles.push_back(corners);
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({corners[k], corners[(k + 1) % 3]});
  }
  made.edges = unique_edges(edges, made.positions.size());
  return made;
}

}  // namespace

// Short edges go, edges turn, vertices move, a few times over; the last rounds only move and turn.
// Invariant: after every single change the mesh is closed, manifold and of the same genus.
Mesh evened(const Mesh& mesh, const Solid& solid, double edge, const std::optional<Rim>& rim) {
  const Mesh cut = rim ? cut_along(mesh, *rim, 2.0 * edge) : mesh;
  Net net(cut, solid, rim, mesh.positions.size());
  for (int round = 0; round < 4; ++round) {
    while (net.collapse(0.78 * edge, 1.5 * edge) > 0) {
    }
    net.flip();
    for (int i = 0; i < 2; ++i) net.relax(1);
  }
  for (int round = 0; round < 3; ++round) {
    net.flip();
    net.relax(1);
  }
  net.flip();
  net.relax(3);
  return net.mesh(mesh.name);
}

}  // namespace knit
