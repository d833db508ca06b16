#include "knit/spokes.h"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace knit {

Spokes spokes_of(const IntrinsicMesh& intrinsic, std::size_t vertex_count) {
  Spokes all{std::vector<std::uint32_t>(vertex_count + 1, 0),
             std::vector<Spoke>(3 * intrinsic.triangles.size())};
  for (const Triangle& triangle : intrinsic.triangles)
    for (const VertexId v : triangle) ++all.first[v + 1];
  for (std::size_t v = 0; v < vertex_count; ++v) all.first[v + 1] += all.first[v];
  std::vector<std::uint32_t> next(all.first.begin(), all.first.end() - 1);
  // Two triangles pass an edge in opposite directions, so each of its ends gets it once.
  for (std::size_t t = 0; t < intrinsic.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      all.spokes[next[intrinsic.triangles[t][k]]++] = {intrinsic.triangles[t][(k + 1) % 3],
                                                       intrinsic.lengths[t][k]};
  return all;
}

double reach_along_edges(const Spokes& spokes, VertexId start) {
  std::vector<double> distance(spokes.first.size() - 1, std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance[start] = 0.0;
  queue.emplace(0.0, start);
  double reach = 0.0;
  while (!queue.empty()) {
    const auto [so_far, v] = queue.top();
    queue.pop();
    if (so_far > distance[v]) continue;
    reach = so_far;
    for (const auto& [end, length] : spokes.at(v)) {
      if (so_far + length >= distance[end]) continue;
      distance[end] = so_far + length;
      queue.emplace(distance[end], end);
    }
  }
  return reach;
}

}  // namespace knit
