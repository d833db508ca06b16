// The ground of a scene: the mesh that came in, the times of its vertices and its isolines. Each is kept as long as
// it is the same, so that a renderer uploads it once; of a large mesh a worker makes it.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "app/base/worker.h"
#include "app/scene/scene.h"
#include "app/session/document.h"
#include "app/session/session.h"

namespace app {

// What is made of a source: the last one made, and the one under way.
template <class Source, class Product>
class MadeOf {
 public:
  using Result = std::shared_ptr<const Product>;
  // Null: not ready yet. `make` reads nothing but what it holds.
  template <class Make>
  Result get(const std::shared_ptr<const Source>& source, bool beside, const Make& make) {
    if (source == source_ && product_) return product_;
    if (beside && (wanted_ != source || !work_.running())) {
      wanted_ = source;
      work_ = Work<Result>(make);
    }
    if (beside && !work_.ready()) return nullptr;
    product_ = beside ? work_.take() : make();
    work_.drop();
    source_ = source;
    return product_;
  }
  void forget() { *this = MadeOf(); }

 private:
  std::shared_ptr<const Source> source_, wanted_;
  Result product_;
  Work<Result> work_;
};

// In a window it is worth a worker from so many triangles on.
inline constexpr std::size_t made_beside_triangles = 100000;

class Ground {
 public:
  // `beside`: what takes long comes with later frames (Scene::unfinished). Requires something open.
  void describe(const Session& session, bool beside, Scene& scene);
  void forget_colours() { isolines_.forget(); }

 private:
  void describe_times(const Session& session, Scene& scene);

  MadeOf<knit::Input, MeshShape> shape_;
  MadeOf<knit::Timing, std::vector<Line>> isolines_;
  std::shared_ptr<const knit::Timing> timing_;  // that `times_` are of
  std::shared_ptr<const std::vector<float>> times_;
};

}  // namespace app
