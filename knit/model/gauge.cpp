#include "knit/model/gauge.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace knit {

namespace {

constexpr double swatch_cm = 10.0;

double height_along(const Input& input, const glm::dvec3& direction) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t v = 0; v < input.mesh.positions.size(); ++v) {
    if (input.referenced[v] == 0) continue;
    const double height = glm::dot(input.mesh.positions[v], direction);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  return high - low;
}

// Takes the other view's value, unless the two already say the same but for rounding: turning the switch to
// and fro changes nothing.
void follow(double& value, double other) {
  if (std::abs(value - other) > 1e-12 * other) value = other;
}

}  // namespace

glm::dvec3 knitting_direction(const Parameters& p, const Mesh& mesh) {
  // Not picked, or out of range: fault_of says that later.
  const std::size_t count = mesh.positions.size();
  if (p.start >= count || p.end >= count) return p.axis.direction();
  const glm::dvec3 line = mesh.positions[p.end] - mesh.positions[p.start];
  return glm::length(line) > 0.0 ? glm::normalize(line) : p.axis.direction();
}

double centimetres_per_unit(const Parameters& parameters, const Input& input) {
  const double height = height_along(input, knitting_direction(parameters, input.mesh));
  return height > 0.0 ? parameters.height_cm / height : 1.0;
}

Parameters agreed(const Parameters& parameters, const Input& input) {
  Parameters result = parameters;
  const double scale = centimetres_per_unit(parameters, input);
  if (parameters.sizes == SizesFrom::gauge) {
    follow(result.stitch_width, swatch_cm / (parameters.gauge.stitches * scale));
    // A height left to itself stays so while it says the same.
    double height = stitch_height_of(result);
    follow(height, swatch_cm / (parameters.gauge.rounds * scale));
    if (height != stitch_height_of(result)) result.stitch_height = height;
  } else {
    follow(result.gauge.stitches, swatch_cm / (parameters.stitch_width * scale));
    follow(result.gauge.rounds, swatch_cm / (stitch_height_of(parameters) * scale));
  }
  return result;
}

void give_size_by(std::string_view key, Parameters& parameters) {
  if (key == "stitch-width" || key == "stitch-height") parameters.sizes = SizesFrom::mesh;
  if (key == "gauge") parameters.sizes = SizesFrom::gauge;
}

}  // namespace knit
