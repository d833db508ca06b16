#include "knit/mesh/surface_area.h"

#include <glm/geometric.hpp>

namespace knit {

double surface_area(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles) {
  double area = 0.0;
  for (const auto& [a, b, c] : triangles)
    area += glm::length(glm::cross(positions[b] - positions[a], positions[c] - positions[a])) / 2.0;
  return area;
}

}  // namespace knit
