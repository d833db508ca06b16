#include "knit/yarn/loop_ends.h"

#include <numbers>

#include "knit/mesh/elementary.h"

namespace knit {

std::vector<glm::dvec3> drawn_through(const LoopFrame& head, double stitch_width) {
  constexpr double below_head = -0.15, middle = 0.1, deep = 0.4;
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i <= points_a_stitch; ++i) {
    const double u = static_cast<double>(i) / points_a_stitch - 0.5;
    const double n = middle - deep * sine(2.0 * std::numbers::pi * u);
    points.push_back(head.place + below_head * head.wale + u * head.course +
                     (n * stitch_width + head.raised) * head.out);
  }
  return points;
}

LoopFrame chained(const LoopFrame& next, double radius) {
  constexpr double up = 0.35, out = 1.2;
  LoopFrame head = next;
  head.place += up * next.wale;
  head.course = -next.wale;
  head.wale = next.course;
  head.raised = out * radius;
  return head;
}

LoopFrame facing(const LoopFrame& other, const LoopFrame& next) {
  LoopFrame head = between(other, next);
  head.course = -head.course;
  head.wale = -head.wale;
  return head;
}

}  // namespace knit
