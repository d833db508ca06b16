#include "app/render/shape_cache.h"

#include <algorithm>
#include <glm/geometric.hpp>

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

void floats(GLuint index, GLint size, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride), at_offset(offset));
}

float mean_edge_length(const MeshShape& shape) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < shape.edges.size(); i += 2) {
    sum += glm::distance(shape.positions[shape.edges[i]], shape.positions[shape.edges[i + 1]]);
  }
  return shape.edges.size() < 2 ? 0.0f
                                : static_cast<float>(2.0 * sum / static_cast<double>(shape.edges.size()));
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
  Extent box;
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

}  // namespace app
