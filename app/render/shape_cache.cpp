#include "app/render/shape_cache.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace app {

namespace {

template <class Item>
void fill(GLenum target, const GlBuffer& buffer, std::span<const Item> items, GLenum usage) {
  glBindBuffer(target, buffer.id());
  glBufferData(target, static_cast<GLsizeiptr>(items.size_bytes()), items.empty() ? nullptr : items.data(),
               usage);
}

// Of many edges every so many-th tells it as well.
float mean_edge_length(const MeshShape& shape) {
  constexpr std::size_t enough = 100000;
  const std::size_t edges = shape.edges.size() / 2;
  const std::size_t stride = edges / enough + 1;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < edges; i += stride, ++count)
    sum += glm::distance(shape.positions[shape.edges[2 * i]], shape.positions[shape.edges[2 * i + 1]]);
  return count == 0 ? 0.0f : static_cast<float>(sum / static_cast<double>(count));
}

// Sorting more would hold up a frame.
constexpr std::size_t most_sorted = 200000;

template <class T>
bool is_same(const std::weak_ptr<T>& kept, const std::shared_ptr<T>& given) {
  return !kept.owner_before(given) && !given.owner_before(kept);
}

}  // namespace

MeshBuffers::MeshBuffers(const MeshShape& shape)
    : triangles_(GlVertexArray::make()),
      edges_(GlVertexArray::make()),
      positions_(GlBuffer::make()),
      normals_(GlBuffer::make()),
      triangle_list_(GlBuffer::make()),
      edge_list_(GlBuffer::make()),
      triangle_indices_(static_cast<GLsizei>(shape.triangles.size())),
      vertices_(shape.positions.size()),
      mean_edge_(mean_edge_length(shape)) {
  Extent box;
  for (const glm::vec3& place : shape.positions) box.add(place);
  extent_ = box.diagonal();
  centre_ = box.centre();
  // A shape without normals is still drawn: nothing may be read past a buffer's end.
  std::vector<glm::vec3> others;
  if (shape.normals.size() < shape.positions.size()) {
    others = shape.normals;
    others.resize(shape.positions.size(), glm::vec3(0.0f, 1.0f, 0.0f));
  }
  const std::vector<glm::vec3>& normals = others.empty() ? shape.normals : others;
  for (const GlVertexArray* array : {&triangles_, &edges_}) {
    glBindVertexArray(array->id());
    if (array == &triangles_) {
      fill(GL_ARRAY_BUFFER, positions_, std::span(shape.positions), GL_STATIC_DRAW);
      fill(GL_ARRAY_BUFFER, normals_, std::span<const glm::vec3>(normals), GL_STATIC_DRAW);
      fill(GL_ELEMENT_ARRAY_BUFFER, triangle_list_, std::span(shape.triangles), GL_STATIC_DRAW);
    }
    glBindBuffer(GL_ARRAY_BUFFER, positions_.id());
    floats(0, 3, sizeof(glm::vec3), 0);
    glBindBuffer(GL_ARRAY_BUFFER, normals_.id());
    floats(1, 3, sizeof(glm::vec3), 0);
  }
  glBindVertexArray(0);
}

TimeBuffer::TimeBuffer(const std::vector<float>& times) : times_(GlBuffer::make()), count_(times.size()) {
  fill(GL_ARRAY_BUFFER, times_, std::span(times), GL_STATIC_DRAW);
}

// Into the vertex array that is bound. Too few, and one would be read past the buffer's end.
void MeshBuffers::take_times(const TimeBuffer* times) const {
  if (times == nullptr || times->count() < vertices_) {
    glDisableVertexAttribArray(2);
    glVertexAttrib1f(2, -1.0f);
    return;
  }
  glBindBuffer(GL_ARRAY_BUFFER, times->id());
  floats(2, 1, sizeof(float), 0);
}

std::size_t MeshBuffers::draw_triangles(const TimeBuffer* times) const {
  glBindVertexArray(triangles_.id());
  take_times(times);
  glDrawElements(GL_TRIANGLES, triangle_indices_, GL_UNSIGNED_INT, nullptr);
  return static_cast<std::size_t>(triangle_indices_) / 3;
}

// Requires the triangles' vertex array bound.
void MeshBuffers::put_in_order(const MeshShape& shape,
                               const std::shared_ptr<const std::vector<float>>& times) const {
  struct Timed {
    float earliest, latest;
    std::uint32_t triangle;
  };
  const std::size_t count = shape.triangles.size() / 3;
  std::vector<Timed> order;
  order.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto time = [&](std::size_t corner) { return (*times)[shape.triangles[3 * i + corner]]; };
    const auto [earliest, latest] = std::minmax({time(0), time(1), time(2)});
    order.push_back({earliest, latest, i});
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Timed& a, const Timed& b) { return a.earliest < b.earliest; });
  order_ = {times, {}, {}};
  std::vector<std::uint32_t> triangles;
  triangles.reserve(shape.triangles.size());
  float latest = 0.0f;
  for (const Timed& timed : order) {
    const auto first = shape.triangles.begin() + 3 * static_cast<std::ptrdiff_t>(timed.triangle);
    triangles.insert(triangles.end(), first, first + 3);
    latest = std::max(latest, timed.latest);
    order_.earliest.push_back(timed.earliest);
    order_.latest_so_far.push_back(latest);
  }
  fill(GL_ELEMENT_ARRAY_BUFFER, triangle_list_, std::span<const std::uint32_t>(triangles), GL_STATIC_DRAW);
}

std::size_t MeshBuffers::draw_uncovered(const MeshShape& shape,
                                        const std::shared_ptr<const std::vector<float>>& told,
                                        const TimeBuffer& buffer, const TimeSpan& covered) const {
  const auto all = static_cast<std::size_t>(triangle_indices_) / 3;
  if (all > most_sorted || told->size() < vertices_) return draw_triangles(&buffer);
  glBindVertexArray(triangles_.id());
  take_times(&buffer);
  if (!is_same(order_.times, told)) put_in_order(shape, told);
  const auto below = static_cast<std::size_t>(
      std::lower_bound(order_.earliest.begin(), order_.earliest.end(), covered.from) -
      order_.earliest.begin());
  const auto above = static_cast<std::size_t>(
      std::upper_bound(order_.latest_so_far.begin(), order_.latest_so_far.end(), covered.to) -
      order_.latest_so_far.begin());
  if (above <= below) return draw_triangles(&buffer);
  const auto draw = [](std::size_t first, std::size_t count) {
    if (count == 0) return;
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                   at_offset(3 * first * sizeof(GLuint)));
  };
  draw(0, below);
  draw(above, all - above);
  return below + (all - above);
}

void MeshBuffers::draw_edges(const MeshShape& shape, const TimeBuffer* times) const {
  glBindVertexArray(edges_.id());
  if (!edges_sent_) fill(GL_ELEMENT_ARRAY_BUFFER, edge_list_, std::span(shape.edges), GL_STATIC_DRAW);
  edges_sent_ = true;
  take_times(times);
  glDrawElements(GL_LINES, static_cast<GLsizei>(shape.edges.size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace app
