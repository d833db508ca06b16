// What lies on the graphics card. A shared shape is uploaded when it is first drawn and stays as long as
// somebody holds its pointer.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>

#include "app/render/batch.h"
#include "app/render/gl_handle.h"
#include "app/scene/scene.h"

namespace app {

// A float a vertex: its time.
class TimeBuffer {
 public:
  explicit TimeBuffer(const std::vector<float>& times);
  GLuint id() const { return times_.id(); }
  std::size_t count() const { return count_; }

 private:
  GlBuffer times_;
  std::size_t count_ = 0;
};

class MeshBuffers {
 public:
  explicit MeshBuffers(const MeshShape& shape);
  // `times`: of the vertices; null: none has one.
  std::size_t draw_triangles(const TimeBuffer* times) const;  // gives how many, as the next
  // Those of the shape that these are the buffers of, without those whose vertices are all told to lie within
  // `covered`. The triangles are put in order when this is first asked, and when what is told changes; of a large mesh
  // all are drawn.
  std::size_t draw_uncovered(const MeshShape& shape, const std::shared_ptr<const std::vector<float>>& told,
                             const TimeBuffer& buffer, const TimeSpan& covered) const;
  // Edges of the shape that these are the buffers of; they are sent when they are first drawn.
  void draw_edges(const MeshShape& shape, const TimeBuffer* times) const;
  float extent() const { return extent_; }        // diagonal of the bounding box
  float mean_edge() const { return mean_edge_; }  // 0 without edges
  glm::vec3 centre() const { return centre_; }

 private:
  // The triangles as they lie in the buffer: by their earliest vertex, or what else is told.
  struct Order {
    std::weak_ptr<const std::vector<float>> times;
    std::vector<float> earliest;       // of each, ascending
    std::vector<float> latest_so_far;  // of all up to each
  };
  void take_times(const TimeBuffer* times) const;
  void put_in_order(const MeshShape& shape, const std::shared_ptr<const std::vector<float>>& times) const;

  GlVertexArray triangles_, edges_;

  GlBuffer positions_, normals_, triangle_list_, edge_list_;
  GLsizei triangle_indices_ = 0;
  std::size_t vertices_ = 0;
  mutable bool edges_sent_ = false;
  mutable Order order_;
  float extent_ = 0.0f, mean_edge_ = 0.0f;
  glm::vec3 centre_{0.0f};
};

template <class Shape, class Buffers>
class ShapeCache {
 public:
  // `shape` is not null. The reference holds until drop_dead().
  const Buffers& get(const std::shared_ptr<const Shape>& shape) {
    const auto found = entries_.find(shape.get());
    if (found != entries_.end() && !found->second.alive.expired()) {
      return found->second.buffers;
    }
    ++uploads_;
    // An address may be used again after its shape has gone.
    entries_.erase(shape.get());
    return entries_.emplace(shape.get(), Entry{shape, Buffers(*shape)}).first->second.buffers;
  }
  void drop_dead() {
    std::erase_if(entries_, [](const auto& entry) { return entry.second.alive.expired(); });
  }
  std::size_t uploads() const { return uploads_; }
  std::size_t kept() const { return entries_.size(); }

 private:
  struct Entry {
    std::weak_ptr<const Shape> alive;
    Buffers buffers;
  };
  std::map<const Shape*, Entry> entries_;
  std::size_t uploads_ = 0;
};

}  // namespace app
