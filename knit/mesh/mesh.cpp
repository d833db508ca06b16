#include "knit/mesh/mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "knit/base/bits.h"
#include "knit/mesh/edge_table.h"
#include "knit/mesh/elementary.h"

namespace knit {

namespace {

using PlaceKey = std::array<std::uint64_t, 3>;

// A position's bits, with -0 as 0. Comparing bits makes even NaNs equal to themselves, so that no input is
// slow.
PlaceKey place_key(const glm::dvec3& p) {
  return {bits_as<std::uint64_t>(p.x + 0.0), bits_as<std::uint64_t>(p.y + 0.0),
          bits_as<std::uint64_t>(p.z + 0.0)};
}

std::uint64_t mixed(std::uint64_t h) {
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  return h ^ (h >> 31);
}

std::uint64_t hash_of(const PlaceKey& key) {
  return mixed(key[0] + mixed(key[1] + mixed(key[2] + 0x9e3779b97f4a7c15u)));
}

void fill_across(Input& input, const EdgeTable& table) {
  input.across.assign(3 * input.mesh.triangles.size(), no_half_edge);
  const std::vector<EdgeUse>& uses = table.uses;
  // Uses of one edge lie side by side; those of an edge with more than two triangles are left alone.
  for (std::size_t v = 0; v < input.twin.size(); ++v) {
    for (std::uint32_t i = table.first[v], end = i; i < table.first[v + 1]; i = end) {
      while (end < table.first[v + 1] && uses[end].high == uses[i].high) ++end;
      if (end - i != 2) continue;
      input.across[uses[i].half_edge] = uses[i + 1].half_edge;
      input.across[uses[i + 1].half_edge] = uses[i].half_edge;
    }
  }
}

// Neighbours come out ascending without sorting: v first meets its lower neighbours, then its own group.
void fill_neighbours(Input& input, const EdgeTable& table) {
  const std::size_t count = input.twin.size();
  const auto for_each_edge = [&](auto&& visit) {
    for (std::size_t v = 0; v < count; ++v)
      for (std::uint32_t i = table.first[v]; i < table.first[v + 1]; ++i)
        if (i == table.first[v] || table.uses[i].high != table.uses[i - 1].high)
          visit(static_cast<VertexId>(v), table.uses[i].high);
  };
  input.first_neighbour.assign(count + 1, 0);
  for_each_edge([&](VertexId low, VertexId high) {
    ++input.first_neighbour[low + 1];
    ++input.first_neighbour[high + 1];
  });
  std::uint32_t total = 0;
  for (std::uint32_t& entry : input.first_neighbour) entry = total += entry;
  input.neighbours.resize(total);
  std::vector<std::uint32_t> next(input.first_neighbour.begin(), input.first_neighbour.end() - 1);
  for_each_edge([&](VertexId low, VertexId high) {
    input.neighbours[next[low]++] = high;
    input.neighbours[next[high]++] = low;
  });
}

void fill_rims(Input& input) {
  for (std::vector<VertexId>& loop : boundary_loops(input.mesh.triangles, input.twin)) {
    MeshRim rim;
    for (std::size_t i = 0; i < loop.size(); ++i)
      rim.length +=
          glm::distance(input.mesh.positions[loop[i]], input.mesh.positions[loop[(i + 1) % loop.size()]]);
    rim.vertices = std::move(loop);
    input.rims.push_back(std::move(rim));
  }
}

void fill_boxes(Input& input) {
  const Mesh& mesh = input.mesh;
  input.boxes.reserve(mesh.triangles.size() / Input::boxed + 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % Input::boxed == 0) {
      const glm::dvec3& first = mesh.positions[mesh.triangles[t][0]];
      input.boxes.push_back({first, first});
    }
    Input::Box& box = input.boxes.back();
    for (const VertexId v : mesh.triangles[t])
      box = {glm::min(box.low, mesh.positions[v]), glm::max(box.high, mesh.positions[v])};
  }
}

}  // namespace

glm::dvec3 Bounds::centre() const { return low * 0.5 + high * 0.5; }

double Bounds::diagonal() const { return hypotenuse(high.x - low.x, high.y - low.y, high.z - low.z); }

std::span<const VertexId> Input::neighbours_of(VertexId vertex) const {
  const VertexId v = twin[vertex];
  return std::span(neighbours).subspan(first_neighbour[v], first_neighbour[v + 1] - first_neighbour[v]);
}

