#include "knit/timing/timing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <utility>
#include <vector>

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

// The vertex farthest from a rim, along edges; of equals the highest along the axis.
VertexId farthest_from(const Input& input, const MeshRim& rim, const glm::dvec3& axis) {
  std::vector<double> distance(input.twin.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, VertexId>;
  std::set<Entry> queue;
  for (const VertexId v : rim.vertices) queue.emplace(distance[v] = 0.0, v);
  double reach = 0.0;
  while (!queue.empty()) {
    const auto [so_far, v] = *queue.begin();
    queue.erase(queue.begin());
    if (so_far > distance[v]) continue;
    reach = so_far;
    for (const VertexId n : input.neighbours_of(v)) {
      const double next = so_far + glm::distance(input.mesh.positions[v], input.mesh.positions[n]);
      if (next < distance[n]) queue.emplace(distance[n] = next, n);
    }
  }
  VertexId best = no_vertex;
  const auto height = [&](VertexId v) { return glm::dot(input.mesh.positions[v], axis); };
  for (VertexId v = 0; v < distance.size(); ++v) {
    if (distance[v] > reach || clearly_less(distance[v], reach, reach)) continue;
    if (best == no_vertex || clearly_less(height(best), height(v), input.bounds.diagonal())) best = v;
  }
  return best;
}

// By their roles, then by height along the axis; -1: none is left.
struct RimEnds {
  std::int32_t start = -1, end = -1;
};
RimEnds choose_rims(const Input& input, const glm::dvec3& axis) {
  RimEnds chosen;
  std::vector<std::pair<double, std::int32_t>> free;
  for (std::size_t r = 0; r < input.rims.size(); ++r) {
    const MeshRim& rim = input.rims[r];
    const auto id = static_cast<std::int32_t>(r);
    if (rim.role == RimRole::start) {
      chosen.start = id;
    } else if (rim.role == RimRole::end) {
      chosen.end = id;
    } else {
      double height = 0.0;
      for (const VertexId v : rim.vertices) height += glm::dot(input.mesh.positions[v], axis);
      free.emplace_back(height / static_cast<double>(rim.vertices.size()), id);
    }
  }
  std::sort(free.begin(), free.end(), [&](const auto& a, const auto& b) {
    if (clearly_less(a.first, b.first, input.bounds.diagonal())) return true;
    return !clearly_less(b.first, a.first, input.bounds.diagonal()) && a.second < b.second;
  });
  if (chosen.start < 0 && !free.empty()) {
    chosen.start = free.front().second;
    free.erase(free.begin());
  }
  if (chosen.end < 0 && !free.empty()) chosen.end = free.back().second;
  return chosen;
}

std::variant<Ends, Stopped> find_open_ends(const Input& input, const TimingSettings& timing) {
  const glm::dvec3 axis = timing.axis.direction();
  const std::vector<glm::dvec3>& positions = input.mesh.positions;
  const RimEnds rims = choose_rims(input, axis);
  const auto rim = [&](std::int32_t id) -> const MeshRim& {
    return input.rims[static_cast<std::size_t>(id)];
  };
  const bool harmonic = timing.kind == TimingKind::harmonic || timing.kind == TimingKind::by_itself;
  if (!harmonic || input.rims.size() > 2)
    return Stopped{StopReason::open_edge,
                   {},
                   -1,
                   static_cast<std::int32_t>(input.rims.size()),
                   0,
                   input.rims.front().vertices.front(),
                   0.0,
                   0.0};
  Ends ends;
  ends.start_rim = rims.start;
  ends.end_rim = rims.end;
  // Whoever says where to start from a vertex ends at the edge.
  const bool from_vertex = rims.end < 0 && timing.start != no_vertex;
  if (from_vertex) std::swap(ends.start_rim, ends.end_rim);
  const VertexId picked = ends.start_rim < 0 ? timing.start : timing.end;
  const auto tip = [&](std::int32_t other) {
    return picked != no_vertex ? input.twin[picked] : farthest_from(input, rim(other), axis);
  };
  ends.start = ends.start_rim >= 0 ? rim(ends.start_rim).vertices.front() : tip(ends.end_rim);
  ends.end = ends.end_rim >= 0 ? rim(ends.end_rim).vertices.front() : tip(ends.start_rim);
  if (timing.swap_ends == SwapEnds::on) {
    std::swap(ends.start, ends.end);
    std::swap(ends.start_rim, ends.end_rim);
  }
  const auto middle = [&](std::int32_t id, VertexId vertex) {
    if (id < 0) return positions[vertex];
    glm::dvec3 sum(0.0);
    for (const VertexId v : rim(id).vertices) sum += positions[v];
    return sum / static_cast<double>(rim(id).vertices.size());
  };
  const Stopped flat{StopReason::no_extent, {}, -1, 0, 0, ends.start, 0.0, 0.0};
  const std::int32_t both = ends.start_rim >= 0 ? ends.start_rim : ends.end_rim;
  const VertexId other = ends.start_rim >= 0 ? ends.end : ends.start;
  const std::vector<VertexId>& around = rim(both).vertices;
  if (std::find(around.begin(), around.end(), other) != around.end()) return flat;
  ends.origin = middle(ends.start_rim, ends.start);
  ends.direction = middle(ends.end_rim, ends.end) - ends.origin;
  return ends;
}

}  // namespace

std::variant<Ends, Stopped> find_ends(const Input& input, const TimingSettings& timing) {
  if (!input.rims.empty()) return find_open_ends(input, timing);
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
