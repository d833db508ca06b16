#include "knit/mesh/edge_table.h"

#include <algorithm>

namespace knit {

namespace {

// Turns counts at [v + 1] into where each group begins.
void counts_to_starts(std::vector<std::uint32_t>& first) {
  std::uint32_t total = 0;
  for (std::uint32_t& entry : first) entry = total += entry;
}

// Groups are nearly always a handful, where insertion beats std::sort; a pole may have thousands.
template <class T, class Less>
void sort_group(T* begin, T* end, Less less) {
  if (end - begin > 32) {
    std::sort(begin, end, less);
    return;
  }
  for (T* at = begin; at != end; ++at)
    for (T* back = at; back != begin && less(*back, back[-1]); --back) std::swap(*back, back[-1]);
}

}  // namespace

Triangle twins_of(const Triangle& triangle, std::span<const VertexId> twin) {
  return {twin[triangle[0]], twin[triangle[1]], twin[triangle[2]]};
}

bool collapsed(const Triangle& triangle) {
  return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}

EdgeTable make_edge_table(std::span<const Triangle> triangles, std::span<const VertexId> twin) {
  EdgeTable table;
  table.first.assign(twin.size() + 1, 0);
  for (const Triangle& triangle : triangles) {
    const Triangle corners = twins_of(triangle, twin);
    if (collapsed(corners)) continue;
    for (std::size_t k = 0; k < 3; ++k) ++table.first[std::min(corners[k], corners[(k + 1) % 3]) + 1];
  }
  counts_to_starts(table.first);
  table.uses.resize(table.first.back());

  std::vector<std::uint32_t> next(table.first.begin(), table.first.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Triangle corners = twins_of(triangles[t], twin);
    if (collapsed(corners)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
      table.uses[next[low]++] = {high, static_cast<std::uint32_t>(3 * t + k)};
    }
  }
  for (std::size_t v = 0; v < twin.size(); ++v) {
    EdgeUse* const uses = table.uses.data();
    sort_group(uses + table.first[v], uses + table.first[v + 1], [](const EdgeUse& a, const EdgeUse& b) {
      return a.high != b.high ? a.high < b.high : a.half_edge < b.half_edge;
    });
  }
  return table;
}

std::vector<std::vector<VertexId>> boundary_loops(std::span<const Triangle> triangles,
                                                  std::span<const VertexId> twin) {
  const EdgeTable table = make_edge_table(triangles, twin);
  struct OpenSide {
    VertexId from, to;
    bool leaves;  // the triangle runs that way
  };
  std::vector<OpenSide> sides;  // each edge twice, once from either end
  for (std::size_t v = 0; v < twin.size(); ++v) {
    for (std::uint32_t i = table.first[v], end = i; i < table.first[v + 1]; i = end) {
      while (end < table.first[v + 1] && table.uses[end].high == table.uses[i].high) ++end;
      if (end - i != 1) continue;
      const HalfEdge h = table.uses[i].half_edge;
      const auto low = static_cast<VertexId>(v);
      const bool up = twin[triangles[h / 3][h % 3]] == low;
      sides.push_back({low, table.uses[i].high, up});
      sides.push_back({table.uses[i].high, low, !up});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const OpenSide& a, const OpenSide& b) {
    return a.from != b.from ? a.from < b.from : a.leaves != b.leaves ? a.leaves : a.to < b.to;
  });
  std::vector<std::uint8_t> gone(sides.size(), 0);
  const auto first_at = [&](VertexId v) {
    return static_cast<std::size_t>(
        std::lower_bound(sides.begin(), sides.end(), v,
                         [](const OpenSide& side, VertexId from) { return side.from < from; }) -
        sides.begin());
  };
  // The next side from a vertex that nobody has walked.
  const auto next_from = [&](VertexId v) {
    std::size_t i = first_at(v);
    while (i < sides.size() && sides[i].from == v && gone[i] != 0) ++i;
    return i < sides.size() && sides[i].from == v ? i : sides.size();
  };
  std::vector<std::vector<VertexId>> loops;
  for (const OpenSide& begun : sides) {
    if (next_from(begun.from) == sides.size()) continue;
    std::vector<VertexId>& loop = loops.emplace_back();
    for (std::size_t at = next_from(begun.from); at != sides.size(); at = next_from(sides[at].to)) {
      loop.push_back(sides[at].from);
      gone[at] = 1;
      std::size_t back = first_at(sides[at].to);
      while (sides[back].to != sides[at].from || gone[back] != 0) ++back;
      gone[back] = 1;
    }
  }
  return loops;
}

std::vector<std::array<VertexId, 2>> unique_edges(std::span<const std::array<VertexId, 2>> edges,
                                                  std::size_t vertex_count) {
  std::vector<std::uint32_t> first(vertex_count + 1, 0);
  for (const auto& [a, b] : edges) ++first[std::min(a, b) + 1];
  counts_to_starts(first);
  std::vector<VertexId> highs(edges.size());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (const auto& [a, b] : edges) highs[next[std::min(a, b)]++] = std::max(a, b);

  std::vector<std::array<VertexId, 2>> unique;
  unique.reserve(edges.size() / 2);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const auto low = static_cast<VertexId>(v);
    sort_group(highs.data() + first[v], highs.data() + first[v + 1], std::less<VertexId>());
    VertexId last = low;
    for (std::uint32_t i = first[v]; i < first[v + 1]; ++i) {
      if (highs[i] == last) continue;
      last = highs[i];
      unique.push_back({low, last});
    }
  }
  return unique;
}

}  // namespace knit
