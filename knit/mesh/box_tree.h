// The nearest place of a mesh to a point, by the boxes that the mesh has around its triangles [Input::boxes]: for points that
// are few beside the triangles, where a tree of all of them does not pay.
//
// A box around each eight, and again, until there is one. What TriangleTree finds, of equally near triangles the lower.
// O(boxes) to make; a search looks at the triangles of the boxes that are as near as the place: some hundreds where the file
// lists triangles side by side, all where it lists them in no order.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/mesh/triangle_tree.h"

namespace knit {

class BoxTree {
 public:
  explicit BoxTree(const Input& input);  // refers to it

  // Requires a triangle.
  [[nodiscard]] SurfacePlace nearest(const glm::dvec3& point);
  // Triangles looked at so far.
  [[nodiscard]] std::size_t tried() const { return tried_; }

 private:
  struct Search;
  void look_below(std::size_t level, std::size_t box, Search& search);
  void look_at_triangles(std::size_t box, Search& search);

  const Input* input_;
  std::vector<std::vector<Input::Box>> levels_;  // from the mesh's boxes to the one around all
  std::size_t tried_ = 0;
};

}  // namespace knit
