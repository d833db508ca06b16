#include "knit/mesh/surface_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <queue>
#include <random>
#include <set>
#include <utility>

#include "knit/import/check.h"
#include "knit/mesh/shapes.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"

using namespace knit;

namespace {

using Cell = std::array<int, 3>;

// The surface of a solid of unit cubes, each square cut into parts * parts. Every square has vertices of its
// own, so that all of it hangs together by twins only.
Mesh surface_of(const std::set<Cell>& solid, int parts) {
  Mesh mesh;
  const auto add_square = [&](const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b) {
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; j < parts; ++j) {
        const auto at = [&](int di, int dj) {
          return corner + a * (double(i + di) / parts) + b * (double(j + dj) / parts);
        };
        const auto first = static_cast<VertexId>(mesh.positions.size());
        for (const glm::dvec3& p : {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}) mesh.positions.push_back(p);
        const VertexId turn = (i + j) % 2 == 0 ? 0 : 1;
        for (const VertexId half : {0U, 2U})
          mesh.triangles.push_back(
              {first + (turn + half) % 4, first + (turn + half + 1) % 4, first + (turn + half + 2) % 4});
      }
    }
  };
  for (const Cell& cell : solid) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        Cell beyond = cell;
        beyond[static_cast<std::size_t>(axis)] += side;
        if (solid.count(beyond) > 0) continue;
        std::array<glm::dvec3, 3> unit{glm::dvec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        const auto k = static_cast<std::size_t>(axis);
        glm::dvec3 corner(cell[0], cell[1], cell[2]);
        if (side > 0) corner += unit[k];
        glm::dvec3 a = unit[(k + 1) % 3];
        glm::dvec3 b = unit[(k + 2) % 3];
        if (side < 0) std::swap(a, b);
        add_square(corner, a, b);
      }
    }
  }
  return mesh;
}

std::set<Cell> block(const Cell& size, const Cell& from = {0, 0, 0}) {
  std::set<Cell> cells;
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) cells.insert({from[0] + x, from[1] + y, from[2] + z});
  return cells;
}

VertexId vertex_at(const Input& input, const glm::dvec3& place) {
  const auto& all = input.mesh.positions;
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const glm::dvec3& p) { return glm::distance(p, place) < 1e-12; });
  REQUIRE(found != all.end());
  return static_cast<VertexId>(found - all.begin());
}

double distance(const Input& input, VertexId a, VertexId b, double radius = not_reached) {
  return surface_distances(input, a, std::array{b}, radius).front();
}

double distance(const Input& input, const glm::dvec3& a, const glm::dvec3& b) {
  return distance(input, vertex_at(input, a), vertex_at(input, b));
}

std::vector<VertexId> all_vertices(const Input& input) {
  std::vector<VertexId> all;
  for (VertexId v = 0; v < input.twin.size(); ++v) all.push_back(v);
  return all;
}

std::vector<std::vector<double>> table_of(const Input& input) {
  std::vector<std::vector<double>> table;
  const std::vector<VertexId> all = all_vertices(input);
  for (const VertexId v : all) table.push_back(surface_distances(input, v, all));
  return table;
}

// Closed, with hills, pits and thin triangles.
Mesh bumpy(unsigned subdivisions, unsigned seed) {
  Mesh mesh = icosphere(subdivisions);
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  for (glm::dvec3& p : mesh.positions) {
    p *= between(0.6, 1.4);
    p += glm::dvec3(between(-0.08, 0.08), between(-0.08, 0.08), between(-0.08, 0.08));
  }
  return mesh;
}

using Graph = std::vector<std::vector<std::pair<std::size_t, double>>>;

std::vector<double> dijkstra(const Graph& graph, std::size_t source) {
  std::vector<double> best(graph.size(), not_reached);
  std::priority_queue<std::pair<double, std::size_t>> queue;
  best[source] = 0.0;
  queue.push({0.0, source});
  while (!queue.empty()) {
    const auto [negative, at] = queue.top();
    queue.pop();
    if (-negative > best[at]) continue;
    for (const auto& [next, length] : graph[at]) {
      if (best[at] + length >= best[next]) continue;
      best[next] = best[at] + length;
      queue.push({-best[next], next});
    }
  }
  return best;
}

