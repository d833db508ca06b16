#include "knit/insight/step_fields.h"

#include "knit/insight/narrate.h"

namespace knit {

namespace {

using Fields = std::vector<StepField>;

StepField count(std::string_view name, std::int64_t value) { return {name, value}; }
StepField number(std::string_view name, double value) { return {name, value}; }
StepField yes_no(std::string_view name, bool value) { return {name, value}; }
StepField word(std::string_view name, std::string_view value) { return {name, std::string(value)}; }

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

std::string_view word_of(StopReason reason) {
  switch (reason) {
    case StopReason::no_extent:
      return "no extent";
    case StopReason::no_row_levels:
      return "no row levels";
    case StopReason::not_a_ring:
      return "not a ring";
    case StopReason::splits:
      return "splits";
    case StopReason::stall:
      return "stall";
    case StopReason::changes_too_much:
      return "changes too much";
    case StopReason::too_fine:
      return "too fine";
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

std::string_view word_of(FieldStep step) {
  switch (step) {
    case FieldStep::net:
      return "net";
    case FieldStep::heat:
      return "heat";
    case FieldStep::slopes:
      return "slopes";
    case FieldStep::distance:
      return "distance";
    case FieldStep::harmonic:
      return "harmonic";
  }
  return "";
}

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

struct Lister {
  Fields operator()(const EndsFound& s) const {
    return {count("start", s.start), count("end", s.end), number("length", s.length)};
  }
  Fields operator()(const VertexTimed& s) const {
    return {count("vertex", s.vertex), number("time", s.time), yes_no("clamped", s.clamped)};
  }
  Fields operator()(const FieldSolved& s) const {
    return {word("what", word_of(s.which)), count("vertex", s.vertex), count("count", s.count),
            number("high", s.high)};
  }
  Fields operator()(const HeightsMeasured& s) const {
    return {number("height", s.height), count("bands", s.bands)};
  }
  Fields operator()(const CriticalsFound& s) const {
    return {count("minima", s.minima), count("saddles", s.saddles), count("maxima", s.maxima),
            count("euler", s.euler)};
  }
  Fields operator()(const LevelsGrouped& s) const {
    return {count("levels", s.levels), number("tolerance", s.tolerance), count("outside", s.outside),
            count("split_level", s.split_level), count("split_loops", s.split_loops)};
  }
  Fields operator()(const CycleFound& s) const {
    return {count("level", s.level), count("last_level", s.last_level), count("passed_over", s.passed_over),
            number("time", s.time),  count("vertices", s.vertices),     number("length", s.length)};
  }
  Fields operator()(const StitchCastOn& s) const {
    return {count("stitch", s.stitch), count("of", s.of), number("arc", s.arc)};
  }
  Fields operator()(const CycleGathered& s) const {
    return {count("level", s.level), number("time", s.time), count("vertices", s.vertices)};
  }
  Fields operator()(const CycleOrdered& s) const {
    return {count("first", s.first), word("by", s.by == OrderedBy::angle ? "angle" : "edges"),
            count("vertices", s.vertices), number("length", s.length)};
  }
  Fields operator()(const CandidateMeasured& s) const {
    return {count("stitch", s.stitch),       count("anchor", s.anchor),
            count("candidate", s.candidate), count("order", s.candidate_order),
            number("distance", s.distance),  word("verdict", name_of(s.verdict))};
  }
  Fields operator()(const BandMissed& s) const {
    Fields fields{count("stitch", s.stitch), count("anchor", s.anchor), count("taken", s.taken),
                  count("order", s.taken_order), number("distance", s.distance)};
    if (s.skipped_distance >= 0.0) fields.push_back(number("skipped_distance", s.skipped_distance));
    return fields;
  }
  Fields operator()(const RowClosed& s) const {
    return {count("stitches", s.stitches), number("gap", s.gap), yes_no("in_band", s.in_band),
            yes_no("dropped_last", s.dropped_last)};
  }
  Fields operator()(const RowResampled& s) const {
    return {count("picked", s.from), count("stitches", s.to), count("below", s.below),
            word("reason", word_of(s.reason)), number("length", s.length)};
  }
  Fields operator()(const GapShared& s) const {
    return {count("stitches", s.stitches),      word("how", word_of(s.how)),
            yes_no("shared", s.shared),         number("per_stitch", s.per_stitch),
            number("gap_before", s.gap_before), number("gap_after", s.gap_after)};
  }
  Fields operator()(const RowsPlanned& s) const {
    return {count("rows", s.rows), count("passed_over", s.passed_over), number("height", s.height),
            number("row_height", s.row_height), number("stitch_height", s.stitch_height)};
  }
  Fields operator()(const CutFound& s) const {
    return {count("level", s.level), number("time", s.time), count("edges", s.edges),
            count("loops", s.loops)};
  }
  Fields operator()(const LoopClosed& s) const { return {count("points", s.points)}; }
  Fields operator()(const LengthMeasured& s) const {
    return {number("length", s.length), number("ideal", s.ideal)};
  }
  Fields operator()(const CountChosen& s) const {
    return {count("stitches", s.count), number("ideal", s.ideal), count("below", s.below),
            word("reason", word_of(s.reason)), number("course", s.course)};
  }
  Fields operator()(const StitchPlaced& s) const {
    return {count("stitch", s.stitch), count("of", s.of), number("arc", s.arc)};
  }
  Fields operator()(const RowsMatched& s) const {
    return {count("links", s.links), count("doubled", s.doubled), number("sum_of_squares", s.sum_of_squares),
            number("longest", s.longest)};
  }
  Fields operator()(const TransitionCounted& s) const {
    return {count("below", s.below), count("above", s.above), count("change", s.change),
            count("mains_wanted", s.mains_wanted), count("mains_before", s.mains_before)};
  }
  Fields operator()(const SpacingChosen& s) const {
    Fields fields{word("rule", name_of(s.rule)), count("mains", s.mains), count("spacing", s.spacing),
                  count("remainder", s.remainder)};
    if (s.fell_back) fields.push_back(word("tried", name_of(s.tried)));
    return fields;
  }
  Fields operator()(const MainPlaced& s) const { return {count("cell", s.cell), count("main", s.of_mains)}; }
  Fields operator()(const ShapingPlaced& s) const {
    return {word("label", name_of(s.label)), count("cell", s.cell), count("partner", s.partner),
            count("placed", s.count)};
  }
  Fields operator()(const FaceMade& s) const {
    return {count("face", s.index), count("of", s.of), count("corners", s.corner_count),
            word("label", name_of(s.label))};
  }
  Fields operator()(const LineWritten& s) const {
    return {count("consumed", s.consumed), count("produced", s.produced)};
  }
  Fields operator()(const Stopped& s) const {
    return {word("reason", word_of(s.reason)), count("level", s.level), count("count", s.count),
            number("value", s.value),          number("time", s.time),  count("other", s.other),
            count("vertex", s.vertex)};
  }
};

}  // namespace

std::vector<StepField> fields_of(const Step& step) { return std::visit(Lister{}, step.what); }

}  // namespace knit
