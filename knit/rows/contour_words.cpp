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

std::string TubeTaken::sentence(const Telling& at) const {
  const std::string name = "Tube " + tube_name(tube);
  if (rows == 0) return name + " is passed through without a round.";
  const std::string where = live == 0 ? " is cast on" : " is worked on " + stitch_count_text(live);
  return at.row() + ": " + name + where + ", " + plural(rows, "round", "rounds") + " of " +
         short_number(static_cast<double>(spacing)) + " over a height of " +
         short_number(static_cast<double>(height)) + ".";
}
StepFields TubeTaken::numbers() const {
  return {{var::tube, std::string_view(tube_name(tube))},
          {var::rows, rows},
          {var::below, live},
          {"height", &var::surface_height, static_cast<double>(height)},
          {var::row_height, static_cast<double>(spacing)}};
}

std::string RowsReplanned::sentence(const Telling& at) const {
  return at.row() + ": the stitch has changed to " + short_number(width) + " by " +
         short_number(stitch_height) + "; " + plural(rows, "round is", "rounds are") +
         " planned for what is left.";
}
StepFields RowsReplanned::numbers() const {
  return {{var::rows, rows}, {"width", &var::width, width}, {var::stitch_height, stitch_height}};
}

std::string CutFound::sentence(const Telling& at) const {
  return at.row() + ": tube " + tube_name(tube) + " is cut at t = " + short_number(time) + ".";
}
StepFields CutFound::numbers() const {
  return {{var::tube, std::string_view(tube_name(tube))}, {var::level, level}, {var::time, time}};
}

std::string LoopClosed::sentence(const Telling& at) const {
  return at.row() + ": the cut closes to one loop of " + plural(points, "point", "points") + ".";
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

std::string RoundBegun::sentence(const Telling& at) const {
  if (passes == 0) return at.row() + ": the round begins " + short_number(arc) + " along the loop.";
  return at.row() + ": matched to the stitches below and slid by " + short_number(slid) + ", in " +
         plural(passes, "pass", "passes") + ", the wales' squares sum to " + short_number(sum_of_squares) +
         ".";
}
StepFields RoundBegun::numbers() const {
  return {
      {var::passes, passes}, {var::arc, arc}, {var::slid, slid}, {"squares", &var::squares, sum_of_squares}};
}

std::string StitchPlaced::sentence(const Telling& at) const {
  return at.row() + ": stitch " + std::to_string(stitch) + " of " + std::to_string(of) + " is placed, " +
         short_number(arc) + " along the loop.";
}
StepFields StitchPlaced::numbers() const {
  return {{"stitch", &var::item, stitch}, {"of", &var::n, of}, {var::arc, arc}};
}

std::string GapsFound::sentence(const Telling& /*at*/) const {
  const std::string sides = std::to_string(one) + " and " + std::to_string(two) + " stitches";
  const std::string across = short_number(static_cast<double>(gap)) + " stitch widths apart";
  switch (deal) {
    case DealKind::split:
      return "At the saddle at " + vertex_text(vertex) + " the loop is cut into arcs of " + sides +
             ", the best of " + std::to_string(tried) + "; the cuts are " + across + ".";
    case DealKind::join:
      return "At the saddle at " + vertex_text(vertex) + " two loops of " + sides +
             " are opened where they are nearest, " + across + ".";
    case DealKind::ring_cast_on:
      return "Two tubes of " + sides + " start from one cast-on edge.";
    case DealKind::ring_bind_off:
      return "Two tubes of " + sides + " end edge to edge.";
  }
  return "";
}
StepFields GapsFound::numbers() const {
  return {{var::saddle, vertex},
          {"tried", &var::arcs_tried, tried},
          {var::one, one},
          {var::two, two},
          {"gap", &var::saddle_gap, static_cast<double>(gap)}};
}

std::string BridgeCastOn::sentence(const Telling& /*at*/) const {
  return "Stitch " + std::to_string(stitch) + " of " + std::to_string(of) +
         " is cast on across the gap; both sides will be worked on it.";
}
StepFields BridgeCastOn::numbers() const {
  return {{"stitch", &var::item, stitch}, {"of", &var::bridge, of}};
}

std::string LoopsDealt::sentence(const Telling& /*at*/) const {
  const std::string waits =
      held == 0 ? "." : "; " + plural(held, "loop waits on a holder.", "loops wait on holders.");
  const std::string two_loops = std::to_string(one) + " and " + std::to_string(two);
  switch (deal) {
    case DealKind::split:
      return "The loop of " + std::to_string(whole) + " is dealt into loops of " + two_loops + " stitches" +
             waits;
    case DealKind::join:
      return "The loops of " + two_loops + " become one of " + std::to_string(whole) + " stitches" + waits;
    case DealKind::ring_cast_on:
      return "The first rounds of " + two_loops + " stitches share their edge" + waits;
    case DealKind::ring_bind_off:
      return "The loops of " + two_loops + " stitches are grafted to each other" + waits;
  }
  return "";
}
StepFields LoopsDealt::numbers() const {
  return {{var::one, one},
          {var::two, two},
          {var::whole, whole},
          {var::bridge, bridge},
          {"held", &var::loops, held}};
}

}  // namespace knit
