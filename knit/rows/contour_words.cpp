#include "knit/rows/contour_events.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "knit/model/measured.h"
#include "knit/model/words.h"
#include "knit/rows/lasting_counts.h"
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
    case CountReason::would_be_undone:
      return "would be undone";
    case CountReason::undone:
      return "undone";
    case CountReason::rhythm_change:
      return "rhythm: change";
    case CountReason::rhythm_rest:
      return "rhythm: rest";
    case CountReason::rhythm_begins:
      return "rhythm: begins";
  }
  return "";
}

// Of a tube that has no round, and the same at the end of a run as anywhere else.
std::string rowless_sentence(const std::string& tube, Rowless why) {
  switch (why) {
    case Rowless::cast_on_edge:
      return tube + " has no round: it is the edge that two tubes start from, back to back.";
    case Rowless::grafted:
      return tube + " has no round: it is the edge at which two tubes are grafted to each other.";
    case Rowless::no:
    case Rowless::dealt_on:
      break;
  }
  return tube + " is lower than a round: its stitches are only dealt on.";
}

std::string two_names(const DealTubes& tubes) {
  return tube_name(tubes.one) + " and " + tube_name(tubes.two);
}

std::string two_counts(std::int32_t one, std::int32_t two) {
  return std::to_string(one) + " and " + stitch_count_text(two);
}

// In tenths, rounded up: "3.1 %".
std::string at_most_percent(double percent) {
  return short_number(std::ceil(10.0 * percent - 1e-6) / 10.0) + " %";
}

// "", or with a comma before it.
std::string waiting_words(std::int32_t held) {
  return held == 0 ? "" : "; " + plural(held, "loop waits on a holder", "loops wait on holders");
}

// The tubes that a deal takes from, and those that it gives to.
StepFields tubes_of(DealKind deal, const DealTubes& tubes) {
  const std::string pair = two_names(tubes);
  const std::string whole = tubes.whole < 0 ? "none" : tube_name(tubes.whole);
  const bool parts = deal == DealKind::split;
  return {
      {"from", &var::dealt_from, std::string_view(parts || deal == DealKind::ring_cast_on ? whole : pair)},
      {"to", &var::dealt_to, std::string_view(parts || deal == DealKind::ring_cast_on ? pair : whole)}};
}

}  // namespace

std::string TubeTaken::sentence(const Telling& at) const {
  const std::string name = "Tube " + tube_name(tube);
  if (rows == 0) {
    const std::string also = aside < 0 ? "" : " Tube " + tube_name(aside) + " is laid on a holder.";
    return rowless_sentence(name, rowless) + also;
  }
  std::string text = at.row() + ": ";
  if (aside >= 0) text += "tube " + tube_name(aside) + " is laid on a holder, and ";
  text += (aside >= 0 ? "tube " : "Tube ") + tube_name(tube);
  text += live == 0 ? " is cast on" : " is worked on " + stitch_count_text(live);
  text += ", " + plural(rows, "round", "rounds");
  if (rows > 1) text += " of " + short_number(static_cast<double>(spacing));
  text += " over a height of " + short_number(static_cast<double>(height));
  const bool is_said = aside >= 0 && held == 1;
  return text + (is_said ? "" : waiting_words(held)) + ".";
}
StepFields TubeTaken::numbers() const {
  return {{var::tube, std::string_view(tube_name(tube))},
          {var::rows, rows},
          {var::below, live},
          {"height", &var::surface_height, static_cast<double>(height)},
          {var::row_height, static_cast<double>(spacing)},
          {"held", &var::loops, held},
          {"aside", &var::laid_aside, std::string_view(aside < 0 ? "none" : tube_name(aside))}};
}

std::string RowsReplanned::sentence(const Telling& at) const {
  return at.row() + ": the stitch has changed to " + short_number(width) + " by " +
         short_number(stitch_height) + "; " + plural(rows, "round is", "rounds are") +
         " planned for what is left.";
}
StepFields RowsReplanned::numbers() const {
  return {{var::rows, rows}, {"width", &var::width, width}, {var::stitch_height, stitch_height}};
}

std::string RhythmPlanned::sentence(const Telling& at) const {
  const std::string name = "Tube " + tube_name(tube);
  if (none == NoRhythm::few_rows)
    return name +
           " has no rhythm, as it is worked on live stitches and has only a few rounds; its counts are "
           "near those that its rows hold, each round one repeat where it can be.";
  if (none == NoRhythm::fits_none)
    return name +
           " has no rhythm: no number of sections goes with the stitches and changes that were asked "
           "for; its counts are near those that its rows hold.";
  const std::string seen = at_most_percent(static_cast<double>(std::max(local, belt)));
  if (shaping == 0)
    return name + " is knitted plain, " + plural(rounds, "round", "rounds") +
           "; the circumference is never seen more than " + seen + " off.";
  const std::string planned = name + " is planned whole: " + plural(rhythms, "rhythm", "rhythms") + ", " +
                              std::to_string(shaping) + " of " + plural(rounds, "round", "rounds") +
                              " shape, each by " + std::to_string(changes) + " at most " +
                              (apart ? "beside mains at the back, the sides and the front, as front and back "
                                       "halves differ"
                                     : "in " + plural(sections, "equal section", "equal sections"));
  if (within) return planned + "; the circumference is never seen more than " + seen + " off.";
  return planned + ". No rhythm stays within " + short_number(at.parameters.rhythm.tolerance) +
         " %: this one is off by " + seen + " at row " + std::to_string(row) +
         ". Smaller stitches, or a higher tolerance, leave more to choose from.";
}
StepFields RhythmPlanned::numbers() const {
  return {{var::tube, std::string_view(tube_name(tube))},
          {var::changes, changes},
          {var::sections, sections},
          {var::style, rhythm_style_names[static_cast<std::size_t>(style)]},
          {var::rhythms, rhythms},
          {"shaping", &var::shaping_rounds, shaping},
          {"rounds", &var::rows, rounds},
          {var::seen, static_cast<double>(std::max(local, belt))},
          {var::most_off, row},
          {var::score, static_cast<double>(score)},
          {"within", &var::within_tolerance, within},
          {"rhythm", &var::has_rhythm, none == NoRhythm::no}};
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
  return at.row() + ": the loop is " + short_number(length) + " long, " +
         measured(ideal, "stitch width", "stitch widths") + " of " +
         short_number(at.parameters.stitch.width) + ".";
}
StepFields LengthMeasured::numbers() const { return {{var::length, length}, {var::ideal, ideal}}; }

