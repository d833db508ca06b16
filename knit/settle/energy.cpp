#include "knit/settle/energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "knit/mesh/box_tree.h"
#include "knit/mesh/elementary.h"
#include "knit/mesh/triangle_tree.h"

namespace knit {

namespace {

// A corner's parallelogram, in w h, below which it counts as about to turn over.
constexpr double least_corner = 0.25;
// And below which what it lacks counts once more, so that pulls of several stitches do not turn it over.
constexpr double turning_corner = 0.15;

// One residual, and how it changes with the positions of the stitches that it hangs on.
template <std::size_t N>
struct Term {
  double residual = 0.0;
  std::array<std::uint32_t, N> stitches{};
  std::array<glm::dvec3, N> slopes{};
};

// Of an edge that is too long, how it resists being turned as well: its second derivative across it, which is not negative.
struct EdgeTerm : Term<2> {
  glm::dvec3 along{0.0};
  double stiffness = 0.0;
};

// Of a place that a face is to cover: the face's stitches have shares in it.
struct CoverTerm : Term<3> {
  std::array<double, 3> shares{};
};

// |a - b| as a unit vector and a length; no direction where they meet.
struct Span {
  glm::dvec3 along{0.0};
  double length = 0.0;
};
Span span_of(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 difference = a - b;
  const double length = glm::length(difference);
  return {length > 0.0 ? difference / length : glm::dvec3(0.0), length};
}

template <class Sink>
void visit_edges(std::span<const std::array<std::uint32_t, 2>> edges, double wanted, double weight,
                 Placed placed, Sink& sink) {
  const double scale = std::sqrt(weight) / wanted;
  for (const auto& edge : edges) {
    const Span span = span_of(placed.positions[edge[0]], placed.positions[edge[1]]);
    const glm::dvec3 slope = scale * span.along;
    const double longer = span.length - wanted;
    const double stiffness = longer > 0.0 ? scale * scale * longer / span.length : 0.0;
    sink(EdgeTerm{{scale * longer, edge, {slope, -slope}}, span.along, stiffness});
  }
}

template <class Sink>
void visit_quads(const SettleTerms& terms, double weight, Placed placed, Sink& sink) {
  const double scale = std::sqrt(weight) / hypotenuse(terms.width, terms.height);
  const auto& p = placed.positions;
  for (const auto& quad : terms.graph.quads) {
    const Span one = span_of(p[quad[0]], p[quad[2]]), two = span_of(p[quad[1]], p[quad[3]]);
    const glm::dvec3 first = scale * one.along, second = scale * two.along;
    sink(Term<4>{scale * (one.length - two.length), quad, {first, -second, -first, second}});
  }
}

glm::dvec3 nearest_on_polygon(std::span<const glm::dvec3> polygon, const glm::dvec3& point) {
  glm::dvec3 best = polygon.front();
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : Edges(polygon.size(), true)) {
    const glm::dvec3 side = polygon[to] - polygon[from];
    const double square = glm::dot(side, side);
    const double share =
        square > 0.0 ? std::clamp(glm::dot(point - polygon[from], side) / square, 0.0, 1.0) : 0.0;
    const glm::dvec3 place = polygon[from] + share * side;
    const double distance = glm::dot(place - point, place - point);
    if (distance >= least) continue;
    least = distance;
    best = place;
  }
  return best;
}

template <class Sink>
void visit_rims(const SettleTerms& terms, double weight, Placed placed, Sink& sink) {
  const double scale = std::sqrt(weight) / terms.width;
  for (std::size_t rim = 0; rim < terms.graph.rims.size(); ++rim) {
    for (const std::uint32_t stitch : terms.graph.rims[rim]) {
      const glm::dvec3& position = placed.positions[stitch];
      const Span span = span_of(position, nearest_on_polygon(terms.rim_polygons[rim], position));
      sink(Term<1>{scale * span.length, {stitch}, {scale * span.along}});
    }
  }
}

glm::dvec3 corner_area(const std::array<std::uint32_t, 3>& corner, std::span<const glm::dvec3> p) {
  return glm::cross(p[corner[1]] - p[corner[0]], p[corner[2]] - p[corner[0]]);
}

template <class Sink>
void visit_corners(const SettleTerms& terms, double weight, Placed placed, Sink& sink) {
  const double scale = std::sqrt(weight);
  const double share = terms.facing / (terms.width * terms.height);
  const auto& p = placed.positions;
  for (const auto& corner : terms.graph.corners) {
    const glm::dvec3& normal = placed.normals[corner[0]];
    const double area = share * glm::dot(corner_area(corner, p), normal);
    if (area >= least_corner) continue;
    const double times = area < turning_corner ? 2.0 : 1.0;
    const double lacking = least_corner - area + std::max(0.0, turning_corner - area);
    const double turn = -scale * share * times;
    const glm::dvec3 next = turn * glm::cross(p[corner[2]] - p[corner[0]], normal);
    const glm::dvec3 before = turn * glm::cross(normal, p[corner[1]] - p[corner[0]]);
    sink(Term<3>{scale * lacking, corner, {-next - before, next, before}});
  }
}

// Of a place on a triangle, the corners'; alike where the triangle has no area.
std::array<double, 3> shares_of(const glm::dvec3& place, const Corners& corners) {
  const auto& [a, b, c] = corners;
  const glm::dvec3 across = glm::cross(b - a, c - a);
  const double area = glm::dot(across, across);
  if (!(area > 0.0)) return {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
  const double first = glm::dot(glm::cross(c - b, place - b), across) / area;
  const double second = glm::dot(glm::cross(a - c, place - c), across) / area;
  return {first, second, 1.0 - first - second};
}

// A place that the triangle remembered covers is passed over; for the others the nearest of all is searched.
template <class Sink>
void visit_places(const SettleTerms& terms, double weight, Placed placed, Sink& sink) {
  const auto& triangles = terms.graph.triangles;
  const auto corners_of = [&](std::uint32_t triangle) {
    const auto& [a, b, c] = triangles[triangle];
    return Corners{placed.positions[a], placed.positions[b], placed.positions[c]};
  };
  const double unit = left_by * terms.height;
  std::optional<BoxTree> boxes;  // triangles lie row by row, and few places are searched for
  for (std::size_t i = 0; i < terms.places.size(); ++i) {
    const CoverPlace& place = terms.places[i];
    const std::uint32_t near = placed.near.empty() ? place.near : placed.near[i];
    if (distance_to_triangle(place.at, corners_of(near)) <= place.allowed) continue;
    if (!boxes) boxes.emplace(placed.positions, triangles);
    const SurfacePlace nearest = boxes->nearest(place.at, near);
    if (!placed.near.empty()) placed.near[i] = nearest.triangle;
    const Span span = span_of(nearest.point, place.at);
    if (span.length <= place.allowed) continue;
    const double scale = std::sqrt(weight * place.area / (terms.width * terms.height)) / unit;
    const glm::dvec3 slope = scale * span.along;
    const auto shares = shares_of(nearest.point, corners_of(nearest.triangle));
    sink(CoverTerm{{scale * (span.length - place.allowed),
                    triangles[nearest.triangle],
                    {shares[0] * slope, shares[1] * slope, shares[2] * slope}},
                   shares});
  }
}

template <class Sink>
void visit_terms(const SettleTerms& terms, const SettleSettings& settings, Placed placed, Sink& sink) {
  visit_edges(terms.graph.wales, terms.height, settings.wale, placed, sink);
  visit_edges(terms.graph.courses, terms.width, settings.course, placed, sink);
  visit_quads(terms, settings.shear, placed, sink);
  visit_rims(terms, settings.rim, placed, sink);
  visit_corners(terms, settings.fold, placed, sink);
  if (settings.cover > 0.0) visit_places(terms, settings.cover, placed, sink);
}

struct Summing {
  double sum = 0.0;
  template <std::size_t N>
  void operator()(const Term<N>& term) {
    sum += term.residual * term.residual;
  }
};

struct Attributing {
  double sign;
  std::vector<double>& around;
  template <std::size_t N>
  void operator()(const Term<N>& term) {
    const double square = sign * term.residual * term.residual;
    for (const std::uint32_t stitch : term.stitches) around[stitch] += square;
  }
};

struct Sloping {
  std::vector<glm::dvec3> slopes;
  template <std::size_t N>
  void operator()(const Term<N>& term) {
    for (std::size_t i = 0; i < N; ++i) slopes[term.stitches[i]] += 2.0 * term.residual * term.slopes[i];
  }
};

struct Linearising {
  std::span<const Frame> frames;
  const BlockPattern& pattern;
  BlockSystem& system;

  template <std::size_t N>
  void operator()(const Term<N>& term) {
    std::array<glm::dvec2, N> g{};
    std::array<std::uint32_t, N> place{};
    for (std::size_t i = 0; i < N; ++i) {
      const Frame& frame = frames[term.stitches[i]];
      g[i] = {glm::dot(term.slopes[i], frame.u), glm::dot(term.slopes[i], frame.v)};
      place[i] = pattern.place[term.stitches[i]];
      system.right[place[i]] -= term.residual * g[i];
      add_product(system.diagonal[place[i]], g[i], g[i]);
    }
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = i + 1; j < N; ++j) {
        const bool first_lower = place[i] > place[j];
        add_product(system.below[pattern.slot(term.stitches[i], term.stitches[j])], first_lower ? g[i] : g[j],
                    first_lower ? g[j] : g[i]);
      }
    }
  }
  void operator()(const EdgeTerm& term) {
    (*this)(static_cast<const Term<2>&>(term));
    if (term.stiffness <= 0.0) return;
    const auto [a, b] = term.stitches;
    const std::uint32_t p = pattern.place[a], q = pattern.place[b];
    add_across(system.diagonal[p], frames[a], frames[a], term.along, term.stiffness);
    add_across(system.diagonal[q], frames[b], frames[b], term.along, term.stiffness);
    Block& both = system.below[pattern.slot(a, b)];
    add_across(both, frames[p > q ? a : b], frames[p > q ? b : a], term.along, -term.stiffness);
  }
  void operator()(const CoverTerm& term) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Frame& frame = frames[term.stitches[i]];
      const glm::dvec2 g{glm::dot(term.slopes[i], frame.u), glm::dot(term.slopes[i], frame.v)};
      const std::uint32_t place = pattern.place[term.stitches[i]];
      system.right[place] -= term.residual * g;
      if (term.shares[i] > 0.0) add_product(system.diagonal[place], g / term.shares[i], g);
    }
  }
  // The part of the identity across a direction, between two planes.
  static void add_across(Block& block, const Frame& down, const Frame& across, const glm::dvec3& along,
                         double factor) {
    const auto between = [&](const glm::dvec3& x, const glm::dvec3& y) {
      return factor * (glm::dot(x, y) - glm::dot(x, along) * glm::dot(y, along));
    };
    block[0] += between(down.u, across.u);
    block[1] += between(down.u, across.v);
    block[2] += between(down.v, across.u);
    block[3] += between(down.v, across.v);
  }
  static void add_product(Block& block, const glm::dvec2& down, const glm::dvec2& across) {
    block[0] += down.x * across.x;
    block[1] += down.x * across.y;
    block[2] += down.y * across.x;
    block[3] += down.y * across.y;
  }
};

}  // namespace

