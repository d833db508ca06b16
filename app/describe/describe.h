// From a session to what there is to see: a pure function, but for products already turned into shapes, which
// are kept.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/checker/checked_scene.h"
#include "app/describe/describe_coarse.h"
#include "app/describe/describe_ghost.h"
#include "app/describe/describe_ground.h"
#include "app/describe/describe_stretch.h"
#include "app/describe/describe_symbols.h"
#include "app/scene/scene.h"
#include "app/session/session.h"
#include "app/yarn/yarn_shown.h"
#include "knit/fabric/fabric.h"

namespace app {

// What a picture depends on beside the session.
struct Showing {
  double height_px = 600.0;  // of the view, in pixels of a plain screen
  double appeared = 1.0;     // of the last step's movement: describe_motion.h
  bool in_pieces = false;    // much that is new may come over some frames: Scene::unfinished
};

// Keeps the shapes of finished products, by the products' pointers, so that a renderer uploads each once.
class Describer {
 public:
  [[nodiscard]] Scene describe(const Session& session, const Showing& showing = {});

 private:
  struct RowShapes {
    std::shared_ptr<const knit::Row> row;
    Colour colour;
    std::shared_ptr<const std::vector<Line>> edges;
    std::shared_ptr<const std::vector<Point>> stitches;
  };
  struct StripShapes {
    std::shared_ptr<const knit::Strip> strip;
    std::vector<std::shared_ptr<const void>> about;  // the rows and deals that it stands between
    std::shared_ptr<const FaceShape> faces;
    std::shared_ptr<const std::vector<Line>> columns;
  };

  void take_look(const Session& session, const Theme& theme);
  const knit::Fabric& fabric_of(const Session& session);
  void add_rows(const Session& session, Scene& scene);
  void add_strips(const Session& session, Scene& scene);
  void describe_covered(const Session& session, Scene& scene);

  // Of the shapes kept.
  const Theme* theme_ = nullptr;
  std::optional<StretchScale> stretch_;
  // The fabric as its stitches were placed, so that its rows stay the same ones; of what `placed_as_` holds.
  knit::Fabric placed_;
  std::shared_ptr<const std::vector<glm::dvec3>> placed_as_;
  Ground ground_;
  MadeOf<knit::TubePlan, std::vector<float>> ends_;  // of limbs: describe_ends.h
  std::vector<RowShapes> rows_;                      // [i]: of row i + 1, as last seen
  std::vector<StripShapes> strips_;
  YarnShown yarn_;
  knit::RowId rows_as_yarn_ = 0;  // in this scene, from the first on
  Coarse coarse_;
  Symbols symbols_;
  Ghost ghost_;
  CheckedScene checked_;
};

}  // namespace app
