#include "knit/mesh/surface_patch.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "knit/mesh/elementary.h"

namespace knit {

namespace {

// Above rounding, so that a flat vertex counts as flat; a smaller excess hides nothing that the tolerance of
// a search does not see.
constexpr double angle_tolerance = 1e-9;

VertexId place_of(const Input& input, HalfEdge corner) {
  return input.twin[input.mesh.triangles[corner / 3][corner % 3]];
}

// Visits each triangle's corner at the vertex; true if they close round it.
template <class Visit>
bool visit_corners(const Input& input, VertexId vertex, Visit visit) {
  const HalfEdge first = input.first_corner[vertex];
  if (first == no_half_edge) return false;
  visit(first);
  // Once one way round and, should that end at a border, the other way.
  for (const HalfEdge begin : {first, previous_in_triangle(first)}) {
    for (HalfEdge out = begin;;) {
      const HalfEdge in = input.across[out];
      if (in == no_half_edge) break;
      if (in / 3 == first / 3) return true;
      const bool starts_here = place_of(input, in) == vertex;
      const HalfEdge corner = starts_here ? in : next_in_triangle(in);
      visit(corner);
      out = starts_here ? previous_in_triangle(in) : corner;
    }
  }
  return false;
}

// The third corner, seen along a side from its beginning.
glm::dvec2 laid_flat(const glm::dvec3& side, double length, const glm::dvec3& to_apex) {
  if (!(length > 0.0)) return {0.0, glm::length(to_apex)};
  return {glm::dot(side, to_apex) / length, glm::length(glm::cross(side, to_apex)) / length};
}

}  // namespace

IndexMap::IndexMap() : slots_(128) {}

IndexMap::Slot& IndexMap::slot_of(std::uint32_t key) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = (key * 0x9e3779b97f4a7c15u >> 32) & mask;
  while (slots_[at].key != key && slots_[at].index != UINT32_MAX) at = (at + 1) & mask;
  return slots_[at];
}

std::uint32_t IndexMap::find_or_add(std::uint32_t key, std::uint32_t next) {
  Slot& slot = slot_of(key);
  if (slot.index != UINT32_MAX) return slot.index;
  slot = {key, next};
  if (2 * ++used_ > slots_.size()) grow();
  return next;
}

void IndexMap::grow() {
  std::vector<Slot> old(2 * slots_.size());
  old.swap(slots_);
  for (const Slot& slot : old)
    if (slot.index != UINT32_MAX) slot_of(slot.key) = slot;
}

SurfacePatch::Index SurfacePatch::vertex(VertexId id) {
  const VertexId place = input_.twin[id];
  const Index index = vertex_map_.find_or_add(place, vertex_count());
  if (index == ids_.size()) ids_.push_back(place);
  return index;
}

SurfacePatch::Index SurfacePatch::face_of(std::uint32_t triangle) {
  const Index index = face_map_.find_or_add(triangle, face_count());
  if (index < faces_.size()) return index;
  Face face;
  std::array<glm::dvec3, 3> side;
  for (std::size_t k = 0; k < 3; ++k) face.corner[k] = vertex(input_.mesh.triangles[triangle][k]);
  for (std::size_t k = 0; k < 3; ++k) {
    side[k] = position(face.corner[(k + 1) % 3]) - position(face.corner[k]);
    face.length[k] = glm::length(side[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) face.apex[k] = laid_flat(side[k], face.length[k], -side[(k + 2) % 3]);
  faces_.push_back(face);
  triangles_.push_back(triangle);
  across_.insert(across_.end(), 3, unknown);
  return index;
}

SurfacePatch::Index SurfacePatch::across(Index side) {
  if (across_[side] != unknown) return across_[side];
  const HalfEdge beyond = input_.across[3 * triangles_[side / 3] + side % 3];
  const Index other = beyond == no_half_edge ? none : 3 * face_of(beyond / 3) + beyond % 3;
  if (other != none) across_[other] = side;
  return across_[side] = other;
}

std::vector<SurfacePatch::Index> SurfacePatch::corners_at(Index vertex) {
  std::vector<Index> corners;
  visit_corners(input_, ids_[vertex],
                [&](HalfEdge corner) { corners.push_back(3 * face_of(corner / 3) + corner % 3); });
  return corners;
}

bool SurfacePatch::parts_ways(Index vertex) const {
  const glm::dvec3& centre = position(vertex);
  double turn = 0.0;
  const bool closed = visit_corners(input_, ids_[vertex], [&](HalfEdge corner) {
    const glm::dvec3 a = input_.mesh.positions[place_of(input_, next_in_triangle(corner))] - centre;
    const glm::dvec3 b = input_.mesh.positions[place_of(input_, previous_in_triangle(corner))] - centre;
    turn += angle_to(glm::dot(a, b), glm::length(glm::cross(a, b)));
  });
  return !closed || turn > 2.0 * std::numbers::pi + angle_tolerance;
}

}  // namespace knit
