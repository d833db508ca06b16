// A run whose stitches are smaller than a few pixels, drawn coarsely: every so many rows of a tube, and on them every so
// many stitches; between tubes from the live stitches that the first row is worked on. Hundreds of thousands of stitches would cover one another, and a hand that scrubs would wait for them.
#pragma once

#include <memory>
#include <vector>

#include "app/describe/describe_stretch.h"
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

// So many rows and stitches stand for one; with `stretch` edges and faces tell how far rows and wales are stretched.
struct CoarseLook {
  int stride = 1;
  std::optional<StretchScale> stretch;
  friend bool operator==(const CoarseLook&, const CoarseLook&) = default;
};

// Keeps the shapes between two rows drawn as long as these are the same.
class Coarse {
 public:
  // Row edges and faces, as the layers say; stitches and column edges are left out. `in_pieces`: only so many shapes
  // are made at once, from below; the rest follows with the next frames (Scene::unfinished).
  void describe(const Session& session, const knit::Fabric& fabric, const CoarseLook& look, bool in_pieces,
                Scene& scene);

 private:
  // From a row to one that stands on it, or, where `below` is null, from what a tube begins on to its first row.
  struct Kept {
    std::shared_ptr<const knit::Row> below, above;
    std::vector<std::shared_ptr<const void>> about;  // all that it is made of
    std::shared_ptr<const std::vector<Line>> edges;
    std::shared_ptr<const FaceShape> faces;  // null: none yet
  };
  struct Band {
    knit::RowId low = 0, high = 0;  // 0: below a tube's first row; above what has no strip yet
  };
  static std::vector<Band> bands_of(const knit::Fabric& fabric, int stride);
  void make(const knit::Fabric& fabric, const Band& band, Kept& kept) const;

  const Theme* theme_ = nullptr;
  CoarseLook look_;
  std::vector<Kept> kept_;
};

}  // namespace app
