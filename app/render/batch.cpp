#include "app/render/batch.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

namespace app {

namespace {

constexpr std::size_t items_a_piece = 64;
constexpr std::size_t always_whole = 4096;  // so few are drawn faster than looked through
constexpr std::size_t large = std::size_t{1}
                              << 20;  // items; so large a buffer is given back when it is empty

// OpenGL takes offsets into buffers as pointers. NOLINTNEXTLINE(performance-no-int-to-ptr)
const void* at_offset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

void floats(GLuint index, GLint size, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride), at_offset(offset));
}

void colour(GLuint index, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, 4, GL_UNSIGNED_BYTE, GL_TRUE, static_cast<GLsizei>(stride), at_offset(offset));
}

// The renderer reads these structs as they lie in memory.
static_assert(std::is_standard_layout_v<Line> && sizeof(Line) == 32 && offsetof(Line, width_px) == 28);
static_assert(std::is_standard_layout_v<Point> && sizeof(Point) == 20 && offsetof(Point, diameter_px) == 16);
static_assert(sizeof(FaceShape::Vertex) == 28 && offsetof(FaceShape::Vertex, colour) == 24);

float squared(const glm::vec3& way) { return glm::dot(way, way); }

// How each kind lies in the buffer: an item's bytes, how often they are repeated (the three corners of what a
// line or a point covers on the screen, told apart by their number), and where it is.
template <class Shape>
struct Kind;

template <>
struct Kind<std::vector<Line>> {
  using Item = Line;
  static constexpr std::size_t copies = 3;
  static std::span<const Item> items(const std::vector<Line>& shape) { return shape; }
  static void add(const Line& line, Extent& extent) {
    extent.add(line.from);
    extent.add(line.to);
  }
  static float longest_side(const Line& /*line*/) { return 0.0f; }
  static void describe() {
    floats(0, 3, sizeof(Line), offsetof(Line, from));
    floats(1, 3, sizeof(Line), offsetof(Line, to));
    colour(2, sizeof(Line), offsetof(Line, colour));
    floats(3, 1, sizeof(Line), offsetof(Line, width_px));
  }
};

template <>
struct Kind<std::vector<Point>> {
  using Item = Point;
  static constexpr std::size_t copies = 3;
  static std::span<const Item> items(const std::vector<Point>& shape) { return shape; }
  static void add(const Point& point, Extent& extent) { extent.add(point.position); }
  static float longest_side(const Point& /*point*/) { return 0.0f; }
  static void describe() {
    floats(0, 3, sizeof(Point), offsetof(Point, position));
    colour(1, sizeof(Point), offsetof(Point, colour));
    floats(2, 1, sizeof(Point), offsetof(Point, diameter_px));
  }
};

template <>
struct Kind<FaceShape> {
  struct Item {
    std::array<FaceShape::Vertex, 3> corners;
  };
  static constexpr std::size_t copies = 1;
  static std::span<const Item> items(const FaceShape& shape) {
    static_assert(sizeof(Item) == 3 * sizeof(FaceShape::Vertex));
    return {reinterpret_cast<const Item*>(shape.vertices.data()), shape.vertices.size() / 3};
  }
  static void add(const Item& face, Extent& extent) {
    for (const FaceShape::Vertex& corner : face.corners) extent.add(corner.position);
  }
  static float longest_side(const Item& face) {
    const auto& [a, b, c] = face.corners;
    return std::sqrt(std::max({squared(a.position - b.position), squared(b.position - c.position),
                               squared(c.position - a.position)}));
  }
  static void describe() {
    constexpr std::size_t stride = sizeof(FaceShape::Vertex);
    floats(0, 3, stride, offsetof(FaceShape::Vertex, position));
    floats(1, 3, stride, offsetof(FaceShape::Vertex, normal));
    colour(2, stride, offsetof(FaceShape::Vertex, colour));
  }
};

template <class Shape>
constexpr std::size_t bytes_an_item = sizeof(typename Kind<Shape>::Item) * Kind<Shape>::copies;

}  // namespace

Frustum::Frustum(const glm::mat4& to_clip) {
  const glm::vec4 w = glm::row(to_clip, 3);
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(2 * axis);
    planes_[i] = w + glm::row(to_clip, axis);
    planes_[i + 1] = w - glm::row(to_clip, axis);
  }
  for (glm::vec4& plane : planes_) plane /= std::max(glm::length(glm::vec3(plane)), 1e-20f);
}

bool Frustum::touches(const glm::vec3& centre, float radius) const {
  return std::all_of(planes_.begin(), planes_.end(), [&](const glm::vec4& plane) {
    return glm::dot(glm::vec3(plane), centre) + plane.w >= -radius;
  });
}

void Extent::add(const glm::vec3& place) {
  low = empty ? place : glm::min(low, place);
  high = empty ? place : glm::max(high, place);
  empty = false;
}

void Extent::add(const Extent& other) {
  if (other.empty) return;
  add(other.low);
  add(other.high);
}

float Extent::diagonal() const { return empty ? 0.0f : glm::distance(low, high); }

template <class Shape>
Batch<Shape>::Batch() : array_(GlVertexArray::make()), buffer_(GlBuffer::make()) {}

