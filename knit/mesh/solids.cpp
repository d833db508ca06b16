#include "knit/mesh/solids.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "knit/mesh/elementary.h"

namespace knit {

namespace {

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

glm::dvec2 left_of(const glm::dvec2& way) { return {-way.y, way.x}; }

double piece_distance(const glm::dvec3& place, const Ball& from, const Ball& to) {
  const glm::dvec3 axis = to.centre - from.centre;
  const glm::dvec3 way = place - from.centre;
  const double part = std::clamp(glm::dot(way, axis) / glm::dot(axis, axis), 0.0, 1.0);
  return glm::length(way - part * axis) - (from.radius + part * (to.radius - from.radius));
}

}  // namespace

double ball_distance(const glm::dvec3& place, const Ball& ball) {
  return glm::length(place - ball.centre) - ball.radius;
}

double limb_distance(const glm::dvec3& place, const Ball& from, const Ball& to) {
  return piece_distance(place, from, to);
}

double limb_distance(const glm::dvec3& place, std::span<const Ball> balls) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < balls.size(); ++i)
    least = std::min(least, piece_distance(place, balls[i - 1], balls[i]));
  return least;
}

double ring_distance(const glm::dvec3& place, double ring_radius, double tube_radius) {
  return length_of(length_of(place.x, place.y) - ring_radius, place.z) - tube_radius;
}

BentLine::BentLine(double start, std::span<const Bend> bends, double straight)
    : end_{{0.0, start}}, straight_(straight) {
  for (const Bend& bend : bends) {
    const double s = sine(bend.turn);
    const double c = cosine(bend.turn);
    const glm::dvec2 left = left_of(end_.way);
    const Pen to{end_.at + bend.radius * (s * end_.way + (1.0 - c) * left), c * end_.way + s * left};
    arcs_.push_back({end_, to, end_.at + bend.radius * left, bend.radius});
    end_ = to;
  }
}

// From an arc where the place lies in its sector, and from the straight end.
double BentLine::distance(const glm::dvec2& place) const {
  const glm::dvec2 way = place - end_.at;
  const double along = std::clamp(glm::dot(way, end_.way), 0.0, straight_);
  double least = glm::length(way - along * end_.way);
  for (const Arc& arc : arcs_) {
    const glm::dvec2 out = place - arc.centre;
    if (glm::dot(out, arc.from.way) >= 0.0 && glm::dot(out, arc.to.way) <= 0.0)
      least = std::min(least, std::abs(glm::length(out) - arc.radius));
  }
  return least;
}

double melted(std::initializer_list<double> distances, double fillet) {
  double least = std::numeric_limits<double>::infinity();
  double squares = 0.0;
  for (const double d : distances) {
    least = std::min(least, d);
    const double depth = std::max(fillet - d, 0.0);
    squares += depth * depth;
  }
  return std::max(fillet, least) - std::sqrt(squares);
}

double common_part(double a, double b, double rounding) { return -melted({-a, -b}, rounding); }

}  // namespace knit
