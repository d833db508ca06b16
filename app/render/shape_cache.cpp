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

// Sorting more would hold up a frame.
constexpr std::size_t most_sorted = 200000;

struct ByTime {
  std::vector<std::uint32_t> triangles;
  std::vector<float> earliest;
  float longest = 0.0f;
};

// The triangles by their earliest vertex; as they come where there are no times, or too many.
ByTime by_time(const MeshShape& shape) {
  const std::size_t count = shape.triangles.size() / 3;
  const bool timed = shape.times.size() == shape.positions.size() &&
                     std::ranges::all_of(shape.times, [](float time) { return time >= 0.0f; });
  if (!timed || count > most_sorted) return {shape.triangles, {}, 0.0f};
  struct Entry {
    float earliest;
    std::uint32_t triangle;
  };
  ByTime sorted;
  std::vector<Entry> order;
  order.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [low, high] =
        std::minmax({shape.times[shape.triangles[3 * i]], shape.times[shape.triangles[3 * i + 1]],
                     shape.times[shape.triangles[3 * i + 2]]});
    order.push_back({low, i});
    sorted.longest = std::max(sorted.longest, high - low);
  }
  std::ranges::stable_sort(order, {}, &Entry::earliest);
  sorted.triangles.reserve(shape.triangles.size());
  for (const Entry& entry : order) {
    const auto first = shape.triangles.begin() + 3 * static_cast<std::ptrdiff_t>(entry.triangle);
    sorted.triangles.insert(sorted.triangles.end(), first, first + 3);
    sorted.earliest.push_back(entry.earliest);
  }
  return sorted;
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
  ByTime sorted = by_time(shape);
  earliest_ = std::move(sorted.earliest);
  longest_ = sorted.longest;
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
      fill(GL_ELEMENT_ARRAY_BUFFER, triangle_list_, std::span<const std::uint32_t>(sorted.triangles),
           GL_STATIC_DRAW);
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

std::size_t MeshBuffers::draw_triangles(const std::optional<TimeSpan>& covered) const {
  const auto all = static_cast<std::size_t>(triangle_indices_) / 3;
  std::size_t below = all, above = all;  // up to the first, and from the second on
  if (covered && !earliest_.empty()) {
    const auto at = [&](float time) {
      const auto found = std::ranges::lower_bound(earliest_, time);
      return static_cast<std::size_t>(found - earliest_.begin());
    };
    below = at(covered->from);
    above =
        std::max(below, at(covered->to - longest_));  // some of these end in time, and are drawn all the same
  }
  const auto draw = [](std::size_t first, std::size_t count) {
    if (count == 0) return;
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                   at_offset(3 * first * sizeof(GLuint)));
  };
  glBindVertexArray(triangles_.id());
  draw(0, below);
  draw(above, all - above);
  return below + (all - above);
}

void MeshBuffers::draw_edges() const {
  glBindVertexArray(edges_.id());
  glDrawElements(GL_LINES, edge_indices_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace app
