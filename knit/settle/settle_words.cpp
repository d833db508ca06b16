#include "knit/model/words.h"
#include "knit/settle/settle_events.h"
#include "knit/settle/settle_variables.h"

namespace knit {

std::string SettlingBegun::sentence(const Telling& /*at*/) const {
  return "Settling begins: " + stitch_count_text(stitches) + " hang together by " +
         plural(wales, "wale edge", "wale edges") + " and " + plural(courses, "course edge", "course edges") +
         "; their weighted squares come to " + short_number(sum) + ".";
}
StepFields SettlingBegun::numbers() const {
  return {
      {var::moved, stitches}, {var::wale_edges, wales}, {var::course_edges, courses}, {var::settle_sum, sum}};
}

std::string StitchesSettled::sentence(const Telling& /*at*/) const {
  const std::string name = "Iteration " + std::to_string(iteration);
  if (!taken) return name + ": no step makes it better; the stitches are at ease where they are.";
  const std::string moved = name + ": stitches move by " + short_number(mean_move) + " w on average, " +
                            short_number(greatest_move) + " w at most; the sum falls from " +
                            short_number(before) + " to " + short_number(after) + ".";
  return last ? moved + " Settling ends." : moved;
}
StepFields StitchesSettled::numbers() const {
  return {{var::iteration, iteration},
          {var::tries, tries},
          {var::shift, double{shift}},
          {var::sum_before, double{before}},
          {var::settle_sum, double{after}},
          {var::mean_move, double{mean_move}},
          {var::greatest_move, double{greatest_move}},
          {var::taken, taken}};
}

}  // namespace knit
