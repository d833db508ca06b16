// The closed curve that a row's stitches stand on, measured along itself.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <tuple>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

enum class OrderedBy : std::uint8_t { angle, edges, cut };

// A closed polyline in working order from where rounds begin: a level's vertices, or a cut through edges.
struct Ring {
  std::vector<VertexId> vertices;  // one a point, copies of the first come last; empty for a cut
  std::vector<glm::dvec3> points;
  std::vector<double> arc;  // of each point, along the polyline from the first; rising, within [0, length]
  double length = 0.0;      // of the closed polyline
  OrderedBy ordered_by = OrderedBy::angle;
  [[nodiscard]] auto fields() const { return std::tie(vertices, points, arc, length, ordered_by); }
  friend bool operator==(const Ring&, const Ring&) = default;
};

// Fills in the arcs and the length of a ring whose points are there.
void measure_arcs(Ring& ring);

// Shorter than three half stitches: it makes no row.
bool too_short(const Ring& ring, double stitch_width);

// The place at `arc` along the closed polyline, for any arc (it wraps).
glm::dvec3 point_at(const Ring& ring, double arc);

// The middle of the polyline, every part counting by its length.
glm::dvec3 centre_of(const Ring& ring);

// The arc of the place on the polyline that is nearest to a point; of equally near ones the one ahead.
double nearest_arc(const Ring& ring, const glm::dvec3& point);

}  // namespace knit
