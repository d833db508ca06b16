#include "knit/rows/ring_events.h"

#include "knit/model/words.h"
#include "knit/rows/row_variables.h"
#include "knit/rows/rows.h"
#include "knit/rows/stop_words.h"
#include "knit/timing/timing_variables.h"

namespace knit {

namespace {

std::string_view word_of(ResampleReason reason) {
  switch (reason) {
    case ResampleReason::too_few:
      return "too few";
    case ResampleReason::more_than_double:
      return "more than double";
    case ResampleReason::less_than_half:
      return "less than half";
  }
  return "";
}

std::string_view word_of(Closing closing) {
  switch (closing) {
    case Closing::none:
      return "none";
    case Closing::thesis:
      return "thesis";
    case Closing::arc:
      return "arc";
  }
  return "";
}

}  // namespace

std::string CycleGathered::sentence(const Telling& at) const {
  return at.row() + ": the next cycle is level " + std::to_string(level) + " at t = " + short_number(time) +
         ", with " + plural(vertices, "vertex", "vertices") + ".";
}
StepFields CycleGathered::numbers() const {
  return {{var::level, level}, {var::time, time}, {"vertices", &var::count, vertices}};
}

std::string CycleOrdered::sentence(const Telling& at) const {
  return at.row() + ": the cycle is put in order " +
         (by == OrderedBy::angle ? "by angle about its centre" : "along the mesh's edges") + ", from " +
         vertex_text(first) + "; it is " + short_number(length) + " round.";
}
StepFields CycleOrdered::numbers() const {
  return {{var::first, first},
          {var::by, by == OrderedBy::angle ? "angle" : "edges"},
          {"vertices", &var::count, vertices},
          {var::length, length}};
}

std::string CandidateMeasured::sentence(const Telling& at) const {
  std::string text = at.row() + ": " + vertex_text(candidate) + " is " + short_number(distance) +
                     " from stitch " + std::to_string(stitch) + " (" + vertex_text(anchor) + "): ";
  switch (verdict) {
    case Verdict::accepted:
      return text + "accepted, it lies in the band " + band_text(at.parameters) + ".";
    case Verdict::too_near:
      return text + "too near, the band begins at " +
             short_number(band_of(at.parameters.rows, at.parameters.stitch).low) + ".";
    case Verdict::too_far:
      return text + "too far, the band ends at " +
             short_number(band_of(at.parameters.rows, at.parameters.stitch).high) + ".";
  }
  return text;
}
StepFields CandidateMeasured::numbers() const {
  return {{var::stitch, stitch},         {var::anchor, anchor},           {var::candidate, candidate},
          {var::order, candidate_order}, {"distance", &var::d, distance}, {var::verdict, name_of(verdict)}};
}

std::string BandMissed::sentence(const Telling& at) const {
  std::string text = at.row() + ": nothing lies within " + band_text(at.parameters) + " of stitch " +
                     std::to_string(stitch) + " (" + vertex_text(anchor) + "); " + vertex_text(taken) +
                     " at " + short_number(distance) + ", nearest to the stitch width, is taken";
  if (skipped_distance >= 0.0) text += " rather than the one at " + short_number(skipped_distance);
  return text + ".";
}
StepFields BandMissed::numbers() const {
  StepFields fields{{var::stitch, stitch},
                    {var::anchor, anchor},
                    {"taken", &var::candidate, taken},
                    {var::order, taken_order},
                    {"distance", &var::d, distance}};
  if (skipped_distance >= 0.0) fields.emplace_back("skipped_distance", &var::skipped, skipped_distance);
  return fields;
}

std::string RowClosed::sentence(const Telling& at) const {
  std::string text =
      at.row() + " closes with " + stitch_count_text(stitches) + " and a gap of " + short_number(gap) + ", ";
  text += in_band ? "inside" : "outside";
  text += " the band " + band_text(at.parameters) + ".";
  if (dropped_last) text += " The last anchor, too near the first stitch, was dropped.";
  return text;
}
StepFields RowClosed::numbers() const {
  return {{"stitches", &var::n, stitches},
          {var::gap, gap},
          {var::in_band, in_band},
          {var::dropped_last, dropped_last}};
}

std::string RowResampled::sentence(const Telling& at) const {
  std::string text = at.row() + ": " + stitch_count_text(from) + " ";
  switch (reason) {
    case ResampleReason::too_few:
      return text + "picked on a cycle " + short_number(length) + " round is too few; " + std::to_string(to) +
             " are spread evenly instead.";
    case ResampleReason::more_than_double:
      return text + "are more than twice the " + std::to_string(below) + " below; " + std::to_string(to) +
             " are spread evenly instead.";
    case ResampleReason::less_than_half:
      return text + "are less than half of the " + std::to_string(below) + " below; " + std::to_string(to) +
             " are spread evenly instead.";
  }
  return text;
}
StepFields RowResampled::numbers() const {
  return {{var::picked, from},
          {"stitches", &var::n, to},
          {var::below, below},
          {var::reason, word_of(reason)},
          {var::length, length}};
}

std::string GapShared::sentence(const Telling& at) const {
  const std::string head = at.row() + ": ";
  if (!shared) {
    return head + "the gap of " + short_number(gap_after) + " stays as it is; the row has " +
           stitch_count_text(stitches) + ".";
  }
  if (how == Closing::arc) {
    return head + "its " + stitch_count_text(stitches) + " are spread at equal arcs of " +
           short_number(per_stitch) + "; the gap goes from " + short_number(gap_before) + " to " +
           short_number(gap_after) + ".";
  }
  return head + "stitch i is shifted by i times " + short_number(per_stitch) +
         " along the cycle; the gap goes from " + short_number(gap_before) + " to " +
         short_number(gap_after) + ".";
}
StepFields GapShared::numbers() const {
  return {{"stitches", &var::n, stitches},
          {var::how, word_of(how)},
          {var::shared, shared},
          {"per_stitch", &var::share, per_stitch},
          {"gap_before", &var::gap, gap_before},
          {var::gap_after, gap_after}};
}

bool GapShared::unusual(const Parameters& parameters) const {
  const Band band = band_of(parameters.rows, parameters.stitch);
  // A row spread evenly instead was reported by the step that spread it.
  return !shared && !resampled && (gap_after < band.low || gap_after > band.high);
}

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::too_near:
      return "too near";
    case Verdict::accepted:
      return "accepted";
    case Verdict::too_far:
      return "too far";
  }
  return "";
}

}  // namespace knit
