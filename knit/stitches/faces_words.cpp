#include "knit/stitches/faces_events.h"

#include "knit/model/words.h"
#include "knit/stitches/stitch_variables.h"

namespace knit {

std::string FaceMade::sentence(const Telling& at) const {
  return at.row() + ": face " + std::to_string(index) + " of " + std::to_string(of) + " is a " +
         (corner_count == 4 ? "quad" : "triangle") + ", " + std::string(name_of(label)) + ".";
}
StepFields FaceMade::numbers() const {
  return {{var::face, index}, {var::of, of}, {var::corners, corner_count}, {var::label, name_of(label)}};
}

}  // namespace knit
