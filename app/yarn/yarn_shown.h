// The yarn of what is shown, kept while that stays the same.
//
// It is worked out from the stitches where they are shown [app/session/shown.h]. While rows are made it grows with them, as far
// as what hangs on what is known: of a run that has once come past its faces in the whole of it, so that stitch by stitch can be
// gone through; else row by row as the faces are made.
// Cost: kept; else of make_yarn, and while rows are made the pieces so far once a step.
#pragma once

#include <memory>
#include <vector>

#include "app/scene/scene.h"
#include "app/session/session.h"
#include "app/yarn/yarn_shape.h"

namespace app {

class YarnShown {
 public:
  // `shown`: the fabric as it is shown. Sets the scene's yarn and adds its ground to the faces; gives how many rows are there as
  // yarn, from the first on, and leaves the scene alone where there are none. Requires something open.
  knit::RowId describe(const Session& session, const knit::Fabric& shown, Scene& scene);

 private:
  // What the yarn is of.
  struct Of {
    std::vector<std::shared_ptr<const knit::Row>> rows;
    std::vector<std::shared_ptr<const knit::Strip>> strips;
    knit::StitchSize stitch;
    double radius = 0.0;  // as the look has it
    int easing = 0;
    friend bool operator==(const Of&, const Of&) = default;
  };
  struct Look {
    YarnLook look;
    const Theme* theme = nullptr;
    YarnUpTo until;
    friend bool operator==(const Look&, const Look&) = default;
  };
  void make_yarn(const knit::Fabric& fabric, const YarnLook& look, Of of);
  void make_shapes(const knit::Fabric& fabric, const Look& look);

  Of of_;
  std::vector<glm::dvec3> positions_;
  knit::Yarn yarn_;
  std::vector<glm::vec3> out_;
  bool closed_ = false;
  Look look_;
  std::shared_ptr<const YarnShape> shape_;
  std::shared_ptr<const FaceShape> ground_;
};

}  // namespace app