Frame frame_across(const glm::dvec3& normal) {
  const glm::dvec3 aside = std::abs(normal.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(normal, aside));
  return {u, glm::cross(normal, u)};
}

double facing_of(const SettleGraph& graph, Placed placed) {
  std::int64_t balance = 0;
  for (const auto& corner : graph.corners)
    balance += glm::dot(corner_area(corner, placed.positions), placed.normals[corner[0]]) < 0.0 ? -1 : 1;
  return balance < 0 ? -1.0 : 1.0;
}

double sum_of_terms(const SettleTerms& terms, const SettleSettings& settings, Placed placed) {
  Summing summing;
  visit_terms(terms, settings, placed, summing);
  return summing.sum;
}

void add_terms(const SettleTerms& terms, const SettleSettings& settings, Placed placed, double sign,
               std::vector<double>& around) {
  Attributing attributing{sign, around};
  visit_terms(terms, settings, placed, attributing);
}

std::vector<glm::dvec3> slopes_of(const SettleTerms& terms, const SettleSettings& settings, Placed placed) {
  Sloping sloping{std::vector<glm::dvec3>(placed.positions.size(), glm::dvec3(0.0))};
  visit_terms(terms, settings, placed, sloping);
  return sloping.slopes;
}

void linearise(const SettleTerms& terms, const SettleSettings& settings, Placed placed,
               std::span<const Frame> frames, const BlockPattern& pattern, BlockSystem& system) {
  system.diagonal.assign(pattern.size(), Block{});
  system.below.assign(pattern.row.size(), Block{});
  system.right.assign(pattern.size(), glm::dvec2(0.0));
  Linearising linearising{frames, pattern, system};
  visit_terms(terms, settings, placed, linearising);
}

}  // namespace knit
