// A run whose stitches are smaller than a few pixels, drawn coarsely: every so many rows, and on them every so many
// stitches. Hundreds of thousands of stitches would cover one another, and a hand that scrubs would wait for them.
#pragma once

#include <memory>
#include <vector>

#include "app/scene/scene.h"
#include "app/session/session.h"
#include "knit/fabric/fabric.h"

namespace app {

inline constexpr std::size_t cells_a_frame = 10000;  // made anew in a piece
inline constexpr std::size_t always_whole_stitches = 16000;
inline constexpr double coarse_stitch_px = 12.0;

// How many rows, and stitches of a row, stand for one, so that what is drawn is at least so many
// pixels wide, in a view `height_px` high. 1: every stitch is drawn.
int coarseness(const Session& session, double height_px);

// Keeps the shapes between two rows drawn as long as these are the same.
class Coarse {
 public:
  // Row edges and faces, as the layers say; stitches and column edges are left out. `in_pieces`: only so many shapes
  // are made at once, from below; the rest follows with the next frames (Scene::unfinished).
  void describe(const Session& session, int stride, bool in_pieces, Scene& scene);

 private:
  struct Kept {
    std::shared_ptr<const knit::Row> below, above;
    std::shared_ptr<const knit::Strip> strip;  // between them, the lowest
    std::shared_ptr<const std::vector<Line>> edges;
    std::shared_ptr<const FaceShape> faces;  // null: none yet
  };
  const Theme* theme_ = nullptr;
  int stride_ = 0;
  std::vector<Kept> kept_;
};

}  // namespace app
