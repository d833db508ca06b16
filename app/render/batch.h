// Many shared shapes of one kind in one buffer, in the order in which a scene lists them: a finished run has
// hundreds of rows, and a draw call for each would cost more than drawing them.
//
// A shape is uploaded when it is first shown. What a list has in common with the one before, from its beginning,
// stays where it is; so does what a shorter list leaves out, for as long as somebody holds it. The buffer only
// grows, until nothing is shown any more.
#pragma once

#include <array>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "app/render/gl_handle.h"
#include "app/scene/scene.h"

namespace app {

// What can be seen: planes that look inward, in world units.
class Frustum {
 public:
  explicit Frustum(const glm::mat4& to_clip);
  // False only where the sphere lies wholly outside.
  [[nodiscard]] bool touches(const glm::vec3& centre, float radius) const;

 private:
  std::array<glm::vec4, 6> planes_;
};

struct Extent {
  glm::vec3 low{0.0f}, high{0.0f};
  bool empty = true;
  void add(const glm::vec3& place);
  void add(const Extent& other);
  [[nodiscard]] float diagonal() const;
  [[nodiscard]] glm::vec3 centre() const { return 0.5f * (low + high); }
};

// Shape: std::vector<Line>, std::vector<Point> or FaceShape.
template <class Shape>
class Batch {
 public:
  using Pointer = std::shared_ptr<const Shape>;

  Batch();
  void show(std::span<const Pointer> shapes);
  // This frame's own, in place of all that was there.
  void show_once(const Shape& shape);
  // Gives how many lines, points or faces were drawn. Leaves out what lies outside.
  std::size_t draw(const Frustum& frustum) const;

  [[nodiscard]] bool empty() const { return shown_ == 0; }
  [[nodiscard]] std::size_t uploads() const { return uploads_; }  // shared shapes, ever
  [[nodiscard]] std::size_t kept() const;                         // shapes still held by somebody
  // Of what is shown.
  [[nodiscard]] Extent extent() const;
  [[nodiscard]] float longest_side() const;  // of faces; else 0

 private:
  // So many items that lie near one another are drawn or left out together.
  struct Piece {
    std::size_t first = 0, count = 0;  // items
    glm::vec3 centre{0.0f};
    float radius = 0.0f;
  };
  struct Entry {
    std::weak_ptr<const Shape> alive;
    const Shape* shape = nullptr;
    std::size_t items_end = 0, pieces_end = 0;
    Extent extent;
    float longest_side = 0.0f;
  };
  void append(const Shape& shape, const Pointer& held);
  void truncate(std::size_t entries);
  void store(std::size_t first_entry);
  void reserve(std::size_t items);

  GlVertexArray array_;
  GlBuffer buffer_;
  GlBuffer indices_;          // of faces, whose triangles share corners
  std::size_t capacity_ = 0;  // items
  std::vector<Entry> entries_;
  std::vector<Piece> pieces_;
  std::size_t shown_ = 0;  // entries
  std::size_t uploads_ = 0;
};

}  // namespace app
