#include "knit/model/words.h"
#include "knit/relax/relax_events.h"
#include "knit/relax/relax_stage.h"
#include "knit/relax/relax_variables.h"

namespace knit {

namespace {

std::string cm_text(double length, const StitchSize& stitch) {
  return fixed_number(length * stitch.centimetres_per_unit, 1) + " cm";
}

}  // namespace

std::string RelaxPlanned::sentence(const Telling& /*at*/) const {
  const std::string stuffed =
      stuffing > 0.0F ? "stuffed so that fabric stretches by about " + percent_text(double{stuffing})
                      : std::string("not stuffed");
  const std::string lids =
      lidded > 0 ? "; " + plural(lidded, "inner row stays", "inner rows stay") + " hollow" : std::string();
  return "The piece comes off the needles: " + stitch_count_text(stitches) + " on " +
         plural(springs, "spring", "springs") + ", " + stuffed + lids + ".";
}
StepFields RelaxPlanned::numbers() const {
  return {{var::hung, stitches},     {var::springs, springs},
          {var::lidded, lidded},     {var::stuffing, double{stuffing}},
          {var::pressure, pressure}, {var::ball_radius, radius}};
}

std::string StitchesRelaxed::sentence(const Telling& /*at*/) const {
  std::string words = "Iteration " + std::to_string(iteration) + ": no stitch moves by more than " +
                      short_number(double{greatest_move}) + " w; it holds " + short_number(volume) +
                      " cubic units.";
  if (touching > 0) words += " " + plural(touching, "pair is", "pairs are") + " kept apart.";
  if (restarted) words += " Its momentum led uphill and starts again.";
  return last ? words + " Relaxing ends." : words;
}
StepFields StitchesRelaxed::numbers() const {
  return {{var::relax_iteration, iteration},
          {var::relax_move, double{greatest_move}},
          {var::volume, volume},
          {var::touching, touching},
          {var::restarted, restarted}};
}

std::string RelaxDone::sentence(const Telling& at) const {
  if (swelled_without_bound(iterations, came_to_rest, at.parameters.relax)) return std::string(swelled_words);
  const StitchSize& stitch = at.parameters.stitch;
  std::string words = at.parameters.relax.stuffing > 0.0 ? "Knitted and stuffed" : "Knitted";
  words += ", this comes out " + cm_text(double{height}, stitch) + " high and " +
           cm_text(double{width}, stitch) + " wide; the mesh asks for " +
           cm_text(double{asked_height}, stitch) + " and " + cm_text(double{asked_width}, stitch) + ".";
  return came_to_rest
             ? words
             : words + " After " + plural(iterations, "iteration", "iterations") + " stitches still move.";
}
StepFields RelaxDone::numbers() const {
  return {{var::relax_iteration, iterations},      {var::knitted_height, double{height}},
          {var::knitted_width, double{width}},     {var::asked_height, double{asked_height}},
          {var::asked_width, double{asked_width}}, {var::sunk_first, double{sunk_first}},
          {var::sunk_last, double{sunk_last}},     {var::came_to_rest, came_to_rest}};
}

}  // namespace knit
