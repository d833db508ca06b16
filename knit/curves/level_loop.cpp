#include "knit/curves/level_loop.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <set>

namespace knit {
namespace {

using Piece = std::pair<EdgePlace, EdgePlace>;

// Above the level, or 0 on it: per vertex.
std::vector<double> above_level(const Mesh& mesh, std::span<const double> values, double level) {
  const std::vector<EdgeKey> edges = edges_of(mesh.triangles);
  double sum = 0.0;
  for (const auto& [a, b] : edges) sum += glm::length(mesh.positions[a] - mesh.positions[b]);
  const double near = 0.03 * sum / static_cast<double>(std::max<std::size_t>(edges.size(), 1));
  std::vector<double> above(values.size());
  for (std::size_t v = 0; v < values.size(); ++v) {
    above[v] = values[v] - level;
    if (std::abs(above[v]) < near) above[v] = 0.0;
  }
  return above;
}

EdgePlace crossing(const std::vector<double>& above, VertexId a, VertexId b) {
  return on_edge(std::min(a, b), std::max(a, b),
                 above[std::min(a, b)] / (above[std::min(a, b)] - above[std::max(a, b)]));
}

// The pieces of the level lines: across triangles, and along edges that part what is above from what is not.
std::vector<Piece> level_pieces(const Mesh& mesh, const std::vector<double>& above) {
  std::vector<Piece> pieces;
  std::map<EdgeKey, std::vector<bool>> sides;
  for (const Triangle& t : mesh.triangles) {
    bool high = false;
    bool low = false;
    for (const VertexId v : t) {
      high = high || above[v] > 0.0;
      low = low || above[v] < 0.0;
    }
    std::vector<EdgePlace> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId a = t[k];
      const VertexId b = t[(k + 1) % 3];
      if (above[a] == 0.0 && above[b] == 0.0) sides[edge_key(a, b)].push_back(high);
      if (above[a] == 0.0) ends.push_back(at_vertex(a));
      if (above[a] * above[b] < 0.0) ends.push_back(crossing(above, a, b));
    }
    if (high && low && ends.size() == 2) pieces.emplace_back(ends[0], ends[1]);
  }
  for (const auto& [edge, high] : sides)
    if (high.size() == 2 && high[0] != high[1])
      pieces.emplace_back(at_vertex(edge.first), at_vertex(edge.second));
  return pieces;
}

using Beyond = std::map<EdgePlace, std::set<EdgePlace>>;

void take(Beyond& beyond, const EdgePlace& a, const EdgePlace& b) {
  beyond[a].erase(b);
  beyond[b].erase(a);
}

// Walks from `start` until it can go no further; a ring that closes on the way is set aside.
void walk(Beyond& beyond, const EdgePlace& start, LevelLines& lines) {
  std::vector<EdgePlace> line{start};
  std::map<EdgePlace, std::size_t> index{{start, 0}};
  while (!beyond[line.back()].empty()) {
    const EdgePlace here = line.back();
    const EdgePlace next = *beyond[here].begin();
    take(beyond, here, next);
    const auto met = index.find(next);
    if (met == index.end()) {
      index[next] = line.size();
      line.push_back(next);
      continue;
    }
    const auto from = line.begin() + static_cast<std::ptrdiff_t>(met->second);
    if (line.end() - from >= 3) lines.rings.emplace_back(from, line.end());
    for (auto at = from + 1; at != line.end(); ++at) index.erase(*at);
    line.erase(from + 1, line.end());
  }
  if (line.size() > 1) lines.open.push_back(std::move(line));
}

}  // namespace

LevelLines level_lines(const Mesh& mesh, std::span<const double> values, double level) {
  const std::vector<double> above = above_level(mesh, values, level);
  Beyond beyond;
  for (const auto& [a, b] : level_pieces(mesh, above)) {
    beyond[a].insert(b);
    beyond[b].insert(a);
  }
  LevelLines lines;
  std::vector<EdgePlace> starts;  // the ends of open lines first
  for (const bool open : {true, false})
    for (const auto& [place, next] : beyond)
      if ((next.size() % 2 == 1) == open) starts.push_back(place);
  for (const EdgePlace& start : starts) walk(beyond, start, lines);
  return lines;
}

}  // namespace knit
