// Puts the points of loops one after the other into curves: the last of a loop and the first of the next are one point, half way
// between them.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "knit/yarn/yarn_curve.h"

namespace knit {

class YarnPen {
 public:
  // Where a loop begins farther than `far` from where the last one ended, the yarn is cut.
  YarnPen(double radius, double far) : radius_(radius), far_(far) {}

  // A new yarn.
  void begin();
  // Requires two points or more.
  void add(const std::vector<glm::dvec3>& points, std::uint32_t stitch, YarnPart part);
  // Of the strand between the last loop and the next: it leaves it by `aside` before their middle, and comes back to it by as
  // much behind.
  void add_bar(std::vector<glm::dvec3> points, const glm::dvec3& aside, std::uint32_t stitch);

  [[nodiscard]] std::int32_t cuts() const { return cuts_; }
  std::vector<YarnCurve> take();

 private:
  void put(const glm::dvec3& point, std::uint32_t stitch, YarnPart part);

  double radius_, far_;
  std::vector<YarnCurve> curves_;
  std::int32_t cuts_ = 0;
  bool joined_ = false;  // the last point waits for the first of what comes next
  struct Bar {
    std::vector<glm::dvec3> points;
    glm::dvec3 aside{0.0};
    std::uint32_t stitch = 0;
  };
  std::vector<Bar> bars_;  // at most one, until the next loop is there
};

}  // namespace knit
