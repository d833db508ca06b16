// Distances to plain bodies, and how they melt into one: what solids (implicit.h) are put together from.
//
// Each gives the distance from a place to the body's surface, negative inside. Lengths are in mesh units.
//
// J. C. Hart, "Sphere tracing", 1996 (distances); the rounded union is a common one in such modelling.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <span>
#include <vector>

namespace knit {

struct Ball {
  glm::dvec3 centre{0.0};
  double radius = 0.0;
};

// A tapering limb with round ends along a chain of balls: the radius goes evenly from one ball to the next. A straight
// one has two.
double limb_distance(const glm::dvec3& place, std::span<const Ball> balls);
double limb_distance(const glm::dvec3& place, const Ball& from, const Ball& to);

double ball_distance(const glm::dvec3& place, const Ball& ball);

// A ring of a round cross-section, flat in z = 0 about the origin.
double ring_distance(const glm::dvec3& place, double ring_radius, double tube_radius);

// A line of arcs, each touching the one before, from (0, start) towards +x, turning left; then a straight end.
struct Bend {
  double radius = 0.0;
  double turn = 0.0;  // radians, less than half a turn
};
class BentLine {
 public:
  BentLine(double start, std::span<const Bend> bends, double straight);
  [[nodiscard]] double distance(const glm::dvec2& place) const;
  [[nodiscard]] glm::dvec2 end() const { return end_.at + straight_ * end_.way; }

 private:
  struct Pen {  // where the line is, and which way it goes
    glm::dvec2 at{0.0};
    glm::dvec2 way{1.0, 0.0};
  };
  struct Arc {
    Pen from, to;
    glm::dvec2 centre{0.0};
    double radius = 0.0;
  };
  std::vector<Arc> arcs_;
  Pen end_;
  double straight_;
};

// The union of bodies, the furrows between them filled by a curve of about this radius. In whatever order they come:
// k = fillet, max(k, least d) - sqrt(sum of max(k - d, 0)^2).
double melted(std::initializer_list<double> distances, double fillet);
// What two bodies have in common, its ridge rounded likewise.
double common_part(double a, double b, double rounding);

}  // namespace knit
