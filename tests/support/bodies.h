// Closed bodies that the examples do not have, and fields over a mesh.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <vector>

#include "knit/mesh/shapes.h"
#include "knit/run/machine.h"
#include "tests/support/rough_sphere.h"

namespace test_support {

// Height along a direction: 0 at the lowest vertex, 1 at the highest.
inline std::vector<double> field_along(const knit::Input& input, const glm::dvec3& axis) {
  std::vector<double> field;
  for (const glm::dvec3& p : input.mesh.positions) field.push_back(glm::dot(p, axis));
  const auto [low, high] = std::minmax_element(field.begin(), field.end());
  const double base = *low;
  const double whole = *high - *low;
  for (double& value : field) value = (value - base) / whole;
  return field;
}

inline std::vector<glm::dvec3> random_axes(std::size_t count, unsigned seed) {
  Dice dice(seed);
  std::vector<glm::dvec3> axes;
  while (axes.size() < count) {
    const glm::dvec3 axis(dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1));
    if (glm::length(axis) <= 1.0 && glm::length(axis) > 0.2) axes.push_back(glm::normalize(axis));
  }
  return axes;
}

// A cylinder about y, y from 0 to `height`, with flat lids that have a ring of their own.
inline knit::Mesh cylinder(unsigned segments, double radius, double height, unsigned rings) {
  std::vector<knit::ProfilePoint> profile{{0.0, 0.0}, {0.5 * radius, 0.0}};
  for (unsigned i = 0; i <= rings; ++i) profile.push_back({radius, height * i / rings});
  profile.push_back({0.5 * radius, height});
  profile.push_back({0.0, height});
  return knit::revolve("cylinder", profile, segments, false);
}

// An arch in the plane z = 0 that stands on two rounded feet, its inner side about 0.65 and its outer side about
// 1.15 above their centres: two minima, a saddle under the arch, a maximum on top. Upside down it is a body with
// two horns.
inline knit::Mesh arch() {
  constexpr double bend = 0.9;
  std::vector<knit::ProfilePoint> profile;
  for (unsigned j = 0; j <= 40; ++j) {
    const knit::TurnPoint at = knit::turn_point(j, 80);
    profile.push_back({0.25 * at.sine, -1.3 * at.cosine});
  }
  knit::Mesh mesh = knit::revolve("arch", profile, 24, false);
  for (glm::dvec3& p : mesh.positions) {
    const double turn = p.y / bend;
    p = {(bend + p.x) * std::sin(turn), (bend + p.x) * std::cos(turn), p.z};
  }
  return mesh;
}

// What the stage timing makes of a mesh.
inline knit::Shared<knit::Timing> timing_of(const knit::Input& input, const knit::Parameters& parameters) {
  knit::State state;
  while (!state.timing) knit::advance(input, parameters, state);
  return state.timing;
}

}  // namespace test_support
