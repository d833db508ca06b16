// Cycles on spheres and what is found between them.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "knit/curves/between.h"
#include "tests/support/catch.h"

namespace test_support {

// On a sphere about the origin: `down` from +y, `round` from +x towards +z.
inline glm::dvec3 on_ball(double down, double round, double radius = 1.0) {
  return radius *
         glm::dvec3(std::sin(down) * std::cos(round), std::cos(down), std::sin(down) * std::sin(round));
}

inline knit::Cycle circle_at(const glm::dvec3& point, double radius, knit::CycleEnd as) {
  knit::Cycle cycle{.as = as};
  cycle.kind = knit::CycleKind::circle;
  cycle.points = {point};
  cycle.radius = radius;
  return cycle;
}

inline knit::Cycle through(knit::CycleKind kind, std::vector<glm::dvec3> points, knit::CycleEnd as) {
  knit::Cycle cycle{.as = as};
  cycle.kind = kind;
  cycle.points = std::move(points);
  return cycle;
}

inline knit::Between between(const knit::Mesh& mesh, const std::vector<knit::Cycle>& cycles,
                             double width = 0.1) {
  auto found = knit::between_cycles(mesh, cycles, {.stitch_width = width});
  if (const auto* said = std::get_if<std::string>(&found)) FAIL(*said);
  return std::get<knit::Between>(std::move(found));
}

// The sentence, or nothing where there is a piece.
inline std::string refusal(const knit::Mesh& mesh, const std::vector<knit::Cycle>& cycles,
                           double width = 0.1) {
  const auto found = knit::between_cycles(mesh, cycles, {.stitch_width = width});
  const auto* said = std::get_if<std::string>(&found);
  return said == nullptr ? std::string() : *said;
}

}  // namespace test_support
