#include "knit/short_rows/tube_part.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "knit/mesh/outside.h"
#include "knit/mesh/union_find.h"
#include "knit/short_rows/sides.h"

namespace knit {

namespace {

constexpr double least_share = 0.03;     // of an edge, between a cut point and its ends
constexpr double longest_edge = 1.2;     // stitch widths
constexpr std::size_t most_probes = 32;  // points of a curve that tell which loop it is

using Edge = std::array<VertexId, 2>;  // the lower number first
Edge edge_of(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

// Edges that get a new point each, rising.
struct NewPoints {
  std::vector<Edge> edges;
  VertexId first = 0;
  [[nodiscard]] VertexId at(VertexId a, VertexId b) const {
    const auto found = std::lower_bound(edges.begin(), edges.end(), edge_of(a, b));
    if (found == edges.end() || *found != edge_of(a, b)) return no_vertex;
    return first + static_cast<VertexId>(found - edges.begin());
  }
};

// A triangle that a loop crosses, turned so that its first corner is alone on its side.
Triangle alone_first(const Triangle& triangle, const std::vector<double>& field, double value) {
  const auto above = [&](std::size_t k) { return field[triangle[k % 3]] >= value; };
  for (std::size_t k = 0; k < 3; ++k) {
    if (above(k) != above(k + 1) && above(k) != above(k + 2))
      return {triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]};
  }
  return triangle;
}

bool crosses(const Triangle& triangle, const std::vector<double>& field, double value) {
  const bool above = field[triangle[0]] >= value;
  return (field[triangle[1]] >= value) != above || (field[triangle[2]] >= value) != above;
}

// Triangles that a level crosses, loop by loop.
std::vector<std::vector<std::uint32_t>> loops_at(const std::vector<Triangle>& triangles,
                                                 const std::vector<double>& field, double value) {
  struct CrossedEdge {
    Edge edge;
    std::uint32_t number;
  };
  std::vector<std::uint32_t> crossed;
  std::vector<CrossedEdge> crossings;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!crosses(triangles[t], field, value)) continue;
    const Triangle f = alone_first(triangles[t], field, value);
    const auto number = static_cast<std::uint32_t>(crossed.size());
    crossings.push_back({edge_of(f[0], f[1]), number});
    crossings.push_back({edge_of(f[0], f[2]), number});
    crossed.push_back(t);
  }
  std::sort(crossings.begin(), crossings.end(), [](const CrossedEdge& a, const CrossedEdge& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.number < b.number;
  });
  UnionFind joined(crossed.size());
  for (std::size_t i = 1; i < crossings.size(); ++i)
    if (crossings[i].edge == crossings[i - 1].edge) joined.join(crossings[i].number, crossings[i - 1].number);
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<std::size_t> loop_of(crossed.size(), SIZE_MAX);
  for (std::uint32_t i = 0; i < crossed.size(); ++i) {
    std::size_t& loop = loop_of[joined.find(i)];
    if (loop == SIZE_MAX) {
      loop = loops.size();
      loops.emplace_back();
    }
    loops[loop].push_back(crossed[i]);
  }
  return loops;
}

// What a triangle becomes whose edges have points in their middle, or none; of two ways the one with the shorter edge.
void add_parts(Triangle f, const NewPoints& halves, std::span<const glm::dvec3> points,
               std::vector<Triangle>& made) {
  std::array<VertexId, 3> half{};
  const auto find_halves = [&] {
    for (std::size_t k = 0; k < 3; ++k) half[k] = halves.at(f[k], f[(k + 1) % 3]);
  };
  find_halves();
  const auto count = 3 - std::count(half.begin(), half.end(), no_vertex);
  if (count == 0) return made.push_back(f);
  if (count == 3) {
    made.insert(made.end(), {{f[0], half[0], half[2]},
                             {half[0], f[1], half[1]},
                             {half[2], half[1], f[2]},
                             {half[0], half[1], half[2]}});
    return;
  }
  while (half[0] == no_vertex || (count == 2 && half[1] == no_vertex)) {
    f = {f[1], f[2], f[0]};
    find_halves();
  }
  const auto& [a, b, c] = f;
  if (count == 1) {
    made.insert(made.end(), {{a, half[0], c}, {half[0], b, c}});
    return;
  }
  made.push_back({half[0], b, half[1]});
  if (glm::length(points[a] - points[half[1]]) < glm::length(points[half[0]] - points[c])) {
    made.insert(made.end(), {{a, half[0], half[1]}, {a, half[1], c}});
  } else {
    made.insert(made.end(), {{a, half[0], c}, {half[0], half[1], c}});
  }
}

