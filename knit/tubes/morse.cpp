#include "knit/tubes/morse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "knit/import/check_topology.h"
#include "knit/mesh/edge_table.h"
#include "knit/mesh/flat_flips.h"
#include "knit/model/bug.h"
#include "knit/model/heard_sort.h"

namespace knit {

namespace {

constexpr std::uint32_t no_list = UINT32_MAX;

// --- from the mesh

bool all_the_same_way(const Input& input, const Heard& heard) {
  const auto origin = [&](HalfEdge h) { return input.twin[input.mesh.triangles[h / 3][h % 3]]; };
  for (HalfEdge h = 0; h < input.across.size(); ++h) {
    hear_at(heard, h, input.across.size());
    if (input.across[h] != no_half_edge && origin(h) == origin(input.across[h])) return false;
  }
  return true;
}

// The triangles by lowest-index twins, and what lies across, which the mesh knows where all of them are taken as they are.
void take_triangles(const Input& input, MorseSurface& surface, const Heard& heard) {
  std::vector<Triangle>& triangles = surface.triangles;
  triangles.reserve(input.mesh.triangles.size());
  for (const Triangle& triangle : input.mesh.triangles) {
    const Triangle corners = twins_of(triangle, input.twin);
    if (!collapsed(corners)) triangles.push_back(corners);
  }
  if (!all_the_same_way(input, heard)) {
    for (const std::size_t t : study_topology(triangles, input.twin).minority)
      std::swap(triangles[t][1], triangles[t][2]);
    return;
  }
  const bool all = triangles.size() == input.mesh.triangles.size();
  const bool closed = std::find(input.across.begin(), input.across.end(), no_half_edge) == input.across.end();
  if (all && closed) surface.across = input.across;
}

// The sides of a triangle that is turned, in their new order: 2, 1, 0.
HalfEdge turned_side(HalfEdge h) { return h - h % 3 + (2 - h % 3); }

// A cone on each open edge, whose apex stands amid it and comes before or after all of its corners.
void close_rims(const Input& input, MorseSurface& surface, const std::vector<VertexId>& number,
                std::span<const double> field) {
  if (input.rims.empty()) return;
  std::vector<VertexId> itself(surface.positions.size());
  std::iota(itself.begin(), itself.end(), VertexId{0});
  const auto [least, greatest] = std::minmax_element(surface.values.begin(), surface.values.end());
  const double low = *least, high = *greatest;
  std::vector<std::int32_t> rim_of(itself.size(), -1);
  for (std::size_t r = 0; r < input.rims.size(); ++r) {
    glm::dvec3 middle(0.0);
    const std::vector<VertexId>& around = input.rims[r].vertices;
    const double value = field[around.front()];
    if (value != low && value != high) throw Bug("an open edge lies neither at the start nor at the end");
    for (const VertexId v : around) {
      if (field[v] != value) throw Bug("an open edge is no level of the field");
      rim_of[number[v]] = static_cast<std::int32_t>(r);
      middle += input.mesh.positions[v] / static_cast<double>(around.size());
    }
    surface.caps.push_back({static_cast<VertexId>(surface.positions.size()), static_cast<std::int32_t>(r)});
    surface.positions.push_back(middle);
    surface.values.push_back(value);
    surface.origin.push_back(around.front());
  }
  const EdgeTable table = make_edge_table(surface.triangles, itself);
  for (std::size_t v = 0; v < itself.size(); ++v) {
    for (std::uint32_t i = table.first[v], end = i; i < table.first[v + 1]; i = end) {
      while (end < table.first[v + 1] && table.uses[end].high == table.uses[i].high) ++end;
      if (end - i != 1) continue;
      const HalfEdge h = table.uses[i].half_edge;
      const VertexId from = surface.triangles[h / 3][h % 3];
      const VertexId to = surface.triangles[h / 3][next_in_triangle(h) % 3];
      surface.triangles.push_back({to, from, surface.caps[static_cast<std::size_t>(rim_of[v])].apex});
    }
  }
  surface.across.clear();
}

void turn_outwards(MorseSurface& surface, const Bounds& bounds) {
  Mesh mesh;
  mesh.positions.swap(surface.positions);
  mesh.triangles.swap(surface.triangles);
  const bool inwards = signed_volume(mesh, bounds) < 0.0;
  mesh.positions.swap(surface.positions);
  mesh.triangles.swap(surface.triangles);
  if (!inwards) return;
  for (Triangle& t : surface.triangles) std::swap(t[1], t[2]);
  std::vector<HalfEdge> across(surface.across.size());
  for (HalfEdge h = 0; h < across.size(); ++h) across[turned_side(h)] = turned_side(surface.across[h]);
  surface.across = std::move(across);
}

// --- the order

// The vertices by (value, index), but for the apex of a cap that closes the surface below, which comes first of its value.
std::vector<std::uint32_t> by_value(const MorseSurface& surface, const Heard& heard) {
  const std::vector<double>& values = surface.values;
  struct Ranked {
    double value;
    std::uint32_t vertex;
  };
  std::vector<Ranked> ranked;
  ranked.reserve(values.size());
  for (std::uint32_t v = 0; v < values.size(); ++v) {
    if (!std::isfinite(values[v])) throw Bug("a field has a value that is no number");
    ranked.push_back({values[v], v});
  }
  const auto below = [](const Ranked& a, const Ranked& b) {
    return a.value != b.value ? a.value < b.value : a.vertex < b.vertex;
  };
  sort_heard(ranked, below, heard);
  std::vector<std::uint32_t> order;
  order.reserve(values.size());
  for (const Ranked& each : ranked) order.push_back(each.vertex);
  for (const RimCap& cap : surface.caps) {
    if (values[cap.apex] != ranked.front().value) continue;
    const auto at = std::find(order.begin(), order.end(), cap.apex);
    std::rotate(order.begin(), at, at + 1);
  }
  return order;
}

void number_ranks(MorseSurface& surface) {
  surface.rank.resize(surface.by_rank.size());
  for (std::uint32_t r = 0; r < surface.by_rank.size(); ++r) surface.rank[surface.by_rank[r]] = r;
}

// --- unfolding

// A corner of the link, and the triangle from it to the next one.
struct LinkCorner {
  VertexId vertex;
  VertexId next;
  std::uint32_t triangle;
};

class MultiSaddles {
 public:
  // Those of a surface whose ranks are there.
  explicit MultiSaddles(MorseSurface& surface) : surface_(surface) {
    keys_.reserve(surface.rank.size());
    for (const std::uint32_t rank : surface.rank) keys_.push_back(std::uint64_t{rank} << 32U);
    find();
  }

