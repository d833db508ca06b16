#include "knit/short_rows/sides.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace knit {

std::vector<HalfEdge> across_sides(std::span<const Triangle> triangles) {
  struct Side {
    VertexId high;
    HalfEdge side;
  };
  const auto ends = [&](HalfEdge h) {
    const VertexId a = triangles[h / 3][h % 3], b = triangles[h / 3][(h + 1) % 3];
    return std::array{std::min(a, b), std::max(a, b)};
  };
  // By the lower end, counted; at each of those by the higher, of which there are few.
  const std::size_t count = 3 * triangles.size();
  VertexId most = 0;
  for (HalfEdge h = 0; h < count; ++h) most = std::max(most, ends(h)[0]);
  std::vector<std::uint32_t> first(count > 0 ? std::size_t{most} + 2 : 1, 0);
  for (HalfEdge h = 0; h < count; ++h) ++first[ends(h)[0] + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  std::vector<Side> sides(count);
  for (HalfEdge h = 0; h < count; ++h) {
    const auto [low, high] = ends(h);
    sides[next[low]++] = {high, h};
  }
  std::vector<HalfEdge> across(count, no_half_edge);
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    const std::span here = std::span(sides).subspan(first[v], first[v + 1] - first[v]);
    std::sort(here.begin(), here.end(), [](const Side& a, const Side& b) {
      return a.high != b.high ? a.high < b.high : a.side < b.side;
    });
    for (std::size_t i = 0; i + 1 < here.size(); ++i) {
      const Side &one = here[i], &other = here[i + 1];
      if (one.high != other.high) continue;
      across[one.side] = other.side;
      across[other.side] = one.side;
      ++i;
    }
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