Graph edge_graph(const Input& input) {
  Graph graph(input.twin.size());
  for (VertexId v = 0; v < graph.size(); ++v)
    for (const VertexId other : input.neighbours_of(v))
      graph[v].push_back({other, glm::distance(input.mesh.positions[v], input.mesh.positions[other])});
  return graph;
}

// Every side carries `extra` points, and within a triangle all are joined: nearly all ways. No twins here.
Graph dense_graph(const Mesh& mesh, std::size_t extra) {
  std::vector<glm::dvec3> points = mesh.positions;
  std::vector<std::pair<std::pair<VertexId, VertexId>, std::size_t>> sides;  // and their first point
  const auto first_point = [&](VertexId a, VertexId b) {
    const auto side = std::minmax(a, b);
    for (const auto& [known, first] : sides)
      if (known == std::pair(side.first, side.second)) return first;
    sides.push_back({{side.first, side.second}, points.size()});
    for (std::size_t i = 1; i <= extra; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(extra + 1);
      points.push_back(mesh.positions[side.first] * (1 - share) + mesh.positions[side.second] * share);
    }
    return sides.back().second;
  };
  std::vector<std::vector<std::size_t>> members;
  for (const Triangle& t : mesh.triangles) {
    std::vector<std::size_t> all{t[0], t[1], t[2]};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t first = first_point(t[k], t[(k + 1) % 3]);
      for (std::size_t i = 0; i < extra; ++i) all.push_back(first + i);
    }
    members.push_back(std::move(all));
  }
  Graph graph(points.size());
  for (const auto& all : members)
    for (const std::size_t a : all)
      for (const std::size_t b : all)
        if (a != b) graph[a].push_back({b, glm::distance(points[a], points[b])});
  return graph;
}

}  // namespace

TEST_CASE("surface distance: on a cube, across edges and to the far corner", "[surface_distance]") {
  for (const int parts : {1, 2, 5, 8}) {
    CAPTURE(parts);
    const auto cube = make_input(surface_of(block({1, 1, 1}), parts));
    REQUIRE(check(cube->mesh).fit());
    CHECK(distance(*cube, {0, 0, 0}, {1, 0, 0}) == Approx(1.0).epsilon(1e-12));
    CHECK(distance(*cube, {0, 0, 0}, {0, 1, 1}) == Approx(std::sqrt(2.0)).epsilon(1e-12));
    CHECK(distance(*cube, {0, 0, 0}, {1, 1, 1}) == Approx(std::sqrt(5.0)).epsilon(1e-12));
    CHECK(distance(*cube, {1, 0, 1}, {0, 1, 0}) == Approx(std::sqrt(5.0)).epsilon(1e-12));
  }
  const auto cube = make_input(surface_of(block({1, 1, 1}), 8));
  // From the floor of a wall over its upper edge, and from the middle of a wall to the opposite one.
  CHECK(distance(*cube, {0.25, 0.25, 1}, {1, 0.875, 0.5}) == Approx(std::hypot(1.25, 0.625)).epsilon(1e-12));
  CHECK(distance(*cube, {0.5, 0.5, 0}, {0.5, 0.5, 1}) == Approx(2.0).epsilon(1e-12));
  CHECK(distance(*cube, {0.5, 0.25, 0}, {0.5, 0.5, 1}) == Approx(1.75).epsilon(1e-12));
}

TEST_CASE("surface distance: along a long box, the spider takes five walls to the fly",
          "[surface_distance]") {
  const auto bar = make_input(surface_of(block({6, 1, 1}), 2));
  CHECK(distance(*bar, {0, 0, 0}, {6, 1, 1}) == Approx(std::sqrt(40.0)).epsilon(1e-12));
  CHECK(distance(*bar, {0, 0.5, 0.5}, {6, 0.5, 0.5}) == Approx(7.0).epsilon(1e-12));
  // Dudeney's room, halved: 15 by 6 by 6, the spider half a unit below the ceiling, the fly above the floor.
  const auto room = make_input(surface_of(block({15, 6, 6}), 2));
  CHECK(distance(*room, {0, 3, 5.5}, {15, 3, 0.5}) == Approx(20.0).epsilon(1e-12));
}

