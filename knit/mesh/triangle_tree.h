// The nearest of many triangles to a point, how far it is and where on it: a tree of boxes.
//
// Exact up to rounding, for slivers and triangles without area too. The order of the triangles, their
// orientation and how they hang together do not matter.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

using Corners = std::array<glm::dvec3, 3>;

// A place on a surface.
struct SurfacePlace {
  std::uint32_t triangle = 0;
  glm::dvec3 point{0.0};
};

double distance_to_triangle(const glm::dvec3& point, const Corners& triangle);

class TriangleTree {
 public:
  // Requires indices in range and finite positions. `heard`: called now and then with the share that is done; what it throws
  // breaks the work off.
  TriangleTree(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
               const std::function<void(double)>& heard = {});

  [[nodiscard]] double distance(const glm::dvec3& point) const;  // infinite if there are no triangles
  // To those alone that face as `facing` (unit length) does, by counter-clockwise corners: less than 84 degrees off, so
  // that rounding does not decide about a right angle. `most` if none is nearer.
  [[nodiscard]] double distance(const glm::dvec3& point, const glm::dvec3& facing, double most) const;
  // Of equally near triangles the lower. Requires one.
  [[nodiscard]] SurfacePlace nearest(const glm::dvec3& point) const;

 private:
  struct Box {
    glm::dvec3 low, high;
  };
  struct Node {
    Box box;
    std::uint32_t first = 0;  // leaf: its first triangle; else the second child, the first is next in line
    std::uint32_t count = 0;  // of triangles; 0: no leaf
  };
  struct Centre {
    glm::dvec3 at;
    std::uint32_t triangle;
  };
  Box build(std::span<Centre> centres, std::span<const glm::dvec3> positions,
            std::span<const Triangle> triangles, const std::function<void(double)>& heard);
  template <class See>
  [[nodiscard]] double search(std::size_t node, const glm::dvec3& point, double best, See&& see) const;

  std::vector<Node> nodes_;             // the root first, children after their parent
  std::vector<Corners> triangles_;      // leaf after leaf
  std::vector<std::uint32_t> numbers_;  // theirs, as they were given
};

}  // namespace knit
