#include "knit/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "knit/mesh/closest_point.h"
#include "knit/mesh/ranking.h"

namespace knit {

namespace {

constexpr std::size_t leaf_size = 4;

// Squared, as the others here.
double to_segment(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 along = to - from;
  const glm::dvec3 offset = point - from;
  const double size = glm::dot(along, along);
  const double share = size > 0.0 ? std::clamp(glm::dot(offset, along) / size, 0.0, 1.0) : 0.0;
  const glm::dvec3 rest = offset - share * along;
  return glm::dot(rest, rest);
}

double to_triangle(const glm::dvec3& point, const Corners& t) {
  const glm::dvec3 ab = t[1] - t[0];
  const glm::dvec3 ac = t[2] - t[0];
  const glm::dvec3 normal = glm::cross(ab, ac);
  const double size = glm::dot(normal, normal);
  // A sliver's normal is mostly rounding, and its edges tell the distance as well.
  if (size > 1e-24 * glm::dot(ab, ab) * glm::dot(ac, ac)) {
    const auto inside = [&](const glm::dvec3& from, const glm::dvec3& to) {
      return glm::dot(glm::cross(to - from, point - from), normal) >= 0.0;
    };
    if (inside(t[0], t[1]) && inside(t[1], t[2]) && inside(t[2], t[0])) {
      const double height = glm::dot(point - t[0], normal);
      return height * height / size;
    }
  }
  return std::min(
      {to_segment(point, t[0], t[1]), to_segment(point, t[1], t[2]), to_segment(point, t[2], t[0])});
}

double to_box(const glm::dvec3& point, const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 outside = glm::max(glm::max(low - point, point - high), glm::dvec3(0.0));
  return glm::dot(outside, outside);
}

}  // namespace

double distance_to_triangle(const glm::dvec3& point, const Corners& triangle) {
  return std::sqrt(to_triangle(point, triangle));
}

TriangleTree::TriangleTree(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                           const std::function<void(double)>& heard) {
  if (triangles.empty()) return;
  std::vector<Centre> centres;
  centres.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    centres.push_back({positions[a] + positions[b] + positions[c],  // three times the centre orders as well
                       static_cast<std::uint32_t>(centres.size())});
  }
  triangles_.reserve(triangles.size());
  numbers_.reserve(triangles.size());
  nodes_.reserve(triangles.size());
  build(centres, positions, triangles, heard);
}

// Halves at the median of the longest side; ties go by number, so the tree is the same on every machine.
TriangleTree::Box TriangleTree::build(std::span<Centre> centres, std::span<const glm::dvec3> positions,
                                      std::span<const Triangle> triangles,
                                      const std::function<void(double)>& heard) {
  constexpr std::size_t some = 8192;
  if (heard && centres.size() >= some)
    heard(static_cast<double>(triangles_.size()) / static_cast<double>(triangles.size()));
  const std::size_t node = nodes_.size();
  nodes_.emplace_back();
  if (centres.size() <= leaf_size) {
    const glm::dvec3 first = positions[triangles[centres.front().triangle][0]];
    Node leaf{{first, first},
              static_cast<std::uint32_t>(triangles_.size()),
              static_cast<std::uint32_t>(centres.size())};
    for (const Centre& centre : centres) {
      const auto& [a, b, c] = triangles[centre.triangle];
      triangles_.push_back({positions[a], positions[b], positions[c]});
      numbers_.push_back(centre.triangle);
      for (const glm::dvec3& corner : triangles_.back()) {
        leaf.box = {glm::min(leaf.box.low, corner), glm::max(leaf.box.high, corner)};
      }
    }
    nodes_[node] = leaf;
    return leaf.box;
  }
  Box spread{centres.front().at, centres.front().at};
  for (const Centre& centre : centres) {
    spread = {glm::min(spread.low, centre.at), glm::max(spread.high, centre.at)};
  }
  const glm::dvec3 size = spread.high - spread.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t half = centres.size() / 2;
  put_least_first(centres, half, [axis](const Centre& a, const Centre& b) {
    return a.at[axis] < b.at[axis] || (a.at[axis] == b.at[axis] && a.triangle < b.triangle);
  });
  const Box left = build(centres.first(half), positions, triangles, heard);
  const auto second = static_cast<std::uint32_t>(nodes_.size());
  const Box right = build(centres.subspan(half), positions, triangles, heard);
  const Box box{glm::min(left.low, right.low), glm::max(left.high, right.high)};
  nodes_[node] = {box, second, 0};
  return box;
}

double TriangleTree::distance(const glm::dvec3& point) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto see = [&](std::uint32_t i, double best) {
    return std::min(best, to_triangle(point, triangles_[i]));
  };
  return nodes_.empty() ? infinite : std::sqrt(search(0, point, infinite, see));
}

double TriangleTree::distance(const glm::dvec3& point, const glm::dvec3& facing, double most) const {
  constexpr double least_cosine = 0.1;
  const auto see = [&](std::uint32_t i, double best) {
    const Corners& t = triangles_[i];
    const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double along = glm::dot(normal, facing);
    const bool alike = along > 0.0 && along * along > least_cosine * least_cosine * glm::dot(normal, normal);
    return alike ? std::min(best, to_triangle(point, t)) : best;
  };
  return nodes_.empty() ? most : std::sqrt(search(0, point, most * most, see));
}

SurfacePlace TriangleTree::nearest(const glm::dvec3& point) const {
  SurfacePlace found;
  const auto see = [&](std::uint32_t i, double best) {
    const glm::dvec3 place = closest_on_triangle(point, triangles_[i]);
    const double square = glm::dot(place - point, place - point);
    if (square > best || (square == best && numbers_[i] > found.triangle)) return best;
    found = {numbers_[i], place};
    return square;
  };
  (void)search(0, point, std::numeric_limits<double>::infinity(), see);
  return found;
}

// The least squared distance below the node, or `best` if nothing there is nearer: `see` looks at a triangle and says.
template <class See>
double TriangleTree::search(std::size_t node, const glm::dvec3& point, double best, See&& see) const {
  const Node& at = nodes_[node];
  if (at.count > 0) {
    for (std::uint32_t i = at.first; i < at.first + at.count; ++i) best = see(i, best);
    return best;
  }
  std::array<std::size_t, 2> children{node + 1, at.first};
  std::array<double, 2> distances{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Box& box = nodes_[children[i]].box;
    distances[i] = to_box(point, box.low, box.high);
  }
  const std::size_t nearer = distances[1] < distances[0] ? 1 : 0;
  for (const std::size_t i : {nearer, 1 - nearer}) {
    if (distances[i] <= best) best = search(children[i], point, best, see);
  }
  return best;
}

}  // namespace knit