TEST_CASE("surface distance: a cylinder's side rolls out flat", "[surface_distance]") {
  const std::vector<ProfilePoint> profile{{0, -2}, {1, -2}, {1, -0.75}, {1, 0}, {1, 0.5}, {1, 2}, {0, 2}};
  constexpr unsigned segments = 24;
  const auto input = make_input(revolve("cylinder", profile, segments, true));
  const double facet = 2.0 * std::sin(std::numbers::pi / segments);
  const auto ring = [](unsigned j, unsigned i) { return 1 + j * (segments + 1) + i; };
  for (const unsigned turn : {0U, 1U, 4U, 9U, 15U, 23U, 24U}) {
    CAPTURE(turn);
    const double across = facet * std::min(turn, segments - turn);
    CHECK(distance(*input, ring(1, 0), ring(3, turn)) == Approx(std::hypot(across, 1.25)).epsilon(1e-12));
    CHECK(distance(*input, ring(2, 5), ring(2, (5 + turn) % segments)) == Approx(across).margin(1e-12));
  }
}

TEST_CASE("surface distance: the way bends where the surface has more than a full turn",
          "[surface_distance]") {
  std::set<Cell> corner = block({2, 1, 1});
  corner.insert({0, 1, 0});
  for (const int parts : {4, 8}) {
    const auto input = make_input(surface_of(corner, parts));
    REQUIRE(check(input->mesh).fit());
    // On top, round the inner corner (1, 1, 1); below it, straight through the inner edge.
    CHECK(distance(*input, {2, 0.75, 1}, {0.75, 2, 1}) == Approx(2 * std::hypot(1, 0.25)).epsilon(1e-12));
    CHECK(distance(*input, {1.5, 1, 0.25}, {1, 1.75, 0.5}) == Approx(std::hypot(1.25, 0.25)).epsilon(1e-12));
  }
  std::set<Cell> tower = block({3, 3, 1});
  tower.merge(block({1, 1, 2}, {1, 1, 1}));
  const auto input = make_input(surface_of(tower, 4));
  REQUIRE(check(input->mesh).fit());
  // Round two corners of the tower's foot, or one.
  CHECK(distance(*input, {0.5, 1.5, 1}, {2.5, 1.5, 1}) == Approx(1 + std::sqrt(2.0)).epsilon(1e-12));
  CHECK(distance(*input, {0.75, 1.25, 1}, {1.75, 2.25, 1}) ==
        Approx(2 * std::hypot(0.25, 0.75)).epsilon(1e-12));
  // Up the tower, from plain to wall in one line.
  CHECK(distance(*input, {0.5, 1.25, 1}, {1, 1.75, 2}) == Approx(std::hypot(1.5, 0.5)).epsilon(1e-12));
}

TEST_CASE("surface distance: a finer sphere comes closer to great circles", "[surface_distance]") {
  double last = 1.0;
  for (const unsigned subdivisions : {1U, 2U, 3U, 4U}) {
    const auto input = make_input(icosphere(subdivisions));
    const std::vector<double> distances = surface_distances(*input, 0, all_vertices(*input));
    double worst = 0.0;
    for (VertexId v = 1; v < distances.size(); ++v) {
      const double chord = glm::distance(input->mesh.positions[0], input->mesh.positions[v]);
      const double arc = 2.0 * std::asin(std::min(1.0, 0.5 * chord));
      CHECK(distances[v] >= chord - 1e-12);
      CHECK(distances[v] <= arc + 1e-12);  // the mesh lies within the sphere
      worst = std::max(worst, (arc - distances[v]) / arc);
    }
    CAPTURE(subdivisions, worst);
    CHECK(worst < 0.4 * last);
    last = worst;
  }
  CHECK(last < 0.002);
}

