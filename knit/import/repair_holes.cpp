// Closing cracks and small holes: parts of repair.h.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>

#include "knit/base/number_text.h"
#include "knit/import/check_topology.h"
#include "knit/import/quoting.h"
#include "knit/import/repair_parts.h"
#include "knit/mesh/edge_table.h"
#include "knit/mesh/elementary.h"
#include "knit/mesh/polygon.h"

namespace knit {

namespace {

constexpr std::size_t most_rim = 4096;  // edges; keeps filling a hostile rim quick

double length_between(const glm::dvec3& a, const glm::dvec3& b) {
  return hypotenuse(a.x - b.x, a.y - b.y, a.z - b.z);
}

std::string short_text(double value) {
  std::array<char, 32> buffer{};
  const auto end = number_into(buffer.data(), buffer.data() + buffer.size(), value, 2);
  return {buffer.data(), end.ptr};
}

// Vertices that stand for a place, in cells a few reaches wide, so that nearly all have only their own to search.
class Places {
 public:
  Places(const std::vector<glm::dvec3>& positions, const Bounds& bounds, double reach)
      : positions_(positions), low_(bounds.low), reach_(reach) {}

  // The nearest within reach, of equally near ones the first; else none.
  [[nodiscard]] VertexId near(VertexId vertex) const {
    const glm::dvec3& p = positions_[vertex];
    VertexId best = no_vertex;
    double least = reach_;
    const Cell low = cell_of(p - glm::dvec3(reach_));
    const Cell high = cell_of(p + glm::dvec3(reach_));
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          const auto cell = cells_.find(key_of_cell({x, y, z}));
          if (cell == cells_.end()) continue;
          for (const VertexId other : cell->second) {
            const double length = length_between(p, positions_[other]);
            const bool nearer = length < least || (length == least && other < best);
            if (nearer) least = length, best = other;
          }
        }
      }
    }
    return best;
  }
  void add(VertexId vertex) { cells_[key_of_cell(cell_of(positions_[vertex]))].push_back(vertex); }

 private:
  using Cell = std::array<std::int64_t, 3>;
  static constexpr double cell_reaches = 4.0;

  [[nodiscard]] Cell cell_of(const glm::dvec3& p) const {
    const glm::dvec3 q = (p - low_) / (cell_reaches * reach_);
    return {std::int64_t(std::floor(q.x)), std::int64_t(std::floor(q.y)), std::int64_t(std::floor(q.z))};
  }
  // A reach is that small a part of the bounds that 21 bits hold each number.
  static std::uint64_t key_of_cell(const Cell& cell) {
    std::uint64_t key = 0;
    for (const std::int64_t part : cell) key = (key << 21U) | static_cast<std::uint64_t>(part + 1);
    return key;
  }

  const std::vector<glm::dvec3>& positions_;
  glm::dvec3 low_;
  double reach_;
  std::unordered_map<std::uint64_t, std::vector<VertexId>> cells_;
};

using Loop = std::vector<VertexId>;

// The rims of holes, each as its new faces go round it; those that touch themselves or each other are left out.
struct Rims {
  std::vector<Loop> loops;  // by their lowest vertex
  std::size_t open_edges = 0;
};

Rims find_rims(const EdgeTable& table, std::span<const Triangle> triangles, std::span<const VertexId> twin) {
  std::vector<VertexId> next(twin.size(), no_vertex);
  std::vector<std::uint8_t> leaving(twin.size(), 0);
  std::vector<std::uint8_t> arriving(twin.size(), 0);
  const auto count_up = [](std::uint8_t& number) {
    number = static_cast<std::uint8_t>(std::min(number + 1, 2));
  };
  Rims rims;
  for (std::size_t v = 0; v < twin.size(); ++v) {
    for (std::uint32_t i = table.first[v], end = i; i < table.first[v + 1]; i = end) {
      while (end < table.first[v + 1] && table.uses[end].high == table.uses[i].high) ++end;
      if (end - i != 1) continue;
      const HalfEdge side = table.uses[i].half_edge;
      const Triangle corners = twins_of(triangles[side / 3], twin);
      const VertexId from = corners[(side % 3 + 1) % 3];  // against the triangle that is there
      const VertexId to = corners[side % 3];
      next[from] = to;
      count_up(leaving[from]);
      count_up(arriving[to]);
      ++rims.open_edges;
    }
  }
  std::vector<std::uint8_t> seen(twin.size(), 0);
  for (VertexId v = 0; v < twin.size(); ++v) {
    if (next[v] == no_vertex || seen[v] != 0) continue;
    Loop loop;
    bool simple = true;
    VertexId at = v;
    for (; at != no_vertex && seen[at] == 0; at = next[at]) {
      seen[at] = 1;
      loop.push_back(at);
      simple = simple && leaving[at] == 1 && arriving[at] == 1;
    }
    if (simple && at == v && loop.size() >= 3) rims.loops.push_back(std::move(loop));
  }
  return rims;
}

double length_round(const Loop& loop, const std::vector<glm::dvec3>& positions) {
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += length_between(positions[loop[i]], positions[loop[(i + 1) % loop.size()]]);
  return sum;
}

bool has_edge(const EdgeTable& table, VertexId a, VertexId b) {
  const auto [low, high] = std::minmax(a, b);
  const auto begin = table.uses.begin() + table.first[low];
  const auto end = table.uses.begin() + table.first[low + 1];
  return std::any_of(begin, end, [high = high](const EdgeUse& use) { return use.high == high; });
}

