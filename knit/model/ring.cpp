#include "knit/model/ring.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/model/ties.h"

namespace knit {

void measure_arcs(Ring& ring) {
  ring.arc.reserve(ring.points.size());
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    ring.arc.push_back(ring.length);
    ring.length += glm::distance(ring.points[i], ring.points[(i + 1) % ring.points.size()]);
  }
}

bool too_short(const Ring& ring, double stitch_width) {
  return clearly_less(ring.length, 1.5 * stitch_width, stitch_width);
}

glm::dvec3 point_at(const Ring& ring, double arc) {
  double wrapped = std::fmod(arc, ring.length);
  if (wrapped < 0.0) wrapped += ring.length;
  const auto after = std::upper_bound(ring.arc.begin(), ring.arc.end(), wrapped);
  const auto i = static_cast<std::size_t>(after - ring.arc.begin()) - 1;
  const double next_arc = i + 1 < ring.arc.size() ? ring.arc[i + 1] : ring.length;
  const glm::dvec3& from = ring.points[i];
  const glm::dvec3& to = ring.points[(i + 1) % ring.points.size()];
  const double span = next_arc - ring.arc[i];
  return span > 0.0 ? from + (to - from) * ((wrapped - ring.arc[i]) / span) : from;
}

glm::dvec3 centre_of(const Ring& ring) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const glm::dvec3& a = ring.points[i];
    const glm::dvec3& b = ring.points[i + 1 < ring.points.size() ? i + 1 : 0];
    sum += glm::distance(a, b) * 0.5 * (a + b);
  }
  return ring.length > 0.0 ? sum / ring.length : ring.points.front();
}

double nearest_arc(const Ring& ring, const glm::dvec3& point) {
  const double scale = ring.length * ring.length;
  double best = 0.0, best_square = 0.0;
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const glm::dvec3& a = ring.points[i];
    const glm::dvec3 side = ring.points[i + 1 < ring.points.size() ? i + 1 : 0] - a;
    const double square = glm::dot(side, side);
    const double share = square > 0.0 ? std::clamp(glm::dot(point - a, side) / square, 0.0, 1.0) : 0.0;
    const glm::dvec3 away = a + share * side - point;
    const double distance = glm::dot(away, away), arc = ring.arc[i] + share * std::sqrt(square);
    // Where the polyline begins must not matter: ahead is what lies less than half a round further on.
    const bool nearer = i == 0 || clearly_less(distance, best_square, scale);
    const bool as_near = !nearer && !clearly_less(best_square, distance, scale);
    const double further = arc < best ? arc - best + ring.length : arc - best;
    if (!nearer && !(as_near && further < 0.5 * ring.length)) continue;
    best_square = nearer ? distance : best_square;
    best = arc;
  }
  return best < ring.length ? best : 0.0;
}

}  // namespace knit
