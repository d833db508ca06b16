#include "knit/mesh/implicit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <vector>

namespace knit {

namespace {

using GridPoint = std::array<std::size_t, 3>;

// Corners of a cube are numbered by their bits, x first. A cube is cut into six tetrahedra along its diagonal from 0 to
// 7, each with its corners in right-handed order, the same in every cube: so neighbours agree on their common faces.
constexpr std::array<std::array<unsigned, 4>, 6> tetrahedra{
    {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 3, 2, 7}, {0, 6, 4, 7}, {0, 5, 1, 7}}};

// By which corners of a tetrahedron are inside, as bits: its corners in an even order, those inside first; where three
// are inside, the one outside first.
constexpr std::array<std::array<unsigned, 4>, 16> orders{{{0, 1, 2, 3},
                                                          {0, 1, 2, 3},
                                                          {1, 0, 3, 2},
                                                          {0, 1, 2, 3},
                                                          {2, 3, 0, 1},
                                                          {0, 2, 3, 1},
                                                          {1, 2, 0, 3},
                                                          {3, 2, 1, 0},
                                                          {3, 2, 1, 0},
                                                          {0, 3, 1, 2},
                                                          {1, 3, 2, 0},
                                                          {2, 3, 0, 1},
                                                          {2, 3, 0, 1},
                                                          {1, 0, 3, 2},
                                                          {0, 1, 2, 3},
                                                          {0, 1, 2, 3}}};

// Marching tetrahedra. For every tetrahedron: a corner alone on its side is cut off by a triangle, two from two by four
// corners, that is two triangles; their corners stand on edges of the grid, one an edge, so that the pieces join.
// A value of exactly 0 counts as outside. Cost: one evaluation a point of the grid.
// Invariant: each edge of a piece lies in a face of the grid, which just one other tetrahedron has, with the same edge
// the other way round.
class Marching {
 public:
  Marching(const Solid& solid, const GridBlock& block, double cell) : low_(block.low), cell_(cell) {
    const glm::dvec3 size = block.high - block.low;
    for (std::size_t k = 0; k < 3; ++k)
      cells_[k] = static_cast<std::size_t>(std::ceil(size[static_cast<int>(k)] / cell));
    values_.resize((cells_[0] + 1) * (cells_[1] + 1) * (cells_[2] + 1));
    on_edge_.assign(values_.size(), {});
    for (auto& edges : on_edge_) edges.fill(no_vertex);
    for (std::size_t y = 0; y <= cells_[1]; ++y)
      for (std::size_t z = 0; z <= cells_[2]; ++z)
        for (std::size_t x = 0; x <= cells_[0]; ++x) values_[index({x, y, z})] = solid(place({x, y, z}));
  }

  Mesh march() && {
    for (std::size_t y = 0; y < cells_[1]; ++y)
      for (std::size_t z = 0; z < cells_[2]; ++z)
        for (std::size_t x = 0; x < cells_[0]; ++x)
          for (const auto& corners : tetrahedra) cut(GridPoint{x, y, z}, corners);
    return std::move(mesh_);
  }

 private:
  // Layer by layer from below, so that vertices come about as they are knitted.
  [[nodiscard]] std::size_t index(const GridPoint& at) const {
    return (at[1] * (cells_[2] + 1) + at[2]) * (cells_[0] + 1) + at[0];
  }
  [[nodiscard]] glm::dvec3 place(const GridPoint& at) const {
    return low_ + cell_ * glm::dvec3(static_cast<double>(at[0]), static_cast<double>(at[1]),
                                     static_cast<double>(at[2]));
  }
  static GridPoint corner(const GridPoint& cube, unsigned bits) {
    return {cube[0] + (bits & 1), cube[1] + (bits >> 1 & 1), cube[2] + (bits >> 2 & 1)};
  }

  // The vertex on the edge between two corners of a cube, one inside and one outside. Never quite at a corner, so that
  // no two vertices fall together.
  VertexId between(const GridPoint& cube, unsigned a, unsigned b) {
    const GridPoint first = corner(cube, a & b);  // of the two the one that has fewer bits
    const GridPoint second = corner(cube, a | b);
    VertexId& vertex = on_edge_[index(first)][(a ^ b) - 1];
    if (vertex == no_vertex) {
      vertex = static_cast<VertexId>(mesh_.positions.size());
      const double here = values_[index(first)];
      const double part = std::clamp(here / (here - values_[index(second)]), 0.02, 0.98);
      mesh_.positions.push_back(place(first) + part * (place(second) - place(first)));
    }
    return vertex;
  }

  void cut(const GridPoint& cube, const std::array<unsigned, 4>& corners) {
    unsigned inside = 0;
    int count = 0;
    for (unsigned k = 0; k < 4; ++k) {
      if (!(values_[index(corner(cube, corners[k]))] < 0.0)) continue;
      inside |= 1U << k;
      ++count;
    }
    if (count == 0 || count == 4) return;
    const std::array<unsigned, 4>& order = orders[inside];
    const auto vertex = [&](unsigned from, unsigned to) {
      return between(cube, corners[order[from]], corners[order[to]]);
    };
    if (count == 1) {
      mesh_.triangles.push_back({vertex(0, 1), vertex(0, 2), vertex(0, 3)});
    } else if (count == 3) {
      mesh_.triangles.push_back({vertex(0, 1), vertex(0, 3), vertex(0, 2)});
    } else {
      const std::array<VertexId, 4> around{vertex(0, 2), vertex(0, 3), vertex(1, 3), vertex(1, 2)};
      mesh_.triangles.push_back({around[0], around[1], around[2]});
      mesh_.triangles.push_back({around[0], around[2], around[3]});
    }
  }

  glm::dvec3 low_;
  double cell_;
  GridPoint cells_{};
  std::vector<double> values_;
  std::vector<std::array<VertexId, 7>> on_edge_;  // per point and direction, by its bits less 1
  Mesh mesh_;
};

}  // namespace

Mesh surface_of(const Solid& solid, const GridBlock& block, double cell) {
  return Marching(solid, block, cell).march();
}

// p <- p - f(p) g / (g . g), the gradient g by differences; where it vanishes the place stays.
glm::dvec3 onto_surface(const Solid& solid, glm::dvec3 place, int times) {
  constexpr double little = 1e-6;
  for (int i = 0; i < times; ++i) {
    const double here = solid(place);
    const auto slope = [&](const glm::dvec3& way) { return (solid(place + little * way) - here) / little; };
    const glm::dvec3 gradient(slope({1.0, 0.0, 0.0}), slope({0.0, 1.0, 0.0}), slope({0.0, 0.0, 1.0}));
    const double square = glm::dot(gradient, gradient);
    if (!(square > 1e-6)) break;
    place -= gradient * (here / square);
  }
  return place;
}

}  // namespace knit