template <class Shape>
void Batch<Shape>::append(const Shape& shape, const Pointer& held) {
  const auto items = Kind<Shape>::items(shape);
  const std::size_t begin = entries_.empty() ? 0 : entries_.back().items_end;
  Entry entry{held, &shape, begin + items.size(), 0, {}, 0.0f};
  for (std::size_t first = 0; first < items.size(); first += items_a_piece) {
    const auto part = items.subspan(first, std::min(items_a_piece, items.size() - first));
    Extent extent;
    for (const auto& item : part) {
      Kind<Shape>::add(item, extent);
      entry.longest_side = std::max(entry.longest_side, Kind<Shape>::longest_side(item));
    }
    entry.extent.add(extent);
    // What is drawn around a line or a point is a little larger than it is.
    pieces_.push_back({begin + first, part.size(), extent.centre(), 0.55f * extent.diagonal()});
  }
  entry.pieces_end = pieces_.size();
  entries_.push_back(entry);
  std::size_t at = waiting_.size();
  waiting_.resize(at + items.size() * bytes_an_item<Shape>);
  for (const auto& item : items) {
    for (std::size_t copy = 0; copy < Kind<Shape>::copies; ++copy, at += sizeof item)
      std::memcpy(waiting_.data() + at, &item, sizeof item);
  }
}

template <class Shape>
void Batch<Shape>::truncate(std::size_t entries) {
  entries_.resize(std::min(entries, entries_.size()));
  pieces_.resize(entries_.empty() ? 0 : entries_.back().pieces_end);
}

// Makes room for so many in all; what is stored already stays.
template <class Shape>
void Batch<Shape>::reserve(std::size_t items) {
  glBindVertexArray(array_.id());
  if (items > capacity_) {
    const std::size_t capacity = std::max({items, 2 * capacity_, std::size_t{256}});
    GlBuffer larger = GlBuffer::make();
    glBindBuffer(GL_COPY_WRITE_BUFFER, larger.id());
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(capacity * bytes_an_item<Shape>), nullptr,
                 GL_DYNAMIC_DRAW);
    if (capacity_ > 0) {
      glBindBuffer(GL_COPY_READ_BUFFER, buffer_.id());
      glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                          static_cast<GLsizeiptr>(capacity_ * bytes_an_item<Shape>));
    }
    buffer_ = std::move(larger);
    capacity_ = capacity;
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    Kind<Shape>::describe();
  }
}

template <class Shape>
void Batch<Shape>::store(std::size_t first_item) {
  reserve(entries_.empty() ? 0 : entries_.back().items_end);
  if (!waiting_.empty()) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    // What is written anew from the beginning must not wait for the frame that still reads the old.
    if (first_item == 0) {
      glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_ * bytes_an_item<Shape>), nullptr,
                   GL_DYNAMIC_DRAW);
    }
    glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(first_item * bytes_an_item<Shape>),
                    static_cast<GLsizeiptr>(waiting_.size()), waiting_.data());
  }
  glBindVertexArray(0);
  waiting_.clear();
  if (waiting_.capacity() > large) waiting_.shrink_to_fit();
}

template <class Shape>
void Batch<Shape>::show(std::span<const Pointer> shapes) {
  std::size_t same = 0;
  while (same < shapes.size() && same < entries_.size() && entries_[same].shape == shapes[same].get() &&
         !entries_[same].alive.expired()) {
    ++same;
  }
  shown_ = shapes.size();
  if (same == shapes.size()) {
    const bool nothing_left = kept() == 0;
    if (nothing_left) truncate(0);
    if (nothing_left && capacity_ > large) {
      buffer_ = GlBuffer::make();
      capacity_ = 0;
    }
    return;
  }
  truncate(same);
  const std::size_t first_item = entries_.empty() ? 0 : entries_.back().items_end;
  for (std::size_t i = same; i < shapes.size(); ++i) append(*shapes[i], shapes[i]);
  uploads_ += shapes.size() - same;
  store(first_item);
}

template <class Shape>
void Batch<Shape>::show_once(const Shape& shape) {
  truncate(0);
  append(shape, nullptr);
  shown_ = Kind<Shape>::items(shape).empty() ? 0 : 1;
  store(0);
}

template <class Shape>
std::size_t Batch<Shape>::draw(const Frustum& frustum) const {
  if (shown_ == 0) return 0;
  const Entry& last = entries_[shown_ - 1];
  constexpr std::size_t corners = 3;  // to draw an item
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  std::size_t drawn = 0;
  std::size_t end = 0;  // of the run of pieces at hand
  const auto take = [&](std::size_t first, std::size_t count) {
    if (!firsts.empty() && end == first) {
      counts.back() += static_cast<GLsizei>(corners * count);
    } else {
      firsts.push_back(static_cast<GLint>(corners * first));
      counts.push_back(static_cast<GLsizei>(corners * count));
    }
    end = first + count;
    drawn += count;
  };
  if (last.items_end <= always_whole) {
    take(0, last.items_end);
  } else {
    for (std::size_t i = 0; i < last.pieces_end; ++i) {
      if (frustum.touches(pieces_[i].centre, pieces_[i].radius)) take(pieces_[i].first, pieces_[i].count);
    }
  }
  if (drawn == 0) return 0;
  glBindVertexArray(array_.id());
  const auto runs = static_cast<GLsizei>(firsts.size());
  glMultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(), runs);
  return drawn;
}

template <class Shape>
std::size_t Batch<Shape>::kept() const {
  return static_cast<std::size_t>(std::count_if(entries_.begin(), entries_.end(),
                                                [](const Entry& entry) { return !entry.alive.expired(); }));
}

template <class Shape>
Extent Batch<Shape>::extent() const {
  Extent extent;
  for (std::size_t i = 0; i < shown_; ++i) extent.add(entries_[i].extent);
  return extent;
}

template <class Shape>
float Batch<Shape>::longest_side() const {
  float longest = 0.0f;
  for (std::size_t i = 0; i < shown_; ++i) longest = std::max(longest, entries_[i].longest_side);
  return longest;
}

template class Batch<std::vector<Line>>;
template class Batch<std::vector<Point>>;
template class Batch<FaceShape>;

}  // namespace app
