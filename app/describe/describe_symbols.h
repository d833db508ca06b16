// The chart's symbols on the faces that bear them, when one comes near enough to read them.
#pragma once

#include <memory>
#include <vector>

#include "app/scene/scene.h"
#include "app/session/session.h"

namespace app {

inline constexpr double symbol_first_px = 20.0;  // a stitch so wide begins to show its symbol,
inline constexpr double symbol_full_px = 32.0;   // and so wide shows it fully

// Keeps its lines as long as they are the same, so that a renderer uploads them once.
class Symbols {
 public:
  // Requires something open. `height_px`: of the view.
  void describe(const Session& session, double height_px, Scene& scene);

 private:
  std::shared_ptr<const std::vector<Line>> lines_;
};

}  // namespace app
