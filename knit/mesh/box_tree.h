// The nearest place of a mesh to a point, by the boxes that the mesh has around its triangles [Input::boxes]: for points that
// are few beside the triangles, where a tree of all of them does not pay.
//
// Also of triangles that move from call to call and lie in order, as those of a fabric do: then boxes are made around each eight.
//
// A box around each eight, and again, until there is one. What TriangleTree finds, of equally near triangles the lower.
// O(boxes) to make; a search looks at the triangles of the boxes that are as near as the place: some hundreds where the file
// lists triangles side by side, all where it lists them in no order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/mesh/triangle_tree.h"

namespace knit {

class BoxTree {
 public:
  // Both refer to what they are given.
  explicit BoxTree(const Input& input);
  BoxTree(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles);

  // Requires a triangle. `guess`: one of them; the nearer it is, the less is looked at.
  [[nodiscard]] SurfacePlace nearest(const glm::dvec3& point, std::uint32_t guess = 0);
  // Triangles looked at so far.
  [[nodiscard]] std::size_t tried() const { return tried_; }

 private:
  struct Search;
  void look_below(std::size_t level, std::size_t box, Search& search);
  void look_at_triangles(std::size_t box, Search& search);
  void look_at(std::uint32_t triangle, Search& search);
  void put_boxes_around();

  std::span<const glm::dvec3> positions_;
  std::span<const Triangle> triangles_;
  std::size_t boxed_;                            // triangles in one box
  std::vector<std::vector<Input::Box>> levels_;  // from the boxes of triangles to the one around all
  std::size_t tried_ = 0;
};

}  // namespace knit