// Halves edges that are too long, all at once, until none is. The surface stays.
void halve_long_edges(std::vector<glm::dvec3>& points, std::vector<Triangle>& triangles, double longest) {
  while (true) {
    NewPoints halves{{}, static_cast<VertexId>(points.size())};
    for (const Triangle& f : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (glm::length(points[f[k]] - points[f[(k + 1) % 3]]) > longest)
          halves.edges.push_back(edge_of(f[k], f[(k + 1) % 3]));
      }
    }
    if (halves.edges.empty()) return;
    std::sort(halves.edges.begin(), halves.edges.end());
    halves.edges.erase(std::unique(halves.edges.begin(), halves.edges.end()), halves.edges.end());
    for (const auto& [a, b] : halves.edges) points.push_back(0.5 * (points[a] + points[b]));
    std::vector<Triangle> made;
    for (const Triangle& f : triangles) add_parts(f, halves, points, made);
    triangles = std::move(made);
  }
}

// Keeps the points that are used, in their order.
void drop_unused(std::vector<glm::dvec3>& points, std::vector<Triangle>& triangles) {
  std::vector<VertexId> number(points.size(), no_vertex);
  for (const Triangle& f : triangles)
    for (const VertexId v : f) number[v] = 0;
  std::vector<glm::dvec3> kept;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (number[v] == no_vertex) continue;
    number[v] = static_cast<VertexId>(kept.size());
    kept.push_back(points[v]);
  }
  points = std::move(kept);
  for (Triangle& f : triangles)
    for (VertexId& v : f) v = number[v];
}

// Two rims, no handle, one piece.
bool is_annulus(std::size_t points, std::size_t triangles, const std::vector<HalfEdge>& across,
                std::size_t rims) {
  const auto on_rim = static_cast<std::size_t>(std::count(across.begin(), across.end(), no_half_edge));
  const std::size_t edges = (3 * triangles + on_rim) / 2;
  return rims == 2 && points + triangles == edges;
}

// How far a loop is from a curve, by the curve's points: the farthest of them from the loop's nearest.
double distance_to(const std::vector<glm::dvec3>& loop, const Ring& curve) {
  const std::size_t probes = std::min(most_probes, curve.points.size());
  double farthest = 0.0;
  for (std::size_t i = 0; i < probes; ++i) {
    const glm::dvec3& probe = curve.points[i * curve.points.size() / probes];
    double nearest = INFINITY;
    for (const glm::dvec3& point : loop) nearest = std::min(nearest, glm::dot(point - probe, point - probe));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

// Whether the rim goes round as the curve does.
bool runs_along(const std::vector<glm::dvec3>& points, const std::vector<VertexId>& rim, const Ring& curve) {
  double turn = 0.0;
  const std::size_t probes = std::min(most_probes, rim.size());
  const auto arc_at = [&](std::size_t i) {
    return nearest_arc(curve, points[rim[i % probes * rim.size() / probes]]);
  };
  for (std::size_t i = 0; i < probes; ++i) {
    const double forward = arc_at(i + 1) - arc_at(i);
    turn += forward - curve.length * std::round(forward / curve.length);
  }
  return turn > 0.0;
}

// Made of triangles whose rims are there. `low` and `high`: which of the rims. Turned, if the low rim runs the other way.
TubePart make_part(std::vector<glm::dvec3> points, std::vector<Triangle> triangles,
                   std::array<std::vector<VertexId>, 2> rims, bool turn, const glm::dvec3& beginning) {
  if (turn) {
    for (Triangle& f : triangles) std::swap(f[1], f[2]);
    for (auto& rim : rims) std::reverse(rim.begin(), rim.end());
  }
  // The high rim's sides run against working order.
  std::reverse(rims[1].begin(), rims[1].end());
  return {std::move(points), std::move(triangles), std::move(rims[0]), std::move(rims[1]), beginning};
}

}  // namespace

std::string sentence_of(NoPart why) {
  switch (why) {
    case NoPart::no_loop:
      return "no short rows: the time has no loop where this tube begins or ends";
    case NoPart::apart:
      return "no short rows: no part of the mesh lies between this tube's first and last row";
    case NoPart::no_annulus:
      return "no short rows: this tube has an opening or a handle between its ends";
  }
  return {};
}

TubeCutter::TubeCutter(const Input& input, const std::vector<double>& field)
    : points_(input.mesh.positions), field_(field) {
  const std::vector<std::uint8_t> inward = inward_triangles(input);
  for (std::size_t t = 0; t < input.mesh.triangles.size(); ++t) {
    Triangle f = input.mesh.triangles[t];
    for (VertexId& v : f) v = input.twin[v];
    if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0]) continue;
    if (!inward.empty() && inward[t] != 0) std::swap(f[1], f[2]);
    triangles_.push_back(f);
  }
}