// About a new vertex in the middle: never makes an edge that is there already.
std::vector<Triangle> fan(const Loop& loop, std::vector<glm::dvec3>& positions) {
  std::vector<Triangle> faces;
  glm::dvec3 middle(0.0);
  for (const VertexId v : loop) middle += positions[v] / static_cast<double>(loop.size());
  const auto centre = static_cast<VertexId>(positions.size());
  positions.push_back(middle);
  for (std::size_t i = 0; i < loop.size(); ++i)
    faces.push_back({loop[i], loop[(i + 1) % loop.size()], centre});
  return faces;
}

// Across the hole where that makes no edge that is there already; else as a fan.
std::vector<Triangle> fill(const Loop& loop, const EdgeTable& table, std::vector<glm::dvec3>& positions) {
  std::vector<Triangle> faces;
  triangulate(loop, positions, faces);
  const auto is_side = [&](VertexId a, VertexId b) {
    const auto at = static_cast<std::size_t>(std::find(loop.begin(), loop.end(), a) - loop.begin());
    return loop[(at + 1) % loop.size()] == b || loop[(at + loop.size() - 1) % loop.size()] == b;
  };
  bool clear = true;
  for (const Triangle& face : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId a = face[k];
      const VertexId b = face[(k + 1) % 3];
      clear = clear && (is_side(a, b) || !has_edge(table, a, b));
    }
  }
  return clear ? faces : fan(loop, positions);
}

// The mesh with more faces, and their sides among its edges.
void add_faces(Mesh& mesh, const std::vector<Triangle>& faces) {
  std::vector<std::array<VertexId, 2>> edges = mesh.edges;
  for (const Triangle& face : faces)
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({face[k], face[(k + 1) % 3]});
  mesh.triangles.insert(mesh.triangles.end(), faces.begin(), faces.end());
  mesh.edges = unique_edges(edges, mesh.positions.size());
}

double longest_small(const Mesh& mesh) { return small_hole * bounds_of_used(mesh).diagonal(); }

}  // namespace

Effect weld_near(const Mesh& mesh) {
  const Bounds bounds = bounds_of_used(mesh);
  const double reach = weld_reach * bounds.diagonal();
  Effect effect{{mesh.name, {}, {}, {}}, 0, "merges", "merged", ""};
  if (!(reach > 0.0)) return effect;
  std::vector<std::uint8_t> used(mesh.positions.size(), 0);
  for (const Triangle& triangle : mesh.triangles)
    for (const VertexId v : triangle) used[v] = 1;
  Places places(mesh.positions, bounds, reach);
  std::vector<VertexId> moved(mesh.positions.size());
  for (VertexId v = 0; v < moved.size(); ++v) {
    // Strays stay as they are: they may lie anywhere.
    const VertexId near = used[v] != 0 ? places.near(v) : no_vertex;
    if (near == no_vertex) {
      if (used[v] != 0) places.add(v);
      moved[v] = static_cast<VertexId>(effect.mesh.positions.size());
      effect.mesh.positions.push_back(mesh.positions[v]);
    } else {
      moved[v] = moved[near];
    }
  }
  for (const Triangle& t : mesh.triangles) {
    const Triangle corners{moved[t[0]], moved[t[1]], moved[t[2]]};
    if (!collapsed(corners)) effect.mesh.triangles.push_back(corners);
  }
  std::vector<std::array<VertexId, 2>> edges;
  for (const auto& [a, b] : mesh.edges) edges.push_back({moved[a], moved[b]});
  effect.mesh.edges = unique_edges(edges, effect.mesh.positions.size());
  effect.count = mesh.positions.size() - effect.mesh.positions.size();
  effect.what = counted(effect.count, "vertex", "vertices") + " with another within " + short_text(reach);
  const std::size_t gone = mesh.triangles.size() - effect.mesh.triangles.size();
  if (gone > 0)
    effect.what += ", and " + counted(gone, "face that collapses", "faces that collapse") + " with it";
  return effect;
}

Effect fill_holes(const Mesh& mesh) {
  const std::vector<VertexId> twin = find_twins(mesh.positions);
  const EdgeTable table = make_edge_table(mesh.triangles, twin);
  const double longest = longest_small(mesh);
  Effect effect{mesh, 0, "fills", "filled", ""};
  std::size_t rim_edges = 0;
  std::vector<Triangle> faces;
  for (const Loop& loop : find_rims(table, mesh.triangles, twin).loops) {
    if (loop.size() > most_rim || length_round(loop, mesh.positions) > longest) continue;
    ++effect.count;
    rim_edges += loop.size();
    const std::vector<Triangle> filled = fill(loop, table, effect.mesh.positions);
    faces.insert(faces.end(), filled.begin(), filled.end());
  }
  add_faces(effect.mesh, faces);
  effect.what = counted(effect.count, "hole", "holes") + " of " + counted(rim_edges, "edge", "edges") +
                " with " + counted(faces.size(), "triangle", "triangles");
  return effect;
}

Effect close_openings(const Mesh& mesh) {
  const std::vector<VertexId> twin = find_twins(mesh.positions);
  const EdgeTable table = make_edge_table(mesh.triangles, twin);
  const double longest = longest_small(mesh);
  Effect effect{mesh, 0, "closes", "closed", ""};
  double round = 0.0;
  std::vector<Triangle> faces;
  for (const Loop& loop : find_rims(table, mesh.triangles, twin).loops) {
    const double length = length_round(loop, mesh.positions);
    if (loop.size() <= most_rim && length <= longest) continue;
    ++effect.count;
    round = std::max(round, length);
    const std::vector<Triangle> closing = fan(loop, effect.mesh.positions);
    faces.insert(faces.end(), closing.begin(), closing.end());
  }
  add_faces(effect.mesh, faces);
  effect.what = counted(effect.count, "hole that is", "holes that are") +
                " too large to be an error, the longest " + short_text(round) + " round, with " +
                counted(faces.size(), "triangle", "triangles") + " about a new vertex in the middle";
  return effect;
}

}  // namespace knit
