#include "knit/relax/contact.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace knit {

namespace {

using Cube = std::array<std::int64_t, 3>;

class Grid {
 public:
  explicit Grid(double size) : size_(size) {}
  [[nodiscard]] Cube cube(const glm::dvec3& place) const {
    return {cell(place.x), cell(place.y), cell(place.z)};
  }
  void put(const Cube& cube, std::uint32_t item) { items_.emplace_back(cube, item); }
  void sort() { std::sort(items_.begin(), items_.end()); }
  // Those in a stretch of cubes along z.
  template <class See>
  void each(const Cube& low, std::int64_t z_to, See&& see) const {
    const Cube high{low[0], low[1], z_to};
    for (auto at = std::lower_bound(items_.begin(), items_.end(), std::pair{low, std::uint32_t{0}});
         at != items_.end() && at->first <= high; ++at)
      see(at->second);
  }

 private:
  [[nodiscard]] std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(x / size_)); }
  double size_;
  std::vector<std::pair<Cube, std::uint32_t>> items_;
};

template <class See>
void each_column(const Cube& low, const Cube& high, See&& see) {
  for (std::int64_t x = low[0]; x <= high[0]; ++x) {
    for (std::int64_t y = low[1]; y <= high[1]; ++y) see(Cube{x, y, low[2]});
  }
}

double squared_distance(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 way = b - a;
  return glm::dot(way, way);
}

using Corners = std::array<std::uint32_t, 3>;

std::vector<Corners> triangles_of(const Enclosure& all) {
  std::vector<Corners> triangles;
  for (const auto& [a, b, c, d] : all.quads) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  triangles.insert(triangles.end(), all.triangles.begin(), all.triangles.end());
  return triangles;
}

std::vector<StitchPair> edges_of(const std::vector<Corners>& triangles) {
  std::vector<StitchPair> edges;
  for (const Corners& corners : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      edges.push_back({low, high});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// T. Möller, B. Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
bool goes_through(const StitchPair& edge, const Corners& triangle, std::span<const glm::dvec3> at) {
  constexpr double flat = 1e-12;
  const glm::dvec3 from = at[edge[0]], way = at[edge[1]] - from;
  const glm::dvec3 a = at[triangle[0]], b = at[triangle[1]] - a, c = at[triangle[2]] - a;
  const glm::dvec3 across = glm::cross(way, c);
  const double volume = glm::dot(b, across);
  if (std::abs(volume) <= flat * glm::length(b) * glm::length(c) * glm::length(way)) return false;
  const glm::dvec3 out = from - a, turned = glm::cross(out, b);
  const double u = glm::dot(out, across) / volume, v = glm::dot(way, turned) / volume,
               share = glm::dot(c, turned) / volume;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && share >= 0.0 && share <= 1.0;
}

}  // namespace

std::vector<StitchPair> pairs_near(Joined& joined, std::span<const glm::dvec3> at, double near, int steps) {
  Grid grid(near);
  const auto count = static_cast<std::uint32_t>(at.size());
  for (std::uint32_t i = 0; i < count; ++i) grid.put(grid.cube(at[i]), i);
  grid.sort();
  std::vector<StitchPair> pairs;
  std::vector<std::uint32_t> beside, found;
  for (std::uint32_t i = 0; i < count; ++i) {
    found.clear();
    const Cube cube = grid.cube(at[i]);
    each_column({cube[0] - 1, cube[1] - 1, cube[2] - 1}, {cube[0] + 1, cube[1] + 1, 0},
                [&](const Cube& column) {
                  grid.each(column, cube[2] + 1, [&](std::uint32_t other) {
                    if (other > i && squared_distance(at[i], at[other]) < near * near) found.push_back(other);
                  });
                });
    if (found.empty()) continue;
    joined.within(i, steps, beside);
    std::sort(found.begin(), found.end());
    for (const std::uint32_t other : found) {
      if (!std::binary_search(beside.begin(), beside.end(), other)) pairs.push_back({i, other});
    }
  }
  return pairs;
}

std::vector<Crossing> crossings_of(const Enclosure& all, Joined& joined, std::span<const glm::dvec3> at,
                                   double size) {
  const std::vector<Corners> triangles = triangles_of(all);
  Grid grid(size);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const Cube low = grid.cube(glm::min(at[a], glm::min(at[b], at[c]))),
               high = grid.cube(glm::max(at[a], glm::max(at[b], at[c])));
    each_column(low, high, [&](Cube cube) {
      for (; cube[2] <= high[2]; ++cube[2]) grid.put(cube, t);
    });
  }
  grid.sort();
  std::vector<Crossing> crossings;
  std::vector<std::uint32_t> tried, beside;
  for (const StitchPair& edge : edges_of(triangles)) {
    const Cube low = grid.cube(glm::min(at[edge[0]], at[edge[1]])),
               high = grid.cube(glm::max(at[edge[0]], at[edge[1]]));
    tried.clear();
    each_column(low, high, [&](const Cube& column) {
      grid.each(column, high[2], [&](std::uint32_t t) { tried.push_back(t); });
    });
    std::sort(tried.begin(), tried.end());
    tried.erase(std::unique(tried.begin(), tried.end()), tried.end());
    bool searched = false;
    for (const std::uint32_t t : tried) {
      const Corners& corners = triangles[t];
      const auto is_end = [&](std::uint32_t corner) { return corner == edge[0] || corner == edge[1]; };
      if (std::any_of(corners.begin(), corners.end(), is_end) || !goes_through(edge, corners, at)) continue;
      if (!std::exchange(searched, true)) joined.within(edge[0], crossing_apart, beside);
      const auto is_beside = [&](std::uint32_t corner) {
        return std::binary_search(beside.begin(), beside.end(), corner);
      };
      if (!std::any_of(corners.begin(), corners.end(), is_beside)) crossings.push_back({edge, corners});
    }
  }
  return crossings;
}

}  // namespace knit