std::optional<std::size_t> TubeCutter::cut(const LevelLoop& loop) {
  const auto place = [&](VertexId a, VertexId b) {
    const double share =
        std::clamp((loop.value - field_[a]) / (field_[b] - field_[a]), least_share, 1.0 - least_share);
    return (1.0 - share) * points_[a] + share * points_[b];
  };
  across_.clear();
  barrier_.clear();
  const std::vector<std::vector<std::uint32_t>> loops = loops_at(triangles_, field_, loop.value);
  const std::vector<std::uint32_t>* meant = nullptr;
  double nearest = INFINITY;
  for (const std::vector<std::uint32_t>& candidate : loops) {
    std::vector<glm::dvec3> places;
    for (const std::uint32_t t : candidate) {
      const Triangle f = alone_first(triangles_[t], field_, loop.value);
      places.push_back(place(f[0], f[1]));
      places.push_back(place(f[0], f[2]));
    }
    const double distance = distance_to(places, *loop.curve);
    if (distance >= nearest) continue;
    nearest = distance;
    meant = &candidate;
  }
  if (meant == nullptr) return std::nullopt;

  NewPoints cuts{{}, static_cast<VertexId>(points_.size())};
  for (const std::uint32_t t : *meant) {
    const Triangle f = alone_first(triangles_[t], field_, loop.value);
    cuts.edges.push_back(edge_of(f[0], f[1]));
    cuts.edges.push_back(edge_of(f[0], f[2]));
  }
  std::sort(cuts.edges.begin(), cuts.edges.end());
  cuts.edges.erase(std::unique(cuts.edges.begin(), cuts.edges.end()), cuts.edges.end());
  for (const auto& [a, b] : cuts.edges) {
    points_.push_back(place(a, b));
    field_.push_back(loop.value);
  }
  Loop made{{}, loop.curve};
  for (const std::uint32_t t : *meant) {
    const auto& [a, b, c] = alone_first(triangles_[t], field_, loop.value);
    const VertexId p = cuts.at(a, b), q = cuts.at(a, c);
    made.sides.push_back(field_[a] >= loop.value ? Edge{p, q} : Edge{q, p});
    const bool by_p = glm::length(points_[p] - points_[c]) < glm::length(points_[b] - points_[q]);
    triangles_[t] = {a, p, q};
    triangles_.push_back(by_p ? Triangle{p, b, c} : Triangle{p, b, q});
    triangles_.push_back(by_p ? Triangle{p, c, q} : Triangle{b, c, q});
  }
  loops_.push_back(std::move(made));
  return loops_.size() - 1;
}

