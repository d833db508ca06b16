#include "knit/rows/cast_on_events.h"

#include "knit/model/words.h"
#include "knit/rows/row_variables.h"
#include "knit/timing/timing_variables.h"

namespace knit {

std::string CycleFound::sentence(const Telling& /*at*/) const {
  std::string text = "The first cycle is level " + std::to_string(level) + " at t = " + short_number(time) +
                     ": " + plural(vertices, "vertex", "vertices") + ", " + short_number(length) + " round.";
  if (passed_over > 0)
    text += " " + plural(passed_over, "shorter level was", "shorter levels were") + " passed over.";
  return text;
}
StepFields CycleFound::numbers() const {
  return {{var::level, level}, {var::last_level, last_level},       {var::passed_over, passed_over},
          {var::time, time},   {"vertices", &var::count, vertices}, {var::length, length}};
}

std::string StitchCastOn::sentence(const Telling& /*at*/) const {
  return "Cast-on stitch " + std::to_string(stitch) + " of " + std::to_string(of) + " is placed, " +
         short_number(arc) + " along the first cycle.";
}
StepFields StitchCastOn::numbers() const {
  return {{"stitch", &var::item, stitch}, {"of", &var::k, of}, {var::arc, arc}};
}

}  // namespace knit
