#include "knit/rows/contour_events.h"

#include <cmath>

#include "knit/model/words.h"
#include "knit/rows/row_variables.h"
#include "knit/timing/timing_variables.h"

namespace knit {

namespace {

std::string_view word_of(CountReason reason) {
  switch (reason) {
    case CountReason::ideal:
      return "ideal";
    case CountReason::as_cast_on:
      return "as cast on";
    case CountReason::at_least_three:
      return "at least three";
    case CountReason::at_most_double:
      return "at most double";
    case CountReason::at_least_half:
      return "at least half";
    case CountReason::room_ahead:
      return "room ahead";
  }
  return "";
}

}  // namespace

std::string RowsPlanned::sentence(const Telling& at) const {
  if (rows == 0) return at.row() + ": nothing is left to cut.";
  std::string text = at.row() + ": the surface goes on for " + short_number(height) +
                     "; at a stitch height of " + short_number(stitch_height) + " it is cut " +
                     plural(rows, "time", "times") + ", " + short_number(row_height) + " apart.";
  if (passed_over > 0)
    text += " " + plural(passed_over, "cut was", "cuts were") + " too short for three half stitches.";
  return text;
}
StepFields RowsPlanned::numbers() const {
  return {{var::rows, rows},
          {var::passed_over, passed_over},
          {"height", &var::surface_height, height},
          {var::row_height, row_height},
          {var::stitch_height, stitch_height}};
}

std::string CutFound::sentence(const Telling& at) const {
  return at.row() + ": at t = " + short_number(time) + " the surface is cut through " +
         plural(edges, "edge", "edges") + " of the mesh.";
}
StepFields CutFound::numbers() const {
  return {{var::level, level}, {var::time, time}, {var::edges, edges}, {var::loops, loops}};
}

std::string LoopClosed::sentence(const Telling& at) const {
  return at.row() + ": the cut closes to one loop of " + plural(points, "point", "points") +
         ", from where rounds begin.";
}
StepFields LoopClosed::numbers() const { return {{var::points, points}}; }

std::string LengthMeasured::sentence(const Telling& at) const {
  return at.row() + ": the loop is " + short_number(length) + " long, " + short_number(ideal) +
         " stitch widths of " + short_number(at.parameters.stitch.width) + ".";
}
StepFields LengthMeasured::numbers() const { return {{var::length, length}, {var::ideal, ideal}}; }

std::string CountChosen::sentence(const Telling& at) const {
  std::string head = at.row() + ": " + stitch_count_text(count);
  const std::string tail = ", each " + short_number(course) + " wide.";
  const std::string instead = ", not the " + short_number(std::round(ideal)) + " that its length holds";
  switch (reason) {
    case CountReason::ideal:
      return head + ", as many as its length holds" + tail;
    case CountReason::as_cast_on:
      return head + ", as many as shall be cast on" + tail;
    case CountReason::at_least_three:
      return head + ", because a round needs three" + tail;
    case CountReason::at_most_double:
      return head + ", twice the " + std::to_string(below) + " below" + instead + tail;
    case CountReason::at_least_half:
      return head + ", half of the " + std::to_string(below) + " below" + instead + tail;
    case CountReason::room_ahead:
      return head + instead + ", so that the rows above come nearer to what theirs hold" + tail;
  }
  return head;
}
StepFields CountChosen::numbers() const {
  return {{"stitches", &var::n, count},
          {var::ideal, ideal},
          {var::below, below},
          {var::reason, word_of(reason)},
          {var::course, course}};
}

std::string StitchPlaced::sentence(const Telling& at) const {
  return at.row() + ": stitch " + std::to_string(stitch) + " of " + std::to_string(of) + " is placed, " +
         short_number(arc) + " along the loop.";
}
StepFields StitchPlaced::numbers() const {
  return {{"stitch", &var::item, stitch}, {"of", &var::n, of}, {var::arc, arc}};
}

}  // namespace knit
