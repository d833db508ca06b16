// One length of yarn: a curve through its loops in the order in which hands make them.
//
// A uniform Catmull-Rom curve: between points p1 and p2, with p0 before and p3 after them,
//   c(x) = (2 p1 + (p2 - p0) x + (2 p0 - 5 p1 + 4 p2 - p3) x^2 + (3 p1 - p0 - 3 p2 + p3) x^3) / 2
// and beyond an end the last two points go on straight. It goes through its points. Mesh units.
// E. Catmull, R. Rom, "A class of local interpolating splines", 1974.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <tuple>
#include <vector>

namespace knit {

inline constexpr std::size_t points_a_stitch = 12;

// What a point of a curve is of. bar: of the strand that is lifted for the stitch named. bind_off, drawn and graft: after the
// last row, by the live stitch that it holds.
enum class YarnPart : std::uint8_t { loop, bar, bind_off, drawn, graft };

struct YarnCurve {
  std::vector<glm::dvec3> points;
  std::vector<std::uint32_t> stitches;  // of each point, by number along the knitting path
  std::vector<YarnPart> parts;          // of each point
  double radius = 0.0;
  [[nodiscard]] auto fields() const { return std::tie(points, stitches, parts, radius); }
  friend bool operator==(const YarnCurve&, const YarnCurve&) = default;
};

// `a_point` places from each point to the next, and the last point.
std::vector<glm::dvec3> sampled(const YarnCurve& curve, std::size_t a_point);
// Of the curve cut into straight pieces, eight from point to point: to about 1/1000.
double length_of(const YarnCurve& curve);

}  // namespace knit
