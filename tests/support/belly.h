// A sitting body with a belly: circles about y whose centre moves forward, +z, in the lower part, by up to `bulge` of half the
// height. Its mirror plane lies across x.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/mesh/shapes.h"
#include "knit/rhythm/joint_plan.h"

namespace test_support {

// Of a circle, for t from 0 to 1.
struct BellyCircle {
  double y = 0.0, radius = 0.0, forward = 0.0;
};
inline BellyCircle belly_circle(double t, double bulge = 0.35) {
  constexpr double pi = std::numbers::pi;
  const double y = -std::cos(pi * t);
  const double radius = 0.62 * std::pow(std::sin(pi * t), 0.9) * (1.0 - 0.12 * (y + 0.1));
  const double wave = t < 0.85 ? std::sin(pi * t / 0.85) : 0.0;
  return {y, radius, bulge * wave * wave};
}

inline knit::Mesh belly_mesh(unsigned segments = 48, unsigned rings = 48, double bulge = 0.35) {
  std::vector<knit::ProfilePoint> profile;
  std::vector<double> forward;
  for (unsigned i = 0; i <= rings; ++i) {
    const BellyCircle circle = belly_circle(static_cast<double>(i) / rings, bulge);
    const bool pole = i == 0 || i == rings;
    profile.push_back({pole ? 0.0 : circle.radius, circle.y});
    forward.push_back(circle.forward);
  }
  knit::Mesh mesh = knit::revolve("belly", profile, segments, false);
  for (glm::dvec3& position : mesh.positions) {
    std::size_t ring = 0;
    while (std::abs(profile[ring].y - position.y) > 1e-9) ++ring;
    position.z += forward[ring];
  }
  return mesh;
}

// Of a body 12 cm high at 22 x 32, from the wales that leave the sides near the bottom: theirs is the angle from the front.
inline knit::HalfIdeals belly_ideals(double size = 12.0, double bulge = 0.35) {
  constexpr double pi = std::numbers::pi;
  constexpr std::size_t steps = 6000;
  const double w = 10.0 / 22.0, h = 10.0 / 32.0;
  std::vector<BellyCircle> circles;
  double widest = 0.0;
  for (std::size_t i = 0; i <= steps; ++i) {
    BellyCircle c = belly_circle(static_cast<double>(i) / steps, bulge);
    circles.push_back({c.y * size / 2.0, std::max(0.0, c.radius) * size / 2.0, c.forward * size / 2.0});
    widest = std::max(widest, circles.back().radius);
  }
  std::vector<double> side{pi / 2.0}, climbed{0.0};
  bool carried = false;
  for (std::size_t i = 0; i < steps; ++i) {
    const BellyCircle &a = circles[i], &b = circles[i + 1];
    carried = carried || a.radius > 0.15 * widest;
    const double forward = b.forward - a.forward;
    const double turned = carried ? forward * std::sin(side.back()) / std::max(a.radius, 1e-6) : 0.0;
    side.push_back(std::clamp(side.back() + turned, 0.2, pi - 0.2));
    double step = 0.0;
    for (int k = 0; k < 32; ++k) {
      const double out = b.radius - a.radius + forward * std::cos(2.0 * pi * k / 32.0);
      step += std::sqrt((b.y - a.y) * (b.y - a.y) + out * out) / 32.0;
    }
    climbed.push_back(climbed.back() + step);
  }
  knit::HalfIdeals ideals;
  const auto rows = static_cast<std::size_t>(std::round(climbed.back() / h));
  for (std::size_t row = 1; row < rows; ++row) {
    const double cut = climbed.back() * static_cast<double>(row) / static_cast<double>(rows);
    const auto i =
        static_cast<std::size_t>(std::lower_bound(climbed.begin(), climbed.end(), cut) - climbed.begin());
    const double around = 2.0 * circles[i].radius / w;
    if (around * pi < 1.5) continue;
    ideals.front.push_back(side[i] * around);
    ideals.back.push_back((pi - side[i]) * around);
  }
  return ideals;
}

}  // namespace test_support