TEST_CASE("surface distance: is a metric between the straight line and the edges", "[surface_distance]") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    CAPTURE(seed);
    const auto input = make_input(bumpy(2, seed));
    const auto table = table_of(*input);
    const Graph edges = edge_graph(*input);
    std::size_t wrong = 0;
    for (VertexId a = 0; a < table.size(); ++a) {
      const std::vector<double> by_edges = dijkstra(edges, a);
      for (VertexId b = 0; b < table.size(); ++b) {
        const double here = table[a][b];
        const double straight = glm::distance(input->mesh.positions[a], input->mesh.positions[b]);
        if (std::abs(here - table[b][a]) > 1e-9 * here) ++wrong;
        if (here < straight * (1 - 1e-12) || here > by_edges[b] * (1 + 1e-12)) ++wrong;
        for (VertexId c = 0; c < table.size(); c += 7)
          if (here > (table[a][c] + table[c][b]) * (1 + 1e-9)) ++wrong;
      }
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("surface distance: no way through many points on the edges is shorter", "[surface_distance]") {
  for (unsigned seed = 1; seed <= test_support::repeated(4U); ++seed) {
    CAPTURE(seed);
    const Mesh mesh = bumpy(seed % 2, seed);
    const auto input = make_input(mesh);
    const Graph graph = dense_graph(mesh, seed % 2 == 0 ? 30 : 12);
    for (const VertexId source : {0U, 5U, 11U}) {
      const std::vector<double> exact = surface_distances(*input, source, all_vertices(*input));
      const std::vector<double> dense = dijkstra(graph, source);
      for (VertexId v = 0; v < exact.size(); ++v) {
        CHECK(exact[v] <= dense[v] * (1 + 1e-12));
        CHECK(exact[v] >= dense[v] * (1 - 0.004));
      }
    }
  }
}

TEST_CASE("surface distance: does not depend on how many ask", "[surface_distance]") {
  const auto input = make_input(bumpy(3, 9));
  const std::vector<VertexId> all = all_vertices(*input);
  for (const VertexId source : {0U, 100U, 333U}) {
    const std::vector<double> together = surface_distances(*input, source, all);
    for (VertexId v = 3; v + 200 < all.size(); v += 31) {
      const std::array<VertexId, 4> few{v, v + 200, v + 1, v};
      const std::vector<double> apart = surface_distances(*input, source, few, together[v] * 1.5);
      for (std::size_t i = 0; i < few.size(); ++i) {
        const double expected = together[few[i]];
        if (expected > together[v] * 1.5) {
          CHECK(apart[i] == not_reached);
        } else {
          CHECK(apart[i] == Approx(expected).epsilon(1e-12));
        }
      }
    }
  }
}

TEST_CASE("surface distance: the radius cuts off", "[surface_distance]") {
  const auto cube = make_input(surface_of(block({1, 1, 1}), 4));
  const VertexId source = vertex_at(*cube, {0, 0, 0});
  const VertexId far = vertex_at(*cube, {1, 1, 1});
  CHECK(distance(*cube, source, far, 2.236) == not_reached);
  CHECK(distance(*cube, source, far, 2.237) == Approx(std::sqrt(5.0)));
  CHECK(distance(*cube, source, source, 0.0) == 0.0);
  CHECK(distance(*cube, source, far, 0.0) == not_reached);
  CHECK(surface_distances(*cube, source, {}).empty());
}

TEST_CASE("surface distance: a seam is no border", "[surface_distance]") {
  const auto seamed = make_input(sphere(12, 7, true));
  const auto welded = make_input(sphere(12, 7, false));
  const auto place = [&](VertexId v) { return vertex_at(*welded, seamed->mesh.positions[v]); };
  for (const VertexId source : {1U, 13U, 20U, 46U}) {  // 1 and 13 are twins
    const std::vector<double> distances = surface_distances(*seamed, source, all_vertices(*seamed));
    for (VertexId v = 0; v < distances.size(); ++v) {
      if (seamed->twin[v] == seamed->twin[source]) CHECK(distances[v] == 0.0);
      CHECK(distances[v] == Approx(distance(*welded, place(source), place(v))).margin(1e-12));
    }
  }
}

TEST_CASE("surface distance: triangles without area, turned ones and strays do no harm",
          "[surface_distance]") {
  const Mesh plain = weld(surface_of(block({2, 1, 1}), 2));
  const auto expected = table_of(*make_input(plain));
  Mesh mesh = plain;
  // Some sides get a vertex in the middle on one side only; a triangle without area closes the gap.
  for (const std::size_t t : {0U, 3U, 11U, 30U}) {
    const auto [a, b, c] = plain.triangles[t];
    const auto middle = static_cast<VertexId>(mesh.positions.size());
    mesh.positions.push_back(plain.positions[a] * 0.5 + plain.positions[b] * 0.5);
    mesh.triangles[t] = {a, middle, c};
    mesh.triangles.push_back({middle, b, c});
    mesh.triangles.push_back({a, b, middle});
  }
  mesh.triangles.push_back({5, 6, 5});
  for (const std::size_t t : {2U, 3U, 17U}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  const auto input = make_input(mesh);
  REQUIRE(check(mesh).fit());
  for (VertexId a = 0; a < expected.size(); ++a) {
    const std::vector<double> distances = surface_distances(*input, a, all_vertices(*input));
    for (VertexId b = 0; b < expected.size(); ++b)
      CHECK(distances[b] == Approx(expected[a][b]).epsilon(1e-9));
  }
  // The vertices in the middles, from and to.
  for (auto v = static_cast<VertexId>(plain.positions.size()); v < mesh.positions.size(); ++v)
    for (VertexId a = 0; a < expected.size(); ++a)
      CHECK(distance(*input, v, a) == Approx(distance(*input, a, v)).epsilon(1e-9));

  mesh.positions.push_back({9, 9, 9});
  const auto stray = static_cast<VertexId>(mesh.positions.size() - 1);
  CHECK(distance(*make_input(mesh), 0, stray) == not_reached);
  CHECK(distance(*make_input(mesh), stray, 0) == not_reached);
  CHECK(distance(*make_input(mesh), stray, stray) == 0.0);
}

TEST_CASE("surface distance: at a border the way bends too", "[surface_distance]") {
  // The top of three cubes in an L. The corner (1, 1) is now on the border.
  std::set<Cell> corner = block({2, 1, 1});
  corner.insert({0, 1, 0});
  Mesh sheet = surface_of(corner, 2);
  std::vector<Triangle> top;
  for (const Triangle& t : sheet.triangles) {
    const auto on_top = [&](VertexId v) { return sheet.positions[v].z == 1.0; };
    if (std::all_of(t.begin(), t.end(), on_top)) top.push_back(t);
  }
  REQUIRE(top.size() == 24);
  sheet.triangles = std::move(top);
  const auto input = make_input(weld(sheet));
  CHECK(distance(*input, {2, 0.5, 1}, {0.5, 2, 1}) == Approx(2 * std::hypot(1, 0.5)).epsilon(1e-12));
  CHECK(distance(*input, {2, 0, 1}, {0.5, 1, 1}) == Approx(std::hypot(1.5, 1)).epsilon(1e-12));
}

TEST_CASE("surface distance: keeps its digits at any scale", "[surface_distance]") {
  for (const double scale : {1e-40, 1e40}) {
    Mesh mesh = bumpy(1, 4);
    const auto expected = table_of(*make_input(mesh));
    for (glm::dvec3& p : mesh.positions) p *= scale;
    const auto scaled = table_of(*make_input(mesh));
    for (std::size_t a = 0; a < expected.size(); ++a)
      for (std::size_t b = 0; b < expected.size(); ++b)
        CHECK(scaled[a][b] / scale == Approx(expected[a][b]).epsilon(1e-9));
  }
}
