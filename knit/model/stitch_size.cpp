#include "knit/model/stitch_size.h"

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

double centimetres_per_unit(const Settings& settings, const Input& input) {
  const double height = height_along(input, knitting_direction(settings.timing, input.mesh));
  return height > 0.0 ? settings.size.height_cm / height : 1.0;
}

// Takes the other view's value, unless the two already say the same but for rounding.
void follow(double& value, double other) {
  if (std::abs(value - other) > 1e-12 * other) value = other;
}

MeshSize mesh_size_of(const StitchSize& stitch) {
  return {stitch.width, stitch.height_follows ? 0.0 : stitch.height};
}

void take(const MeshSize& given, StitchSize& stitch) {
  stitch.width = given.width;
  stitch.height_follows = given.height == 0.0;
  stitch.height = stitch.height_follows ? height_of_width * given.width : given.height;
}

void resolve(const MeshSize& given, StitchSize& stitch) {
  take(given, stitch);
  follow(stitch.gauge.stitches, swatch_cm / (stitch.width * stitch.centimetres_per_unit));
  follow(stitch.gauge.rounds, swatch_cm / (stitch.height * stitch.centimetres_per_unit));
}

void resolve(const GaugeSize& given, StitchSize& stitch) {
  stitch.gauge = given.gauge;
  follow(stitch.width, swatch_cm / (given.gauge.stitches * stitch.centimetres_per_unit));
  // A height left to itself stays so while it says the same.
  const double before = stitch.height_follows ? height_of_width * stitch.width : stitch.height;
  stitch.height = before;
  follow(stitch.height, swatch_cm / (given.gauge.rounds * stitch.centimetres_per_unit));
  stitch.height_follows = stitch.height_follows && stitch.height == before;
}

}  // namespace

glm::dvec3 knitting_direction(const TimingSettings& timing, const Mesh& mesh) {
  // Not picked, or out of range: fault_of says that later.
  const std::size_t count = mesh.positions.size();
  if (timing.start >= count || timing.end >= count) return timing.axis.direction();
  const glm::dvec3 line = mesh.positions[timing.end] - mesh.positions[timing.start];
  return glm::length(line) > 0.0 ? glm::normalize(line) : timing.axis.direction();
}

Parameters resolved(const Parameters& parameters, const Input& input) {
  Parameters result = parameters;
  result.stitch.centimetres_per_unit = centimetres_per_unit(parameters, input);
  std::visit([&](const auto& given) { resolve(given, result.stitch); }, parameters.size.given);
  if (result.rows.epsilon.whole == 0.0) result.rows.epsilon.whole = result.stitch.width;
  return result;
}

void give_width(Parameters& parameters, double width) {
  const MeshSize given{width, mesh_size_of(parameters.stitch).height};
  parameters.size.given = given;
  take(given, parameters.stitch);
}

void give_height(Parameters& parameters, double height) {
  const MeshSize given{parameters.stitch.width, height};
  parameters.size.given = given;
  take(given, parameters.stitch);
}

void give_gauge(Parameters& parameters, Gauge gauge) {
  parameters.size.given = GaugeSize{gauge};
  parameters.stitch.gauge = gauge;
}

void give_sizes(Parameters& parameters, SizesFrom view) {
  if (view == parameters.size.from()) return;
  if (view == SizesFrom::mesh) {
    parameters.size.given = mesh_size_of(parameters.stitch);
  } else {
    parameters.size.given = GaugeSize{parameters.stitch.gauge};
  }
}

void give_size(Parameters& parameters, double times) {
  if (parameters.size.from() == SizesFrom::gauge) {
    parameters.size.height_cm = std::round(100.0 * parameters.size.height_cm * times) / 100.0;
    return;
  }
  const MeshSize now = mesh_size_of(parameters.stitch);
  const MeshSize given{now.width / times, now.height / times};
  parameters.size.given = given;
  take(given, parameters.stitch);
}

void give_epsilon(Parameters& parameters, double epsilon) { parameters.rows.epsilon = {epsilon, 0.0}; }

Parameters default_parameters(const Bounds& bounds) {
  Parameters parameters;
  give_width(parameters, 0.03 * bounds.diagonal());
  return parameters;
}

}  // namespace knit