std::string CountChosen::sentence(const Telling& at) const {
  std::string head = at.row() + ": " + stitch_count_text(count);
  const std::string tail = ", each " + short_number(course) + " wide.";
  const std::string instead = ", not the " + short_number(std::round(ideal)) + " that its length holds";
  const std::string rounds = std::to_string(lasting_rounds) + " rounds";
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
    case CountReason::would_be_undone:
      return head + instead + ", so that no change is undone within " + rounds + tail;
    case CountReason::undone:
      return head + ", as many as its length holds, although that is undone within " + rounds +
             ": any that lasts would be seen to be off" + tail;
    case CountReason::rhythm_change:
      if (below == 0) return head + ", with which its rhythm begins" + tail;
      return head + ", " + std::to_string(std::abs(count - below)) + (count > below ? " more" : " fewer") +
             " than below, as its rhythm has it; its length holds " + short_number(ideal) + tail;
    case CountReason::rhythm_rest:
      return head + ", as below, where its rhythm rests; its length holds " + short_number(ideal) + tail;
    case CountReason::rhythm_begins:
      return head + ", with which its rhythm can begin on the " + std::to_string(below) +
             " below; its length holds " + short_number(ideal) + tail;
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
  const std::string pair = two_names(tubes);
  const std::string at_saddle = " at the saddle at " + vertex_text(vertex);
  const std::string across =
      measured(static_cast<double>(gap), "stitch width apart", "stitch widths apart") + ".";
  switch (deal) {
    case DealKind::split:
      return "Tube " + tube_name(tubes.whole) + " parts into " + pair + at_saddle +
             ": the loop is cut into arcs of " + two_counts(one, two) + ", the best of " +
             std::to_string(tried) + " tried; the cuts are " + across;
    case DealKind::join:
      return "Tubes " + pair + " meet and go on as " + tube_name(tubes.whole) + at_saddle +
             ": their loops of " + two_counts(one, two) + " are opened where they are nearest, " + across;
    case DealKind::ring_cast_on:
      return "Tubes " + pair + ", of " + two_counts(one, two) + ", start from one cast-on edge.";
    case DealKind::ring_bind_off:
      return "Tubes " + pair + ", of " + two_counts(one, two) + ", end edge to edge.";
  }
  return "";
}
StepFields GapsFound::numbers() const {
  StepFields fields = tubes_of(deal, tubes);
  fields.insert(fields.end(), {{var::saddle, vertex},
                               {"tried", &var::arcs_tried, tried},
                               {var::one, one},
                               {var::two, two},
                               {"gap", &var::saddle_gap, static_cast<double>(gap)}});
  return fields;
}

std::string BridgeCastOn::sentence(const Telling& /*at*/) const {
  return "Stitch " + std::to_string(stitch) + " of " + std::to_string(of) +
         " is cast on across the gap; both sides will be worked on it.";
}
StepFields BridgeCastOn::numbers() const {
  return {{"stitch", &var::item, stitch}, {"of", &var::bridge, of}};
}

std::string LoopsDealt::sentence(const Telling& /*at*/) const {
  const std::string waits = waiting_words(held) + ".";
  const std::string name_one = tube_name(tubes.one), name_two = tube_name(tubes.two);
  switch (deal) {
    case DealKind::split:
      return "Tube " + tube_name(tubes.whole) + "'s loop of " + stitch_count_text(whole) +
             " is dealt into one of " + std::to_string(one) + " for " + name_one + " and one of " +
             std::to_string(two) + " for " + name_two + waits;
    case DealKind::join:
      return "The loops of tubes " + two_names(tubes) + ", of " + two_counts(one, two) + ", become one of " +
             stitch_count_text(whole) + " for tube " + tube_name(tubes.whole) + waits;
    case DealKind::ring_cast_on:
      return "The first rounds of tubes " + two_names(tubes) + ", of " + two_counts(one, two) +
             ", share their edge" + waits;
    case DealKind::ring_bind_off:
      return "The loops of tubes " + two_names(tubes) + ", of " + two_counts(one, two) +
             ", are grafted to each other" + waits;
  }
  return "";
}
StepFields LoopsDealt::numbers() const {
  StepFields fields = tubes_of(deal, tubes);
  fields.insert(fields.end(), {{var::one, one},
                               {var::two, two},
                               {var::whole, whole},
                               {var::bridge, bridge},
                               {"held", &var::loops, held}});
  return fields;
}

}  // namespace knit
