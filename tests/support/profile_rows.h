// What the rows of a shape of revolution hold, from its curve alone: rows as far apart along it as a round is high.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

namespace test_support {

struct CurvePoint {
  double radius = 0.0, y = 0.0;
};

// Of the examples' shapes, at t from 0 (the bottom) to 1.
inline CurvePoint curve_at(std::string_view shape, double t) {
  constexpr double pi = std::numbers::pi;
  const double s = std::sin(pi * t);
  const double c = std::cos(pi * t);
  if (shape == "stretched-sphere") return {0.8 * s, -1.6 * c};
  if (shape == "egg") return {0.93 * s * (1.0 + 0.16 * c), -1.25 * c};
  if (shape == "vase") {
    const double from_neck = (2.0 * t - 1.38) / 0.2;
    return {0.9 * s * (1.0 - 0.62 * std::exp(-from_neck * from_neck)), -1.3 * c};
  }
  if (shape == "capsule") {
    const double radius = 0.7;
    const double half = 0.6;
    const double along = t * (pi * radius + 2.0 * half) - pi * radius / 2.0 - half;
    const double angle = std::clamp(std::abs(along) - half, 0.0, pi * radius / 2.0) / radius;
    return {radius * std::cos(angle),
            std::copysign(std::min(std::abs(along), half) + radius * std::sin(angle), along)};
  }
  if (shape == "cone") {
    const double rim = 0.9;
    const double rim_y = -0.8;
    const double apex = 1.2;
    const double tip = 0.12;
    const double slope = std::atan2(rim, apex - rim_y);
    const double ball_y = apex - tip / std::sin(slope);
    const double part = 3.0 * t;
    if (part < 1.0) return {rim * std::sin(pi / 2.0 * part), rim_y - 0.4 * std::cos(pi / 2.0 * part)};
    const CurvePoint touch{tip * std::cos(slope), ball_y + tip * std::sin(slope)};
    if (part < 2.0) return {std::lerp(rim, touch.radius, part - 1.0), std::lerp(rim_y, touch.y, part - 1.0)};
    const double angle = slope + (pi / 2.0 - slope) * (part - 2.0);
    return {tip * std::cos(angle), ball_y + tip * std::sin(angle)};
  }
  return {s, -c};
}

struct Swatch {
  int stitches = 22, rounds = 32;  // in 10 cm
};

// In stitches; rows of less than one and a half are none.
inline std::vector<double> rows_of_curve(std::string_view shape, double height_cm, Swatch gauge) {
  constexpr int fine = 4000;
  const double scale = height_cm / (curve_at(shape, 1.0).y - curve_at(shape, 0.0).y);
  std::vector<CurvePoint> points;
  std::vector<double> along{0.0};
  for (int i = 0; i <= fine; ++i) {
    const CurvePoint point = curve_at(shape, static_cast<double>(i) / fine);
    points.push_back({scale * point.radius, scale * point.y});
    if (i == 0) continue;
    const CurvePoint& a = points[points.size() - 2];
    along.push_back(along.back() + std::hypot(points.back().radius - a.radius, points.back().y - a.y));
  }
  const int steps = std::max(2, static_cast<int>(std::round(along.back() * gauge.rounds / 10.0)));
  std::vector<double> rows;
  for (int step = 1; step < steps; ++step) {
    const double cut = along.back() * step / steps;
    const auto above =
        static_cast<std::size_t>(std::upper_bound(along.begin(), along.end(), cut) - along.begin());
    const double part = (cut - along[above - 1]) / (along[above] - along[above - 1]);
    const double radius = std::lerp(points[above - 1].radius, points[above].radius, part);
    const double stitches = 2.0 * std::numbers::pi * radius * gauge.stitches / 10.0;
    if (stitches >= 1.5) rows.push_back(stitches);
  }
  return rows;
}

}  // namespace test_support
