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
