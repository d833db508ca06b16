#include "knit/yarn/yarn_curve.h"

#include <glm/geometric.hpp>

namespace knit {

std::vector<glm::dvec3> sampled(const YarnCurve& curve, std::size_t a_point) {
  const std::vector<glm::dvec3>& points = curve.points;
  if (points.size() < 2) return points;
  std::vector<glm::dvec3> places;
  places.reserve((points.size() - 1) * a_point + 1);
  const std::size_t last = points.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const glm::dvec3 &p1 = points[i], &p2 = points[i + 1];
    const glm::dvec3 p0 = i > 0 ? points[i - 1] : 2.0 * p1 - p2;
    const glm::dvec3 p3 = i + 2 <= last ? points[i + 2] : 2.0 * p2 - p1;
    for (std::size_t part = 0; part < a_point; ++part) {
      const double x = static_cast<double>(part) / static_cast<double>(a_point);
      places.push_back(0.5 * (2.0 * p1 + (p2 - p0) * x + (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) * (x * x) +
                              (3.0 * p1 - p0 - 3.0 * p2 + p3) * (x * x * x)));
    }
  }
  places.push_back(points.back());
  return places;
}

double length_of(const YarnCurve& curve) {
  constexpr std::size_t pieces = 8;
  const std::vector<glm::dvec3> places = sampled(curve, pieces);
  double length = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i) length += glm::distance(places[i - 1], places[i]);
  return length;
}

}  // namespace knit
