#include "knit/timing/timing.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "knit/model/ties.h"

namespace knit {

namespace {

double distance_from_centroid_line(const Input& input, VertexId vertex, const glm::dvec3& axis) {
  const glm::dvec3 offset = input.mesh.positions[vertex] - input.centroid;
  return glm::length(offset - glm::dot(offset, axis) * axis);
}

// The referenced vertex of greatest projection on `axis`.
VertexId extreme_vertex(const Input& input, const glm::dvec3& axis) {
  const double hair = tie * input.bounds.diagonal();
  double best_height = -std::numeric_limits<double>::infinity();
  for (VertexId v = 0; v < input.mesh.positions.size(); ++v) {
    if (input.referenced[v] != 0)
      best_height = std::max(best_height, glm::dot(input.mesh.positions[v], axis));
  }
  VertexId best = no_vertex;
  double best_offset = 0.0;
  for (VertexId v = 0; v < input.mesh.positions.size(); ++v) {
    if (input.referenced[v] == 0 || glm::dot(input.mesh.positions[v], axis) < best_height - hair) continue;
    const double offset = distance_from_centroid_line(input, v, axis);
    if (best == no_vertex || offset < best_offset - hair) {
      best = v;
      best_offset = offset;
    }
  }
  return best;
}

}  // namespace

std::variant<Ends, Stopped> find_ends(const Input& input, const TimingSettings& timing) {
  const glm::dvec3 axis = timing.axis.direction();
  const bool picked = timing.start != no_vertex || timing.end != no_vertex;
  Ends ends;
  ends.start = timing.start != no_vertex ? timing.start : extreme_vertex(input, -axis);
  ends.end = timing.end != no_vertex ? timing.end : extreme_vertex(input, axis);
  const Stopped flat{StopReason::no_extent, {}, -1, 0, 0, ends.start, 0.0, 0.0};
  if (ends.start == no_vertex || ends.end == no_vertex) return flat;

  const auto& positions = input.mesh.positions;
  ends.origin = positions[ends.start];
  const glm::dvec3 line = positions[ends.end] - ends.origin;
  ends.direction = picked ? line : axis * glm::dot(line, axis);
  if (glm::length(ends.direction) <= tie * input.bounds.diagonal()) return flat;
  return ends;
}

double time_of(const Ends& ends, const glm::dvec3& position) {
  const glm::dvec3 diff = position - ends.origin;
  return glm::dot(diff, ends.direction) / glm::dot(ends.direction, ends.direction);
}

}  // namespace knit