  void unfold() {
    for (std::size_t i = 0; i < multi_.size(); ++i) {
      VertexId vertex = multi_[i];
      while (split_off(vertex, around_[i])) vertex = static_cast<VertexId>(surface_.positions.size() - 1);
    }
    if (surface_.unfolded == 0) return;
    surface_.across.clear();
    surface_.by_rank.resize(keys_.size());
    std::iota(surface_.by_rank.begin(), surface_.by_rank.end(), 0U);
    std::sort(surface_.by_rank.begin(), surface_.by_rank.end(),
              [&](std::uint32_t a, std::uint32_t b) { return keys_[a] < keys_[b]; });
    number_ranks(surface_);
  }

 private:
  void find() {
    std::vector<std::uint32_t> middles(surface_.rank.size(), 0);
    for (const Triangle& t : surface_.triangles) {
      const auto rank = [&](std::size_t k) { return surface_.rank[t[k]]; };
      const bool a_below_b = rank(0) < rank(1);
      const bool a_below_c = rank(0) < rank(2);
      const bool b_below_c = rank(1) < rank(2);
      ++middles[t[a_below_b != a_below_c ? 0 : a_below_b == b_below_c ? 1 : 2]];
    }
    list_.assign(middles.size(), no_list);
    for (VertexId v = 0; v < middles.size(); ++v) {
      if (middles[v] <= 4) continue;
      list_[v] = static_cast<std::uint32_t>(multi_.size());
      multi_.push_back(v);
    }
    around_.resize(multi_.size());
    if (multi_.empty()) return;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      for (const VertexId v : surface_.triangles[t])
        if (list_[v] != no_list) around_[list_[v]].push_back(t);
  }

  // Counter-clockwise, from the corner after the vertex in the first of its triangles on.
  [[nodiscard]] std::vector<LinkCorner> link_of(VertexId vertex,
                                                const std::vector<std::uint32_t>& triangles) const {
    std::vector<LinkCorner> corners;
    corners.reserve(triangles.size());
    for (const std::uint32_t t : triangles) {
      const Triangle& corner = surface_.triangles[t];
      const std::size_t k = corner[0] == vertex ? 0 : corner[1] == vertex ? 1 : 2;
      corners.push_back({corner[(k + 1) % 3], corner[(k + 2) % 3], t});
    }
    std::vector<LinkCorner> link{corners.front()};
    std::sort(corners.begin(), corners.end(),
              [](const LinkCorner& a, const LinkCorner& b) { return a.vertex < b.vertex; });
    while (link.back().next != link.front().vertex) {
      const auto next = std::lower_bound(corners.begin(), corners.end(), link.back().next,
                                         [](const LinkCorner& a, VertexId v) { return a.vertex < v; });
      if (next == corners.end() || next->vertex != link.back().next || link.size() >= corners.size())
        throw Bug("the triangles at a vertex make no fan");
      link.push_back(*next);
    }
    return link;
  }

