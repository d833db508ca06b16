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

void colour(GLuint index, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, 4, GL_UNSIGNED_BYTE, GL_TRUE, static_cast<GLsizei>(stride), at_offset(offset));
}

float squared(const glm::vec3& way) { return glm::dot(way, way); }

// Writes values one after the other.
class Writer {
 public:
  explicit Writer(void* at) : at_(static_cast<std::byte*>(at)) {}
  void put(const auto& value) {
    std::memcpy(at_, &value, sizeof value);
    at_ += sizeof value;
  }

 private:
  std::byte* at_;
};

// How each kind lies in the buffer: the vertices of an item, as bytes and as OpenGL finds them, and the items'
// places. A line or a point has three vertices alike, the corners of what it covers on the screen, told apart by
// their number.
template <class Shape>
struct Kind;

template <>
struct Kind<std::vector<Line>> {
  using Item = Line;
  static constexpr std::size_t vertices = 3;
  static constexpr std::size_t stride = sizeof(Line);
  static_assert(std::is_standard_layout_v<Line> && sizeof(Line) == 32 && offsetof(Line, width_px) == 28);
  static std::span<const Item> items(const std::vector<Line>& shape) { return shape; }
  static std::array<glm::vec3, 2> places(const Line& line) { return {line.from, line.to}; }
  static void describe() {
    floats(0, 3, stride, offsetof(Line, from));
    floats(1, 3, stride, offsetof(Line, to));
    colour(2, stride, offsetof(Line, colour));
    floats(3, 1, stride, offsetof(Line, width_px));
  }
  static void write(const Line& line, Writer& writer) {
    for (std::size_t corner = 0; corner < vertices; ++corner) writer.put(line);
  }
};

template <>
struct Kind<std::vector<Point>> {
  using Item = Point;
  static constexpr std::size_t vertices = 3;
  static constexpr std::size_t stride = sizeof(Point);
  static_assert(std::is_standard_layout_v<Point> && sizeof(Point) == 20 &&
                offsetof(Point, diameter_px) == 16);
  static std::span<const Item> items(const std::vector<Point>& shape) { return shape; }
  static std::array<glm::vec3, 1> places(const Point& point) { return {point.position}; }
  static void describe() {
    floats(0, 3, stride, offsetof(Point, position));
    colour(1, stride, offsetof(Point, colour));
    floats(2, 1, stride, offsetof(Point, diameter_px));
  }
  static void write(const Point& point, Writer& writer) {
    for (std::size_t corner = 0; corner < vertices; ++corner) writer.put(point);
  }
};

// Four vertices, which two triangles share; a face that is a triangle has one of them without extent.
template <>
struct Kind<FaceShape> {
  struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    Colour colour;
  };
  static_assert(sizeof(Vertex) == 28 && offsetof(Vertex, colour) == 24);
  using Item = FaceShape::Face;
  static constexpr std::size_t vertices = 4;
  static constexpr std::size_t stride = sizeof(Vertex);
  static constexpr std::array<GLuint, 6> corners{0, 1, 2, 0, 2, 3};
  static std::span<const Item> items(const FaceShape& shape) { return shape.faces; }
  static std::array<glm::vec3, 4> places(const Item& face) { return face.corners; }
  static void describe() {
    floats(0, 3, stride, offsetof(Vertex, position));
    floats(1, 3, stride, offsetof(Vertex, normal));
    colour(2, stride, offsetof(Vertex, colour));
  }
  static void write(const Item& face, Writer& writer) {
    for (const glm::vec3& corner : face.corners) writer.put(Vertex{corner, face.normal, face.colour});
  }
  static float longest_side_squared(const Item& face) {
    const auto& [a, b, c, d] = face.corners;
    return std::max({squared(a - b), squared(b - c), squared(c - a), squared(c - d), squared(d - a)});
  }
};

template <class Shape>
constexpr bool indexed = std::is_same_v<Shape, FaceShape>;
template <class Shape>
constexpr std::size_t bytes_an_item = Kind<Shape>::stride* Kind<Shape>::vertices;

// Items that lie one after the other.
struct Run {
  std::size_t first = 0, count = 0;
};