bool Input::adjacent(VertexId a, VertexId b) const {
  const std::span<const VertexId> around = neighbours_of(a);
  return std::binary_search(around.begin(), around.end(), twin[b]);
}

std::vector<VertexId> find_twins(const std::vector<glm::dvec3>& positions) {
  std::vector<VertexId> twin(positions.size());
  const std::size_t mask = std::bit_ceil(2 * positions.size() + 1) - 1;
  std::vector<VertexId> slots(mask + 1, no_vertex);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const PlaceKey key = place_key(positions[v]);
    std::size_t slot = hash_of(key) & mask;
    while (slots[slot] != no_vertex && place_key(positions[slots[slot]]) != key) slot = (slot + 1) & mask;
    if (slots[slot] == no_vertex) slots[slot] = static_cast<VertexId>(v);
    twin[v] = slots[slot];
  }
  return twin;
}

Mesh weld(const Mesh& mesh) {
  Mesh welded;
  welded.name = mesh.name;
  const std::vector<VertexId> twin = find_twins(mesh.positions);
  std::vector<VertexId> moved(twin.size());
  for (std::size_t v = 0; v < twin.size(); ++v) {
    if (twin[v] == v) {
      moved[v] = static_cast<VertexId>(welded.positions.size());
      welded.positions.push_back(mesh.positions[v]);
    } else {
      moved[v] = moved[twin[v]];
    }
  }
  for (const Triangle& t : mesh.triangles) {
    // An index out of range stays out of range, for the check to find.
    const bool in_range = std::max({t[0], t[1], t[2]}) < moved.size();
    const Triangle corners = in_range ? Triangle{moved[t[0]], moved[t[1]], moved[t[2]]} : t;
    if (!in_range || !collapsed(corners)) welded.triangles.push_back(corners);
  }
  std::vector<std::array<VertexId, 2>> edges;
  edges.reserve(mesh.edges.size());
  for (const auto& [a, b] : mesh.edges)
    if (a < moved.size() && b < moved.size()) edges.push_back({moved[a], moved[b]});
  welded.edges = unique_edges(edges, welded.positions.size());
  return welded;
}

Bounds bounds_of(const std::vector<glm::dvec3>& positions) {
  if (positions.empty()) return {};
  Bounds bounds{positions.front(), positions.front(), 0.0};
  for (const glm::dvec3& p : positions) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      bounds.low[axis] = std::min(bounds.low[axis], p[axis]);
      bounds.high[axis] = std::max(bounds.high[axis], p[axis]);
    }
  }
  const glm::dvec3 centre = bounds.centre();
  for (const glm::dvec3& p : positions) {
    bounds.radius = std::max(bounds.radius, hypotenuse(p.x - centre.x, p.y - centre.y, p.z - centre.z));
  }
  return bounds;
}

std::shared_ptr<const Input> make_input(Mesh mesh) {
  auto input = std::make_shared<Input>();
  input->mesh = std::move(mesh);
  const std::vector<glm::dvec3>& positions = input->mesh.positions;
  input->twin = find_twins(positions);
  input->referenced.assign(positions.size(), 0);
  input->first_corner.assign(positions.size(), no_half_edge);
  std::vector<std::uint8_t> used_place(positions.size(), 0);
  HalfEdge corner = 0;
  for (const Triangle& triangle : input->mesh.triangles) {
    const bool has_sides = !collapsed(twins_of(triangle, input->twin));
    for (const VertexId v : triangle) {
      if (has_sides) {
        input->referenced[v] = 1;
        used_place[input->twin[v]] = 1;
        input->first_corner[input->twin[v]] = corner;
      }
      ++corner;
    }
  }
  // A vertex that no triangle uses must not move the frame or the centroid.
  std::vector<glm::dvec3> places;
  places.reserve(positions.size());
  glm::dvec3 sum(0.0);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!used_place[v]) continue;
    places.push_back(positions[v]);
    sum += positions[v];
  }
  input->bounds = bounds_of(places);
  if (!places.empty()) input->centroid = sum / static_cast<double>(places.size());
  const EdgeTable table = make_edge_table(input->mesh.triangles, input->twin);
  fill_neighbours(*input, table);
  fill_across(*input, table);
  fill_rims(*input);
  fill_boxes(*input);
  return input;
}

}  // namespace knit
