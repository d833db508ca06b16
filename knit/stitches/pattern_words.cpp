#include "knit/stitches/pattern_events.h"

#include "knit/model/words.h"
#include "knit/stitches/stitch_variables.h"

namespace knit {

std::string LineWritten::sentence(const Telling& at) const {
  return "The line of row " + std::to_string(at.place.row) + " is written: it consumes " +
         stitch_count_text(consumed) + " and makes " + std::to_string(produced) + ".";
}
StepFields LineWritten::numbers() const { return {{var::consumed, consumed}, {var::produced, produced}}; }

}  // namespace knit