std::variant<TubePart, NoPart> TubeCutter::part(std::size_t low, std::size_t high, double stitch_width) {
  if (across_.empty()) {
    across_ = across_sides(triangles_);
    for (const Loop& loop : loops_)
      for (const Edge& side : loop.sides) barrier_.push_back(edge_of(side[0], side[1]));
    std::sort(barrier_.begin(), barrier_.end());
  }
  const auto corner = [&](HalfEdge h) { return triangles_[h / 3][h % 3]; };
  const auto side_of = [&](const Edge& side) {
    for (HalfEdge h = 0; h < across_.size(); ++h)
      if (corner(h) == side[0] && corner(next_in_triangle(h)) == side[1]) return h;
    return no_half_edge;
  };
  const HalfEdge above = side_of(loops_[low].sides[0]);
  const HalfEdge below = side_of({loops_[high].sides[0][1], loops_[high].sides[0][0]});
  if (above == no_half_edge || below == no_half_edge) return NoPart::apart;

  std::vector<std::uint8_t> met(triangles_.size(), 0);
  std::vector<std::uint32_t> region{above / 3};
  met[above / 3] = 1;
  for (std::size_t i = 0; i < region.size(); ++i) {
    for (HalfEdge h = 3 * region[i]; h < 3 * region[i] + 3; ++h) {
      const HalfEdge beyond = across_[h];
      if (beyond == no_half_edge || met[beyond / 3] != 0) continue;
      if (std::binary_search(barrier_.begin(), barrier_.end(),
                             edge_of(corner(h), corner(next_in_triangle(h)))))
        continue;
      met[beyond / 3] = 1;
      region.push_back(beyond / 3);
    }
  }
  if (met[below / 3] == 0) return NoPart::apart;
  std::sort(region.begin(), region.end());

  std::vector<glm::dvec3> points = points_;
  std::vector<Triangle> triangles;
  triangles.reserve(region.size());
  for (const std::uint32_t t : region) triangles.push_back(triangles_[t]);
  const glm::dvec3 on_low = points_[loops_[low].sides[0][0]];
  drop_unused(points, triangles);
  halve_long_edges(points, triangles, longest_edge * stitch_width);
  const std::vector<HalfEdge> sides = across_sides(triangles);
  std::vector<std::vector<VertexId>> rims = rims_of(triangles, sides);
  if (!is_annulus(points.size(), triangles.size(), sides, rims.size())) return NoPart::no_annulus;
  const auto holds = [&](const std::vector<VertexId>& rim) {
    return std::any_of(rim.begin(), rim.end(), [&](VertexId v) { return points[v] == on_low; });
  };
  if (!holds(rims[0])) std::swap(rims[0], rims[1]);
  const Ring& curve = *loops_[low].curve;
  const bool turn = !runs_along(points, rims[0], curve);
  const glm::dvec3 beginning = curve.points[0];
  return make_part(std::move(points), std::move(triangles), {std::move(rims[0]), std::move(rims[1])}, turn,
                   beginning);
}

std::variant<TubePart, NoPart> cut_tube(const Input& input, const std::vector<double>& field,
                                        const LevelLoop& low, const LevelLoop& high, double stitch_width) {
  TubeCutter cutter(input, field);
  const std::optional<std::size_t> bottom = cutter.cut(low), top = cutter.cut(high);
  if (!bottom || !top) return NoPart::no_loop;
  return cutter.part(*bottom, *top, stitch_width);
}

std::variant<TubePart, NoPart> whole_tube(const Input& input, const glm::dvec3& bottom,
                                          const glm::dvec3& beginning, double stitch_width) {
  std::vector<glm::dvec3> points = input.mesh.positions;
  std::vector<Triangle> triangles = input.mesh.triangles;
  for (Triangle& f : triangles)
    for (VertexId& v : f) v = input.twin[v];
  drop_unused(points, triangles);
  halve_long_edges(points, triangles, longest_edge * stitch_width);
  const std::vector<HalfEdge> across = across_sides(triangles);
  std::vector<std::vector<VertexId>> rims = rims_of(triangles, across);
  if (!is_annulus(points.size(), triangles.size(), across, rims.size())) return NoPart::no_annulus;
  const auto far = [&](const std::vector<VertexId>& rim) {
    glm::dvec3 middle{0.0};
    for (const VertexId v : rim) middle += points[v];
    return glm::length(middle / static_cast<double>(rim.size()) - bottom);
  };
  if (far(rims[1]) < far(rims[0])) std::swap(rims[0], rims[1]);
  // Seen from outside with the way up, work goes from right to left: against the sides of triangles that face out.
  return make_part(std::move(points), std::move(triangles), {std::move(rims[0]), std::move(rims[1])}, true,
                   beginning);
}

}  // namespace knit
