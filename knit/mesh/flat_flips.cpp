#include "knit/mesh/flat_flips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <utility>

namespace knit {

namespace {

// Of the angle between two triangles that lie in one plane, whatever the file's last digits say.
constexpr double flat_sine = 1e-4;
// Less than this below zero the sum of two cotangents stays: corners on one circle but for rounding, also a file's.
constexpr double clearly_not_delaunay = 1e-4;
// Of the area of two triangles: neither of the new ones is less.
constexpr double least_share = 1e-9;
constexpr std::size_t most_flips_a_triangle = 64;

using EdgeEnds = std::pair<VertexId, VertexId>;  // of an edge, the lower first
EdgeEnds ends_of(VertexId a, VertexId b) { return std::minmax(a, b); }

class FlatFlips {
 public:
  FlatFlips(std::span<Triangle> triangles, const std::vector<glm::dvec3>& positions)
      : triangles_(triangles), positions_(positions), across_(3 * triangles.size(), no_half_edge) {}

  // Whether an edge may want it, `across` being known. Most meshes have none: told without sorting their edges.
  [[nodiscard]] bool any_wanted(const std::vector<HalfEdge>& across) const {
    for (HalfEdge h = 0; h < across.size(); ++h) {
      if (across[h] != no_half_edge && h < across[h] && shape_wants_flip(h, across[h])) return true;
    }
    return false;
  }

  void find_neighbours() {
    std::vector<std::pair<EdgeEnds, HalfEdge>> uses;
    uses.reserve(across_.size());
    for (HalfEdge h = 0; h < across_.size(); ++h) uses.emplace_back(ends_of(origin(h), end(h)), h);
    std::sort(uses.begin(), uses.end());
    for (std::size_t i = 0; i < uses.size();) {
      std::size_t next = i + 1;
      while (next < uses.size() && uses[next].first == uses[i].first) ++next;
      const HalfEdge one = uses[i].second, two = uses[next - 1].second;
      if (next == i + 2 && origin(one) != origin(two)) {
        across_[one] = two;
        across_[two] = one;
      }
      edges_.push_back(uses[i].first);
      i = next;
    }
  }

  std::size_t run() {
    const std::size_t most = most_flips_a_triangle * triangles_.size();
    std::size_t flips = 0;
    std::vector<HalfEdge> doubtful;
    for (HalfEdge first = 0; first < across_.size(); ++first) {
      doubtful.push_back(first);
      while (!doubtful.empty() && flips < most) {
        const HalfEdge h = doubtful.back();
        doubtful.pop_back();
        if (!wants_flip(h)) continue;
        ++flips;
        for (const HalfEdge around : flip(h)) doubtful.push_back(around);
      }
    }
    return flips;
  }

 private:
  [[nodiscard]] VertexId origin(HalfEdge h) const { return triangles_[h / 3][h % 3]; }
  [[nodiscard]] VertexId end(HalfEdge h) const { return origin(next_in_triangle(h)); }
  [[nodiscard]] VertexId apex(HalfEdge h) const { return origin(previous_in_triangle(h)); }
  [[nodiscard]] const glm::dvec3& at(VertexId v) const { return positions_[v]; }
  [[nodiscard]] glm::dvec3 normal(VertexId a, VertexId b, VertexId c) const {
    return glm::cross(at(b) - at(a), at(c) - at(a));
  }
  // Of the angle at c in the triangle a, b, c.
  [[nodiscard]] double cotangent(VertexId a, VertexId b, VertexId c) const {
    const glm::dvec3 u = at(a) - at(c), v = at(b) - at(c);
    const double across = glm::length(glm::cross(u, v));
    return glm::dot(u, v) / std::max(across, 1e-300);
  }
  [[nodiscard]] bool is_edge(const EdgeEnds& ends) const {
    const auto changed = changed_.find(ends);
    if (changed != changed_.end()) return changed->second;
    return std::binary_search(edges_.begin(), edges_.end(), ends);
  }

  [[nodiscard]] bool wants_flip(HalfEdge h) const {
    const HalfEdge g = across_[h];
    return g != no_half_edge && shape_wants_flip(h, g) && !is_edge(ends_of(apex(h), apex(g)));
  }

  [[nodiscard]] bool shape_wants_flip(HalfEdge h, HalfEdge g) const {
    if (h / 3 == g / 3) return false;
    const VertexId a = origin(h), b = end(h), c = apex(h), d = apex(g);
    if (c == d) return false;
    const glm::dvec3 here = normal(a, b, c), there = normal(b, a, d);
    const double areas = glm::length(here) * glm::length(there);
    if (glm::dot(here, there) < 0.0 || glm::length(glm::cross(here, there)) > flat_sine * areas) return false;
    const double one = cotangent(a, b, c), other = cotangent(b, a, d);
    if (one + other > -clearly_not_delaunay * std::max({1.0, std::abs(one), std::abs(other)})) return false;
    const glm::dvec3 up = here + there;
    const double least = least_share * glm::dot(up, up);
    return glm::dot(normal(c, a, d), up) > least && glm::dot(normal(d, b, c), up) > least;
  }

  // The triangles a, b, c and b, a, d become c, a, d and d, b, c. The four edges around come back.
  std::array<HalfEdge, 4> flip(HalfEdge h) {
    const HalfEdge g = across_[h];
    const HalfEdge t = h - h % 3, s = g - g % 3;
    const VertexId a = origin(h), b = end(h), c = apex(h), d = apex(g);
    const std::array<HalfEdge, 4> before{previous_in_triangle(h), next_in_triangle(g),
                                         previous_in_triangle(g), next_in_triangle(h)};
    const std::array<HalfEdge, 4> after{t, t + 1, s, s + 1};
    // Two of the four may be glued to each other, so all are looked up before any is changed.
    std::array<HalfEdge, 4> others{};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto inside = std::find(before.begin(), before.end(), across_[before[i]]);
      others[i] = inside == before.end() ? across_[before[i]]
                                         : after[static_cast<std::size_t>(inside - before.begin())];
    }
    for (std::size_t i = 0; i < 4; ++i) {
      across_[after[i]] = others[i];
      if (others[i] != no_half_edge) across_[others[i]] = after[i];
    }
    across_[t + 2] = s + 2;
    across_[s + 2] = t + 2;
    triangles_[t / 3] = {c, a, d};
    triangles_[s / 3] = {d, b, c};
    changed_[ends_of(a, b)] = false;
    changed_[ends_of(c, d)] = true;
    return after;
  }

  std::span<Triangle> triangles_;
  const std::vector<glm::dvec3>& positions_;
  std::vector<HalfEdge> across_;
  std::vector<EdgeEnds> edges_;  // at first, rising
  std::map<EdgeEnds, bool> changed_;
};

}  // namespace

std::size_t flip_flat_edges(std::span<Triangle> triangles, const std::vector<glm::dvec3>& positions,
                            const std::vector<HalfEdge>& across) {
  FlatFlips flips(triangles, positions);
  if (across.size() == 3 * triangles.size() && !flips.any_wanted(across)) return 0;
  flips.find_neighbours();
  return flips.run();
}

}  // namespace knit
