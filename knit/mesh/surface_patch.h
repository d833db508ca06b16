// The part of a mesh that a search touches, in small indices, each triangle laid flat when it is first met.
//
// Costs what is touched, however large the mesh. Vertices at one place are one; triangles with two corners at
// one place are passed over.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

// From keys to small indices, by open addressing.
class IndexMap {
 public:
  IndexMap();
  // The index of the key, which is `next` for a key not seen before.
  std::uint32_t find_or_add(std::uint32_t key, std::uint32_t next);

 private:
  struct Slot {
    std::uint32_t key = UINT32_MAX;
    std::uint32_t index = UINT32_MAX;
  };
  Slot& slot_of(std::uint32_t key);
  void grow();
  std::vector<Slot> slots_;
  std::uint32_t used_ = 0;
};

class SurfacePatch {
 public:
  using Index = std::uint32_t;  // of a vertex or a face of the patch; of a side or corner: 3 face + k
  static constexpr Index none = UINT32_MAX;

  // Side k runs from corner k to corner k + 1. With it on the x axis, from the origin onwards, the third
  // corner is at apex[k], y >= 0 (0 in a triangle without area).
  struct Face {
    std::array<Index, 3> corner{};
    std::array<double, 3> length{};
    std::array<glm::dvec2, 3> apex{};
  };

  explicit SurfacePatch(const Input& input) : input_(input) {}

  Index vertex(VertexId id);  // new if not met before
  [[nodiscard]] Index vertex_count() const { return static_cast<Index>(ids_.size()); }
  [[nodiscard]] Index face_count() const { return static_cast<Index>(faces_.size()); }
  [[nodiscard]] VertexId id(Index vertex) const { return ids_[vertex]; }
  [[nodiscard]] const glm::dvec3& position(Index vertex) const { return input_.mesh.positions[ids_[vertex]]; }
  [[nodiscard]] const Face& face(Index face) const { return faces_[face]; }

  // The same edge as a side of the face beyond, which is new if not met before; none at a border.
  Index across(Index side);
  // The corners at a vertex, one a face, in no order.
  std::vector<Index> corners_at(Index vertex);
  // Whether straight ways part at the vertex, so that a shortest way may bend there: the angles of its
  // triangles make more than a full turn, or it lies on a border.
  [[nodiscard]] bool parts_ways(Index vertex) const;

 private:
  Index face_of(std::uint32_t triangle);

  const Input& input_;
  IndexMap vertex_map_, face_map_;
  std::vector<VertexId> ids_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> triangles_;  // per face
  std::vector<Index> across_;             // per side; `unknown` until asked for
  static constexpr Index unknown = UINT32_MAX - 1;
};

}  // namespace knit
