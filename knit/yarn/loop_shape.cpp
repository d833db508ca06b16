#include "knit/yarn/loop_shape.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "knit/mesh/elementary.h"

namespace knit {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double a2 = 0.2424, a4 = 0.0092, A1 = 0.5848, A3 = -0.0118;
constexpr double d2 = 0.187, d4 = 0.004, d1 = -0.005, fitted_height = 0.72;

// The angle 2 pi `waves` i / 12, turned back into a single turn.
double angle(std::size_t waves, std::size_t i) {
  return 2.0 * pi * static_cast<double>(waves * i % points_a_stitch) / points_a_stitch;
}

// From u = -1/2 at t = 0 to u = 1/4 at t = 1/4, on to where the legs have crossed.
double crossing_leg(double t) {
  constexpr double slope_out = 0.6 * (1.0 + 4.0 * pi * a2 + 8.0 * pi * a4);
  constexpr double slope_in = -(1.0 - 4.0 * pi * a2 + 8.0 * pi * a4);
  const double q = t / 0.25, q2 = q * q, q3 = q2 * q;
  return -0.5 * (2.0 * q3 - 3.0 * q2 + 1.0) + 0.25 * slope_out * (q3 - 2.0 * q2 + q) +
         0.25 * (3.0 * q2 - 2.0 * q3) + 0.25 * slope_in * (q3 - q2);
}

double bump(double q) {
  constexpr double until = 0.3;
  if (q <= 0.0 || q >= until) return 0.0;
  const double s = sine(pi * q / until);
  return s * s;
}

glm::dvec3 unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : v;
}

}  // namespace

LoopShape plain_loop() {
  LoopShape shape;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const double t = static_cast<double>(i) / points_a_stitch;
    shape[i].u = t - 0.5 + a2 * sine(angle(2, i)) + a4 * sine(angle(4, i));
    shape[i].v = 0.5 - (A1 * cosine(angle(1, i)) + A3 * cosine(angle(3, i))) / fitted_height;
    shape[i].n = -d2 * cosine(angle(2, i)) - d4 * cosine(angle(4, i)) + d1 * cosine(angle(1, i));
  }
  return shape;
}

LoopShape twisted_loop(bool arrives_in_front) {
  constexpr double lift = 0.16;
  LoopShape shape = plain_loop();
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const double t = static_cast<double>(i) / points_a_stitch;
    shape[i].u = t < 0.25 ? crossing_leg(t) : t > 0.75 ? -crossing_leg(1.0 - t) : -shape[i].u;
    shape[i].n += (arrives_in_front ? lift : -lift) * (bump(t) - bump(1.0 - t));
  }
  return shape;
}

LoopFrame between(const LoopFrame& a, const LoopFrame& b) {
  return {0.5 * (a.place + b.place), 0.5 * (a.course + b.course), 0.5 * (a.wale + b.wale),
          unit(a.out + b.out), 0.5 * (a.raised + b.raised)};
}

glm::dvec3 placed(const LoopPoint& point, const LoopFrame& base, const LoopFrame& head, double stitch_width) {
  const double v = std::clamp(point.v, 0.0, 1.0), beyond = point.v - v, v2 = v * v, v3 = v2 * v;
  const double part = 3.0 * v2 - 2.0 * v3;
  const glm::dvec3 middle = (1.0 - part) * base.place + (v3 - 2.0 * v2 + v) * base.wale + part * head.place +
                            (v3 - v2) * head.wale + beyond * (beyond < 0.0 ? base.wale : head.wale);
  const glm::dvec3 course = (1.0 - part) * base.course + part * head.course;
  const glm::dvec3 out = unit((1.0 - part) * base.out + part * head.out);
  const double raised = (1.0 - part) * base.raised + part * head.raised;
  return middle + point.u * course + (point.n * stitch_width + raised) * out;
}

}  // namespace knit
