#include "knit/timing/choice.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "knit/timing/timing.h"

namespace knit {

namespace {

constexpr double flat_slope = 0.05;
constexpr std::size_t time_bands = 32;  // of time

struct Leaning {
  std::size_t band = 0;
  double area = 0.0, slope = 0.0;
  VertexId at = no_vertex;
};

// Of triangles with an area.
std::vector<Leaning> leanings_of(const Input& input, const Ends& ends) {
  const glm::dvec3 axis = glm::normalize(ends.direction);
  const std::vector<glm::dvec3>& positions = input.mesh.positions;
  std::vector<Leaning> leanings;
  leanings.reserve(input.mesh.triangles.size());
  for (const auto& [a, b, c] : input.mesh.triangles) {
    const glm::dvec3 across = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
    const double area = glm::length(across);
    if (!(area > 0.0)) continue;
    const double time = time_of(ends, (positions[a] + positions[b] + positions[c]) / 3.0);
    const auto band = static_cast<std::size_t>(std::clamp(time, 0.0, 1.0) * static_cast<double>(time_bands));
    leanings.push_back(
        {std::min(band, time_bands - 1), area, glm::length(glm::cross(across / area, axis)), input.twin[a]});
  }
  return leanings;
}

}  // namespace

LevelFigures measure_levels(const Input& input, const Ends& ends) {
  struct Between {
    double area = 0.0,
           level = 0.0;  // level: the area times the slope, so length of level curve times a step of time
  };
  const std::vector<Leaning> leanings = leanings_of(input, ends);
  std::vector<Between> of(time_bands);
  double whole = 0.0, flat = 0.0, largest = 0.0;
  LevelFigures figures;
  for (const Leaning& s : leanings) {
    whole += s.area;
    if (s.slope >= flat_slope) {
      of[s.band].area += s.area;
      of[s.band].level += s.area * s.slope;
      continue;
    }
    flat += s.area;
    if (s.area <= largest) continue;
    largest = s.area;
    figures.flat_at = s.at;
  }
  double variance = 0.0, level = 0.0, most = 0.0;
  for (const Leaning& s : leanings) {
    if (s.slope < flat_slope) continue;
    const double ratio = of[s.band].level / (of[s.band].area * s.slope);
    const double part = s.area * s.slope * (ratio - 1.0) * (ratio - 1.0);
    level += s.area * s.slope;
    variance += part;
    if (part <= most) continue;
    most = part;
    figures.uneven_at = s.at;
  }
  if (whole > 0.0) figures.flat = flat / whole;
  if (level > 0.0) figures.unevenness = std::sqrt(variance / level);
  return figures;
}

}  // namespace knit
