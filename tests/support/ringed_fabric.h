// Rings put into a fabric of no shape: cast-on edges that two tubes share, and live loops that are grafted to each other.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "knit/run/state.h"

namespace test_support {

class RingedFabric {
 public:
  explicit RingedFabric(unsigned seed) : random_(seed) {}

  // Of its cast-on tubes and of its live loops, which all end with a row, pairs by chance.
  knit::State of(knit::State state) {
    std::vector<Edge> cast_on, live;
    for (const auto& row : state.fabric.rows()) {
      if (row->on.empty()) cast_on.push_back({row->tube, knit::all_of(*row)});
    }
    for (const knit::LiveLoop& loop : state.fabric.live()) live.push_back({loop.tube, loop.stitches});
    add_pairs(state.fabric, knit::DealKind::ring_cast_on, cast_on);
    add_pairs(state.fabric, knit::DealKind::ring_bind_off, live);
    return state;
  }

 private:
  struct Edge {
    knit::TubeId tube;
    knit::LiveStitches loop;
  };
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  void add_pairs(knit::Fabric& fabric, knit::DealKind kind, std::vector<Edge> edges) {
    while (edges.size() >= 2 && below(4) > 0) {
      const Edge one = taken_from(edges), two = taken_from(edges);
      knit::Deal deal;
      deal.kind = kind;
      deal.after = fabric.row_count();
      deal.from = {one.tube, two.tube};
      deal.taken = {one.loop, two.loop};
      deal.column_edges = strip(fabric.path_indices(one.loop), fabric.path_indices(two.loop));
      fabric.add(std::move(deal));
    }
  }
  Edge taken_from(std::vector<Edge>& edges) {
    const auto at = edges.begin() + below(static_cast<int>(edges.size()));
    Edge edge = *at;
    edges.erase(at);
    return edge;
  }

  // The two run against each other; more than two on one stitch only where one loop is more than twice the other.
  std::vector<std::array<std::uint32_t, 2>> strip(std::vector<std::uint32_t> one,
                                                  std::vector<std::uint32_t> two) {
    std::reverse(two.begin(), two.end());
    std::rotate(two.begin(), two.begin() + below(static_cast<int>(two.size())), two.end());
    const bool grows = two.size() >= one.size();
    const auto& large = grows ? two : one;
    const auto& small = grows ? one : two;
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (std::size_t cell = 0; cell < large.size(); ++cell) {
      const std::uint32_t other = small[cell * small.size() / large.size()];
      edges.push_back(grows ? std::array{other, large[cell]} : std::array{large[cell], other});
    }
    return edges;
  }

  std::mt19937 random_;
};

}  // namespace test_support
