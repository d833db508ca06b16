#include "knit/timing/intrinsic.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "knit/import/check_topology.h"
#include "knit/mesh/edge_table.h"
#include "knit/mesh/elementary.h"
#include "knit/model/bug.h"

namespace knit {

namespace {

// Edges whose weight is this little below zero stay: four corners on one circle keep the mesh's diagonal,
// whatever rounding says.
constexpr double delaunay_tolerance = 1e-8;
// Flips end by themselves, after 0.3 an edge on rough meshes, 1 to 7 on stretched ones, 30 on a ring of three
// long prisms of 400 sides. This bounds the time; edges that are then not yet Delaunay stay.
constexpr std::size_t most_flips_per_edge = 100;

SideLengths descending(const SideLengths& lengths) {
  const auto [low, high] = std::minmax(lengths[0], lengths[1]);
  const double c = lengths[2];
  return {std::max(high, c), std::max(low, std::min(high, c)), std::min(low, c)};
}

// (b^2 + c^2 - a^2) / 2, without cancellation where two sides are nearly the same.
double cosine_product(double a, double b, double c) {
  const auto [low, high] = std::minmax(b, c);
  return 0.5 * ((high - a) * (high + a) + low * low);
}

// Triangles glued along their edges; what lies across is known by index, so any gluing will do.
struct Net {
  std::vector<Triangle> triangles;
  std::vector<SideLengths> lengths;
  std::vector<HalfEdge> across;  // no_half_edge where the surface is open

