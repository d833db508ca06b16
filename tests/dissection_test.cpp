#include "knit/timing/dissection.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/rough_sphere.h"

using namespace knit;
using namespace test_support;

namespace {

// How many entries the factor of a matrix with this net's edges has, eliminated in this order.
std::size_t fill_of(const Spokes& spokes, const std::vector<VertexId>& order) {
  std::vector<std::size_t> rank(spokes.first.size() - 1);
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
  std::vector<std::vector<std::size_t>> below(order.size());
  std::size_t fill = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::vector<std::size_t>& column = below[i];
    for (const Spoke& spoke : spokes.at(order[i]))
      if (rank[spoke.end] > i) column.push_back(rank[spoke.end]);
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    fill += 1 + column.size();
    // Whoever is eliminated next inherits the rest.
    if (!column.empty()) {
      std::vector<std::size_t>& heir = below[column[0]];
      heir.insert(heir.end(), column.begin() + 1, column.end());
    }
  }
  return fill;
}

}  // namespace

TEST_CASE("dissection: every used vertex comes once, and the factor stays sparse", "[dissection]") {
  Mesh mesh = rough_sphere(4, 1);
  const std::size_t used = mesh.positions.size();
  mesh.positions.emplace_back(3.0, 3.0, 3.0);  // no triangle uses it
  const Spokes spokes = spokes_of(make_intrinsic(*make_input(mesh)), mesh.positions.size());
  const std::vector<VertexId> order = order_by_dissection(spokes, mesh.positions);
  std::vector<VertexId> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<VertexId> all(used);
  std::iota(all.begin(), all.end(), VertexId{0});
  CHECK(sorted == all);
  const auto n = static_cast<double>(used);
  // Measured: 2.48 n log2 n, and fourteen times as many in the order in which the vertices come.
  CHECK(static_cast<double>(fill_of(spokes, order)) < 3.0 * n * std::log2(n));
  CHECK(fill_of(spokes, order) * 5 < fill_of(spokes, all));
}

TEST_CASE("dissection: it is heard, in the same order, and broken off", "[dissection]") {
  const Mesh mesh = rough_sphere(4, 1);
  const Spokes spokes = spokes_of(make_intrinsic(*make_input(mesh)), mesh.positions.size());
  std::vector<double> shares;
  const std::vector<VertexId> order =
      order_by_dissection(spokes, mesh.positions, [&](double share) { shares.push_back(share); });
  CHECK(order == order_by_dissection(spokes, mesh.positions));
  CHECK(shares.size() >= 4);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.front() < 0.3);
  CHECK(shares.back() > 0.4);
  CHECK(shares.back() <= 1.0);
  struct BrokenOff {};
  CHECK_THROWS_AS(order_by_dissection(spokes, mesh.positions, [](double /*share*/) { throw BrokenOff{}; }),
                  BrokenOff);
}

TEST_CASE("dissection: a pole with every other vertex around it can be ordered", "[dissection]") {
  const Mesh mesh = sphere(500, 2);
  const Spokes spokes = spokes_of(make_intrinsic(*make_input(mesh)), mesh.positions.size());
  CHECK(order_by_dissection(spokes, mesh.positions).size() == mesh.positions.size());
}

TEST_CASE("spokes: every edge is at both of its ends, and the farthest vertex is found", "[dissection]") {
  const Mesh mesh = rough_sphere(3, 2);
  const Spokes spokes = spokes_of(make_intrinsic(*make_input(mesh)), mesh.positions.size());
  std::size_t ends = 0;
  std::size_t wanted = 0;
  std::vector<double> way(mesh.positions.size(), HUGE_VAL);
  way[0] = 0.0;
  for (VertexId v = 0; v < mesh.positions.size(); ++v) {
    wanted += v * spokes.at(v).size();
    for (const Spoke& spoke : spokes.at(v)) ends += spoke.end;
  }
  CHECK(ends == wanted);
  for (int round = 0; round < 60; ++round)  // slower, yet plainer, than the program's way
    for (VertexId v = 0; v < mesh.positions.size(); ++v)
      for (const auto& [end, length] : spokes.at(v)) way[end] = std::min(way[end], way[v] + length);
  CHECK(reach_along_edges(spokes, 0) == Approx(*std::max_element(way.begin(), way.end())));
}