template <class Shape>
void draw_runs(std::span<const Run> runs) {
  std::vector<GLsizei> counts;
  if constexpr (indexed<Shape>) {
    constexpr std::size_t corners = Kind<Shape>::corners.size();
    std::vector<const void*> offsets;
    for (const Run& run : runs) {
      offsets.push_back(at_offset(corners * run.first * sizeof(GLuint)));
      counts.push_back(static_cast<GLsizei>(corners * run.count));
    }
    draw_many_indexed(counts, offsets);
  } else {
    std::vector<GLint> firsts;
    for (const Run& run : runs) {
      firsts.push_back(static_cast<GLint>(Kind<Shape>::vertices * run.first));
      counts.push_back(static_cast<GLsizei>(Kind<Shape>::vertices * run.count));
    }
    draw_many(firsts, counts);
  }
}

// For so many items, into the buffer bound for indices.
template <class Shape>
void store_indices(std::size_t items) {
  std::vector<GLuint> indices;
  indices.reserve(items * Kind<Shape>::corners.size());
  for (std::size_t item = 0; item < items; ++item) {
    for (const GLuint corner : Kind<Shape>::corners)
      indices.push_back(static_cast<GLuint>(item * Kind<Shape>::vertices) + corner);
  }
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)),
               indices.data(), GL_DYNAMIC_DRAW);
}

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
  float longest_squared = 0.0f;
  for (std::size_t first = 0; first < items.size(); first += items_a_piece) {
    const auto part = items.subspan(first, std::min(items_a_piece, items.size() - first));
    glm::vec3 low = Kind<Shape>::places(part.front()).front(), high = low;
    for (const auto& item : part) {
      for (const glm::vec3& place : Kind<Shape>::places(item)) {
        low = glm::min(low, place);
        high = glm::max(high, place);
      }
      if constexpr (indexed<Shape>)
        longest_squared = std::max(longest_squared, Kind<Shape>::longest_side_squared(item));
    }
    const Extent extent{low, high, false};
    entry.extent.add(extent);
    // What is drawn around a line or a point is a little larger than it is.
    pieces_.push_back({begin + first, part.size(), extent.centre(), 0.55f * extent.diagonal()});
  }
  entry.longest_side = std::sqrt(longest_squared);
  entry.pieces_end = pieces_.size();
  entries_.push_back(entry);
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
    if constexpr (indexed<Shape>) {
      indices_ = GlBuffer::make();
      glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
      store_indices<Shape>(capacity);
    }
  }
}

// Of the entries from this one on. Where the driver has no memory for it now, they are not shown, and the next frame
// tries again.
template <class Shape>
void Batch<Shape>::store(std::size_t first_entry) {
  const std::size_t first = first_entry == 0 ? 0 : entries_[first_entry - 1].items_end;
  const std::size_t end = entries_.empty() ? 0 : entries_.back().items_end;
  reserve(end);
  bool stored = first == end;
  if (!stored) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    // What is written anew from the beginning must not wait for the frame that still reads the old.
    const GLbitfield forget = first == 0 ? GL_MAP_INVALIDATE_BUFFER_BIT : GL_MAP_INVALIDATE_RANGE_BIT;
    void* const memory = glMapBufferRange(
        GL_ARRAY_BUFFER, static_cast<GLintptr>(first * bytes_an_item<Shape>),
        static_cast<GLsizeiptr>((end - first) * bytes_an_item<Shape>), GL_MAP_WRITE_BIT | forget);
    if (memory != nullptr) {
      Writer writer(memory);
      for (std::size_t i = first_entry; i < entries_.size(); ++i) {
        for (const auto& item : Kind<Shape>::items(*entries_[i].shape)) Kind<Shape>::write(item, writer);
      }
      stored = glUnmapBuffer(GL_ARRAY_BUFFER) == GL_TRUE;
    }
  }
  glBindVertexArray(0);
  if (!stored) {
    truncate(first_entry);
    shown_ = std::min(shown_, first_entry);
  }
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
      indices_ = GlBuffer();
      capacity_ = 0;
    }
    return;
  }
  truncate(same);
  for (std::size_t i = same; i < shapes.size(); ++i) append(*shapes[i], shapes[i]);
  uploads_ += shapes.size() - same;
  store(same);
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
  std::vector<Run> runs;
  std::size_t drawn = 0;
  const auto take = [&](std::size_t first, std::size_t count) {
    if (!runs.empty() && runs.back().first + runs.back().count == first)
      runs.back().count += count;
    else
      runs.push_back({first, count});
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
  draw_runs<Shape>(runs);
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