  [[nodiscard]] VertexId origin(HalfEdge h) const { return triangles[h / 3][h % 3]; }
  [[nodiscard]] VertexId end(HalfEdge h) const { return origin(next_in_triangle(h)); }
  [[nodiscard]] double length(HalfEdge h) const { return lengths[h / 3][h % 3]; }
  [[nodiscard]] double cotangent_opposite(HalfEdge h) const {
    const double product =
        cosine_product(length(h), length(next_in_triangle(h)), length(previous_in_triangle(h)));
    return product / (2.0 * area_of(lengths[h / 3]));
  }
};

bool breaks_delaunay(double one_cotangent, double other_cotangent) {
  const double scale = std::max({1.0, std::abs(one_cotangent), std::abs(other_cotangent)});
  return one_cotangent + other_cotangent < -delaunay_tolerance * scale;
}

// --- from the mesh

// Calls visit(low end's first use, second use) for each edge, of an open one its only use twice; false as soon as a visit
// says so.
template <class Visit>
bool for_each_edge(const EdgeTable& table, Visit visit) {
  for (std::size_t v = 0; v + 1 < table.first.size(); ++v) {
    const std::uint32_t end = table.first[v + 1];
    for (std::uint32_t i = table.first[v], next = i; i < end; i = next) {
      while (next < end && table.uses[next].high == table.uses[i].high) ++next;
      if (next - i > 2) throw Bug("an edge of the mesh has more than two triangles");
      if (!visit(table.uses[i].half_edge, table.uses[next - 1].half_edge)) return false;
    }
  }
  return true;
}

std::vector<Triangle> merged_triangles(const Input& input) {
  std::vector<Triangle> triangles;
  triangles.reserve(input.mesh.triangles.size());
  for (const Triangle& triangle : input.mesh.triangles) {
    const Triangle corners = twins_of(triangle, input.twin);
    if (!collapsed(corners)) triangles.push_back(corners);
  }
  return triangles;
}

// Turns the fewer triangles, so that neighbours agree.
EdgeTable orient(std::vector<Triangle>& triangles, const std::vector<VertexId>& twin) {
  EdgeTable table = make_edge_table(triangles, twin);
  const auto origin = [&](HalfEdge h) { return triangles[h / 3][h % 3]; };
  if (for_each_edge(table, [&](HalfEdge a, HalfEdge b) { return a == b || origin(a) != origin(b); }))
    return table;
  for (const std::size_t t : study_topology(triangles, twin).minority)
    std::swap(triangles[t][1], triangles[t][2]);
  return make_edge_table(triangles, twin);
}

double mean_length(const std::vector<SideLengths>& lengths) {
  double sum = 0.0;
  for (const SideLengths& sides : lengths) sum += sides[0] + sides[1] + sides[2];
  return lengths.empty() ? 0.0 : sum / (3.0 * static_cast<double>(lengths.size()));
}

Net make_net(const Input& input, const Heard& heard) {
  Net net;
  net.triangles = merged_triangles(input);
  hear(heard, 0.1);
  const EdgeTable table = orient(net.triangles, input.twin);
  net.lengths.resize(net.triangles.size());
  net.across.resize(3 * net.triangles.size());
  std::size_t edge = 0;
  const Heard lengths = part_of(heard, 0.5, 1.0);
  for_each_edge(table, [&](HalfEdge a, HalfEdge b) {
    hear_at(lengths, edge++, net.across.size() / 2);
    net.across[a] = a != b ? b : no_half_edge;
    net.across[b] = a != b ? a : no_half_edge;
    const double length =
        glm::distance(input.mesh.positions[net.origin(a)], input.mesh.positions[net.end(a)]);
    net.lengths[a / 3][a % 3] = net.lengths[b / 3][b % 3] = length;
    return true;
  });
  return net;
}

// --- flips

// The triangles t and s on both sides of an edge as they are to be: t' = (c, a, d), s' = (d, b, c), where the
// edge went from a to b, c is t's other corner and d is that of s. In both, the new edge is 2.
struct Flip {
  SideLengths here, there;
};

std::optional<Flip> plan_flip(const Net& net, HalfEdge h) {
  const HalfEdge g = net.across[h];
  if (g == no_half_edge) return std::nullopt;
  // An edge that folds a triangle onto itself closes a cone; angles against it never reach a half turn.
  if (h / 3 == g / 3) return std::nullopt;
  if (!breaks_delaunay(net.cotangent_opposite(h), net.cotangent_opposite(g))) return std::nullopt;
  const Apex c = lay_out(net.lengths[h / 3], h % 3);
  const Apex d = lay_out(net.lengths[g / 3], g % 3);  // from b, and below
  const double length = hypotenuse(c.x - (net.length(h) - d.x), c.y + d.y);
  const Flip flip{{net.length(previous_in_triangle(h)), net.length(next_in_triangle(g)), length},
                  {net.length(previous_in_triangle(g)), net.length(next_in_triangle(h)), length}};
  // Only rounding can spoil a flip; then the edge stays.
  if (!(length > 0.0) || breaks_delaunay(cotangents_of(flip.here)[1], cotangents_of(flip.there)[1]))
    return std::nullopt;
  return flip;
}

// The four edges around come back, under their new names.
std::array<HalfEdge, 4> apply_flip(Net& net, HalfEdge h, const Flip& flip) {
  const HalfEdge g = net.across[h];
  const HalfEdge t = h - h % 3;
  const HalfEdge s = g - g % 3;
  const std::array<HalfEdge, 4> before{previous_in_triangle(h), next_in_triangle(g), previous_in_triangle(g),
                                       next_in_triangle(h)};
  const std::array<HalfEdge, 4> after{t, t + 1, s, s + 1};
  const VertexId a = net.origin(h);
  const VertexId b = net.origin(g);
  const VertexId c = net.origin(before[0]);
  const VertexId d = net.origin(before[2]);
  // Two of the four may be glued to each other, so all are looked up before any is changed.
  std::array<HalfEdge, 4> others{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto inside = std::find(before.begin(), before.end(), net.across[before[i]]);
    others[i] = inside == before.end() ? net.across[before[i]]
                                       : after[static_cast<std::size_t>(inside - before.begin())];
  }
  for (std::size_t i = 0; i < 4; ++i) {
    net.across[after[i]] = others[i];
    if (others[i] != no_half_edge) net.across[others[i]] = after[i];
  }
  net.across[t + 2] = s + 2;
  net.across[s + 2] = t + 2;
  net.triangles[t / 3] = {c, a, d};
  net.triangles[s / 3] = {d, b, c};
  net.lengths[t / 3] = flip.here;
  net.lengths[s / 3] = flip.there;
  return after;
}

// Whatever a flip could have spoiled is looked at again, so all edges are Delaunay in the end.
void flip_to_delaunay(Net& net, const Heard& heard) {
  std::size_t flips_left = most_flips_per_edge * net.across.size() / 2;
  std::vector<HalfEdge> doubtful;
  std::size_t looked_at = 0;
  for (HalfEdge first = 0; first < net.across.size(); ++first) {
    if (first > net.across[first]) continue;
    doubtful.push_back(first);
    while (!doubtful.empty()) {
      if (++looked_at % 8192 == 0)
        hear(heard, static_cast<double>(first) / static_cast<double>(net.across.size()));
      const HalfEdge h = doubtful.back();
      doubtful.pop_back();
      const std::optional<Flip> flip = plan_flip(net, h);
      if (!flip) continue;
      if (flips_left-- == 0) return;
      for (const HalfEdge around : apply_flip(net, h, *flip)) doubtful.push_back(around);
    }
  }
}

}  // namespace

double area_of(const SideLengths& lengths) {
  const auto [a, b, c] = descending(lengths);
  // Kahan's form of Heron's: right for needles too, with these parentheses.
  const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return std::max(0.25 * std::sqrt(std::max(product, 0.0)), 1e-14 * a * a);
}

std::array<double, 3> cotangents_of(const SideLengths& lengths) {
  const double twice_area = 2.0 * area_of(lengths);
  std::array<double, 3> cotangents{};
  for (std::size_t k = 0; k < 3; ++k)
    cotangents[k] = cosine_product(lengths[(k + 1) % 3], lengths[k], lengths[(k + 2) % 3]) / twice_area;
  return cotangents;
}

Apex lay_out(const SideLengths& lengths, std::size_t base) {
  const double along = lengths[base];
  const double to_apex = lengths[(base + 2) % 3];
  return {cosine_product(lengths[(base + 1) % 3], to_apex, along) / along, 2.0 * area_of(lengths) / along};
}

IntrinsicMesh make_intrinsic(const Input& input, const Heard& heard) {
  Net net = make_net(input, part_of(heard, 0.0, 0.4));
  flip_to_delaunay(net, part_of(heard, 0.4, 1.0));
  const double mean_edge = mean_length(net.lengths);
  return {std::move(net.triangles), std::move(net.lengths), mean_edge};
}

Spokes spokes_of(const IntrinsicMesh& intrinsic, std::size_t vertex_count, const Heard& heard) {
  Spokes all{std::vector<std::uint32_t>(vertex_count + 1, 0),
             std::vector<Spoke>(3 * intrinsic.triangles.size())};
  for (const Triangle& triangle : intrinsic.triangles)
    for (const VertexId v : triangle) ++all.first[v + 1];
  for (std::size_t v = 0; v < vertex_count; ++v) all.first[v + 1] += all.first[v];
  std::vector<std::uint32_t> next(all.first.begin(), all.first.end() - 1);
  // Two triangles pass an edge in opposite directions, so each of its ends gets it once.
  for (std::size_t t = 0; t < intrinsic.triangles.size(); ++t) {
    hear_at(heard, t, intrinsic.triangles.size());
    for (std::size_t k = 0; k < 3; ++k)
      all.spokes[next[intrinsic.triangles[t][k]]++] = {intrinsic.triangles[t][(k + 1) % 3],
                                                       intrinsic.lengths[t][k]};
  }
  return all;
}

double reach_along_edges(const Spokes& spokes, VertexId start, const Heard& heard) {
  std::vector<double> distance(spokes.first.size() - 1, std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance[start] = 0.0;
  queue.emplace(0.0, start);
  double reach = 0.0;
  std::size_t taken = 0;
  while (!queue.empty()) {
    if (++taken % 8192 == 0) hear(heard, 0.0);
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
