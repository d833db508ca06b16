#include "app/render/shape_cache.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <type_traits>

namespace app {

namespace {

// OpenGL takes offsets into buffers as pointers. NOLINTNEXTLINE(performance-no-int-to-ptr)
const void* at_offset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

template <class Item>
void fill(GLenum target, const GlBuffer& buffer, std::span<const Item> items, GLenum usage) {
  glBindBuffer(target, buffer.id());
  glBufferData(target, static_cast<GLsizeiptr>(items.size_bytes()), items.empty() ? nullptr : items.data(),
               usage);
}

void floats(GLuint index, GLint size, std::size_t stride, std::size_t offset, GLuint divisor = 0) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride), at_offset(offset));
  glVertexAttribDivisor(index, divisor);
}

void colour(GLuint index, std::size_t stride, std::size_t offset, GLuint divisor = 0) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, 4, GL_UNSIGNED_BYTE, GL_TRUE, static_cast<GLsizei>(stride), at_offset(offset));
  glVertexAttribDivisor(index, divisor);
}

struct Box {
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};
  void add(const glm::vec3& place) {
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  float diagonal() const { return low.x > high.x ? 0.0f : glm::distance(low, high); }
  glm::vec3 centre() const { return low.x > high.x ? glm::vec3(0.0f) : 0.5f * (low + high); }
};

float mean_edge_length(const MeshShape& shape) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < shape.edges.size(); i += 2) {
    sum += glm::distance(shape.positions[shape.edges[i]], shape.positions[shape.edges[i + 1]]);
  }
  return shape.edges.size() < 2 ? 0.0f
                                : static_cast<float>(2.0 * sum / static_cast<double>(shape.edges.size()));
}

// The renderer reads these structs as they lie in memory.
static_assert(std::is_standard_layout_v<Line> && sizeof(Line) == 32 && offsetof(Line, width_px) == 28);
static_assert(std::is_standard_layout_v<Point> && sizeof(Point) == 20 && offsetof(Point, diameter_px) == 16);
static_assert(sizeof(FaceShape::Vertex) == 28 && offsetof(FaceShape::Vertex, colour) == 24);

void describe_instance(const Line& /*tag*/) {
  floats(0, 3, sizeof(Line), offsetof(Line, from), 1);
  floats(1, 3, sizeof(Line), offsetof(Line, to), 1);
  colour(2, sizeof(Line), offsetof(Line, colour), 1);
  floats(3, 1, sizeof(Line), offsetof(Line, width_px), 1);
}

void describe_instance(const Point& /*tag*/) {
  floats(0, 3, sizeof(Point), offsetof(Point, position), 1);
  colour(1, sizeof(Point), offsetof(Point, colour), 1);
  floats(2, 1, sizeof(Point), offsetof(Point, diameter_px), 1);
}

}  // namespace

MeshBuffers::MeshBuffers(const MeshShape& shape)
    : triangles_(GlVertexArray::make()),
      edges_(GlVertexArray::make()),
      positions_(GlBuffer::make()),
      normals_(GlBuffer::make()),
      times_(GlBuffer::make()),
      triangle_list_(GlBuffer::make()),
      edge_list_(GlBuffer::make()),
      triangle_indices_(static_cast<GLsizei>(shape.triangles.size())),
      edge_indices_(static_cast<GLsizei>(shape.edges.size())),
      mean_edge_(mean_edge_length(shape)) {
  Box box;
  std::ranges::for_each(shape.positions, [&](const glm::vec3& place) { box.add(place); });
  extent_ = box.diagonal();
  centre_ = box.centre();
  // A shape without times or normals is still drawn: nothing may be read past a buffer's end.
  std::vector<float> times = shape.times;
  times.resize(shape.positions.size(), -1.0f);
  std::vector<glm::vec3> normals = shape.normals;
  normals.resize(shape.positions.size(), glm::vec3(0.0f, 1.0f, 0.0f));
  for (const GlVertexArray* array : {&triangles_, &edges_}) {
    glBindVertexArray(array->id());
    if (array == &triangles_) {
      fill(GL_ARRAY_BUFFER, positions_, std::span(shape.positions), GL_STATIC_DRAW);
      fill(GL_ARRAY_BUFFER, normals_, std::span<const glm::vec3>(normals), GL_STATIC_DRAW);
      fill(GL_ARRAY_BUFFER, times_, std::span<const float>(times), GL_STATIC_DRAW);
      fill(GL_ELEMENT_ARRAY_BUFFER, triangle_list_, std::span(shape.triangles), GL_STATIC_DRAW);
    } else {
      fill(GL_ELEMENT_ARRAY_BUFFER, edge_list_, std::span(shape.edges), GL_STATIC_DRAW);
    }
    glBindBuffer(GL_ARRAY_BUFFER, positions_.id());
    floats(0, 3, sizeof(glm::vec3), 0);
    glBindBuffer(GL_ARRAY_BUFFER, normals_.id());
    floats(1, 3, sizeof(glm::vec3), 0);
    glBindBuffer(GL_ARRAY_BUFFER, times_.id());
    floats(2, 1, sizeof(float), 0);
  }
  glBindVertexArray(0);
}

void MeshBuffers::draw_triangles() const {
  glBindVertexArray(triangles_.id());
  glDrawElements(GL_TRIANGLES, triangle_indices_, GL_UNSIGNED_INT, nullptr);
}

void MeshBuffers::draw_edges() const {
  glBindVertexArray(edges_.id());
  glDrawElements(GL_LINES, edge_indices_, GL_UNSIGNED_INT, nullptr);
}

FaceBuffers::FaceBuffers(const FaceShape& shape)
    : array_(GlVertexArray::make()),
      buffer_(GlBuffer::make()),
      vertices_(static_cast<GLsizei>(shape.vertices.size() / 3 * 3)) {
  Box box;
  for (std::size_t i = 0; i + 2 < shape.vertices.size(); i += 3) {
    for (std::size_t side = 0; side < 3; ++side) {
      const glm::vec3& place = shape.vertices[i + side].position;
      box.add(place);
      longest_side_ =
          std::max(longest_side_, glm::distance(place, shape.vertices[i + (side + 1) % 3].position));
    }
  }
  extent_ = box.diagonal();
  glBindVertexArray(array_.id());
  fill(GL_ARRAY_BUFFER, buffer_, std::span(shape.vertices), GL_STATIC_DRAW);
  constexpr std::size_t stride = sizeof(FaceShape::Vertex);
  floats(0, 3, stride, offsetof(FaceShape::Vertex, position));
  floats(1, 3, stride, offsetof(FaceShape::Vertex, normal));
  colour(2, stride, offsetof(FaceShape::Vertex, colour));
  glBindVertexArray(0);
}

void FaceBuffers::draw() const {
  glBindVertexArray(array_.id());
  glDrawArrays(GL_TRIANGLES, 0, vertices_);
}

template <class Item>
InstanceBuffers<Item>::InstanceBuffers() : array_(GlVertexArray::make()), buffer_(GlBuffer::make()) {
  glBindVertexArray(array_.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  describe_instance(Item{});
  glBindVertexArray(0);
}

template <class Item>
void InstanceBuffers<Item>::upload(std::span<const Item> items, GLenum usage) {
  fill(GL_ARRAY_BUFFER, buffer_, items, usage);
  count_ = static_cast<GLsizei>(items.size());
}

template <class Item>
void InstanceBuffers<Item>::draw() const {
  glBindVertexArray(array_.id());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

template class InstanceBuffers<Line>;
template class InstanceBuffers<Point>;

}  // namespace app
