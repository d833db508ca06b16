#include "knit/short_rows/sides.h"

#include <algorithm>
#include <array>

namespace knit {

std::vector<HalfEdge> across_sides(std::span<const Triangle> triangles) {
  struct Side {
    VertexId low, high;
    HalfEdge side;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (HalfEdge h = 0; h < 3 * triangles.size(); ++h) {
    const VertexId a = triangles[h / 3][h % 3], b = triangles[h / 3][(h + 1) % 3];
    sides.push_back({std::min(a, b), std::max(a, b), h});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    if (a.low != b.low) return a.low < b.low;
    return a.high != b.high ? a.high < b.high : a.side < b.side;
  });
  std::vector<HalfEdge> across(sides.size(), no_half_edge);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &one = sides[i], &other = sides[i + 1];
    if (one.low != other.low || one.high != other.high) continue;
    across[one.side] = other.side;
    across[other.side] = one.side;
    ++i;
  }
  return across;
}

std::vector<std::vector<VertexId>> rims_of(std::span<const Triangle> triangles,
                                           std::span<const HalfEdge> across) {
  std::vector<std::vector<VertexId>> rims;
  std::vector<std::uint8_t> seen(across.size(), 0);
  for (HalfEdge start = 0; start < across.size(); ++start) {
    if (across[start] != no_half_edge || seen[start] != 0) continue;
    std::vector<VertexId>& rim = rims.emplace_back();
    HalfEdge h = start;
    while (seen[h] == 0) {
      seen[h] = 1;
      rim.push_back(triangles[h / 3][h % 3]);
      // Round the side's end to the next side without a neighbour.
      HalfEdge next = next_in_triangle(h);
      while (across[next] != no_half_edge) next = next_in_triangle(across[next]);
      h = next;
    }
  }
  return rims;
}

}  // namespace knit