  // The middle of each run of corners above.
  [[nodiscard]] std::vector<std::size_t> upper_runs(VertexId vertex,
                                                    const std::vector<LinkCorner>& link) const {
    const auto above = [&](std::size_t i) { return keys_[link[i % link.size()].vertex] > keys_[vertex]; };
    std::vector<std::size_t> middles;
    for (std::size_t i = 0; i < link.size(); ++i) {
      if (!above(i) || above(i + link.size() - 1)) continue;
      std::size_t last = i;
      while (above(last + 1)) ++last;
      middles.push_back((i + last) / 2 % link.size());
    }
    return middles;
  }

  // Leaves the vertex two upper runs and gives the rest to a new one, whose triangles are then in the list; false where
  // there is no more to do.
  bool split_off(VertexId vertex, std::vector<std::uint32_t>& triangles) {
    const std::vector<LinkCorner> link = link_of(vertex, triangles);
    const std::vector<std::size_t> runs = upper_runs(vertex, link);
    if (runs.size() <= 2) return false;
    const std::size_t from = runs[0];
    const std::size_t to = runs[2];
    const VertexId added = add_after(vertex);
    triangles.clear();
    for (std::size_t i = to; i % link.size() != from; ++i) {
      const LinkCorner& corner = link[i % link.size()];
      surface_.triangles[corner.triangle] = {added, corner.vertex, corner.next};
      triangles.push_back(corner.triangle);
    }
    std::sort(triangles.begin(), triangles.end());
    add_triangle({vertex, added, link[from].vertex}, triangles);
    add_triangle({added, vertex, link[to].vertex}, triangles);
    return true;
  }

  VertexId add_after(VertexId vertex) {
    ++surface_.unfolded;
    surface_.positions.push_back(surface_.positions[vertex]);
    surface_.values.push_back(surface_.values[vertex]);
    surface_.origin.push_back(surface_.origin[vertex]);
    keys_.push_back(keys_[vertex] + 1);
    list_.push_back(no_list);
    return static_cast<VertexId>(surface_.positions.size() - 1);
  }

  // Its last corner may be a multi-saddle, too.
  void add_triangle(const Triangle& triangle, std::vector<std::uint32_t>& triangles) {
    const auto number = static_cast<std::uint32_t>(surface_.triangles.size());
    surface_.triangles.push_back(triangle);
    triangles.push_back(number);
    if (list_[triangle[2]] != no_list) around_[list_[triangle[2]]].push_back(number);
  }

  MorseSurface& surface_;
  std::vector<std::uint64_t>
      keys_;  // rank among the vertices that were there, and how many were split off before
  std::vector<VertexId> multi_;
  std::vector<std::uint32_t> list_;                 // per vertex: its place in `multi_`
  std::vector<std::vector<std::uint32_t>> around_;  // the triangles of each of `multi_`, rising
};

}  // namespace

MorseSurface make_morse(const Input& input, std::span<const double> field, const Heard& heard) {
  if (field.size() != input.twin.size()) throw Bug("a field has not one value a vertex");
  MorseSurface surface;
  take_triangles(input, surface, part_of(heard, 0.0, 0.2));
  hear(heard, 0.2);
  if (flip_flat_edges(surface.triangles, input.mesh.positions, surface.across) > 0) surface.across.clear();
  std::vector<std::uint8_t> used(input.twin.size(), 0);
  for (const Triangle& t : surface.triangles)
    for (const VertexId v : t) used[v] = 1;
  std::vector<VertexId> number(input.twin.size(), no_vertex);
  const auto places = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
  surface.positions.reserve(places);
  surface.values.reserve(places);
  surface.origin.reserve(places);
  for (VertexId v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    number[v] = static_cast<VertexId>(surface.origin.size());
    surface.positions.push_back(input.mesh.positions[v]);
    surface.values.push_back(field[v]);
    surface.origin.push_back(v);
  }
  hear(heard, 0.3);
  for (Triangle& t : surface.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
  close_rims(input, surface, number, field);
  hear(heard, 0.35);
  turn_outwards(surface, input.bounds);
  return order_and_unfold(std::move(surface), part_of(heard, 0.4, 1.0));
}

MorseSurface order_and_unfold(MorseSurface surface, const Heard& heard) {
  if (surface.origin.size() != surface.positions.size()) {
    surface.origin.resize(surface.positions.size());
    std::iota(surface.origin.begin(), surface.origin.end(), VertexId{0});
  }
  surface.unfolded = 0;
  hear(heard, 0.0);
  surface.by_rank = by_value(surface, part_of(heard, 0.0, 0.7));
  hear(heard, 0.7);
  number_ranks(surface);
  MultiSaddles(surface).unfold();
  return surface;
}

}  // namespace knit
