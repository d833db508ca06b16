#include "knit/insight/narrate.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace knit {

namespace {

constexpr std::array<std::string_view, 29> kind_names{
    "ends-found",         "field-solved",       "heights-measured", "vertex-timed",    "criticals-found",
    "levels-grouped",     "cycle-found",        "stitch-cast-on",   "cycle-gathered",  "cycle-ordered",
    "candidate-measured", "band-missed",        "row-closed",       "row-resampled",   "gap-shared",
    "rows-planned",       "cut-found",          "loop-closed",      "length-measured", "count-chosen",
    "stitch-placed",      "transition-counted", "spacing-chosen",   "rows-matched",    "main-placed",
    "shaping-placed",     "face-made",          "line-written",     "stopped"};
static_assert(kind_names.size() == std::variant_size_v<Happening>);

std::string str(std::int64_t value) { return std::to_string(value); }
std::string vertex_text(VertexId vertex) { return "vertex " + std::to_string(vertex); }

std::string plural(std::int64_t count, const std::string& one, const std::string& many) {
  return str(count) + " " + (count == 1 ? one : many);
}
std::string stitches_text(std::int64_t count) { return plural(count, "stitch", "stitches"); }

std::string band_text(const Parameters& p) {
  return "[" + short_number(p.stitch_width - p.epsilon) + ", " + short_number(p.stitch_width + p.epsilon) +
         "]";
}

// One overload a kind of step. Row numbers stand in the place.
struct Sentence {
  const Place& place;
  const Parameters& p;

  [[nodiscard]] std::string row() const { return "Row " + str(place.row); }

  std::string operator()(const EndsFound& s) const {
    return "The time runs from " + vertex_text(s.start) + " (t = 0) to " + vertex_text(s.end) +
           " (t = 1), over a length of " + short_number(s.length) + ".";
  }
  std::string operator()(const FieldSolved& s) const {
    switch (s.which) {
      case FieldStep::net:
        return "The surface is laid out as a net of " + plural(s.count, "triangle", "triangles") +
               " by edge lengths, its edges flipped until all are Delaunay.";
      case FieldStep::heat:
        return "Heat put in at " + vertex_text(s.vertex) + " spreads over the surface for a short while.";
      case FieldStep::slopes:
        return "In each of " + plural(s.count, "triangle", "triangles") +
               " the slope of the heat is turned round and made 1: it points away from the start.";
      case FieldStep::distance:
        return "The distance along the surface is the function with these slopes; farthest is " +
               vertex_text(s.vertex) + ", " + short_number(s.high) + " away.";
      case FieldStep::harmonic:
        return "The harmonic field is solved for: 0 at the start, 1 at the end, and at each other vertex the "
               "weighted mean of its neighbours.";
    }
    return "";
  }
  std::string operator()(const HeightsMeasured& s) const {
    return "From start to end the surface is " + short_number(s.height) +
           " high; equal steps of time shall be equally high on it.";
  }
  std::string operator()(const CriticalsFound& s) const {
    return "The time has " + plural(s.minima, "minimum", "minima") + ", " +
           plural(s.saddles, "saddle", "saddles") + " and " + plural(s.maxima, "maximum", "maxima") + ": " +
           str(s.minima) + " - " + str(s.saddles) + " + " + str(s.maxima) + " = " +
           str(std::int64_t{s.minima} - s.saddles + s.maxima) +
           (s.minima - s.saddles + s.maxima == s.euler ? ", the" : ", but not the") +
           " Euler characteristic " + str(s.euler) + ".";
  }
  std::string operator()(const VertexTimed& s) const {
    const std::string text =
        "Vertex " + std::to_string(s.vertex) + " gets the time t = " + short_number(s.time);
    return s.clamped ? text + ", clamped: it lies beyond the chosen start or end." : text + ".";
  }
  std::string operator()(const LevelsGrouped& s) const {
    std::string text = "The vertices fall into " + plural(s.levels, "level", "levels") + " of equal time";
    if (s.split_level >= 0) {
      return text + "; from level " + str(s.split_level) + " on, a level set has " + str(s.split_loops) +
             " loops.";
    }
    return text + "; every level set is a single loop.";
  }
  std::string operator()(const CycleFound& s) const {
    std::string text = "The first cycle is level " + str(s.level) + " at t = " + short_number(s.time) + ": " +
                       plural(s.vertices, "vertex", "vertices") + ", " + short_number(s.length) + " round.";
    if (s.passed_over > 0)
      text += " " + plural(s.passed_over, "shorter level was", "shorter levels were") + " passed over.";
    return text;
  }
  std::string operator()(const StitchCastOn& s) const {
    return "Cast-on stitch " + str(s.stitch) + " of " + str(s.of) + " is placed, " + short_number(s.arc) +
           " along the first cycle.";
  }
  std::string operator()(const CycleGathered& s) const {
    return row() + ": the next cycle is level " + str(s.level) + " at t = " + short_number(s.time) +
           ", with " + plural(s.vertices, "vertex", "vertices") + ".";
  }
  std::string operator()(const CycleOrdered& s) const {
    return row() + ": the cycle is put in order " +
           (s.by == OrderedBy::angle ? "by angle about its centre" : "along the mesh's edges") + ", from " +
           vertex_text(s.first) + "; it is " + short_number(s.length) + " round.";
  }
  std::string operator()(const CandidateMeasured& s) const {
    std::string text = row() + ": " + vertex_text(s.candidate) + " is " + short_number(s.distance) +
                       " from stitch " + str(s.stitch) + " (" + vertex_text(s.anchor) + "): ";
    switch (s.verdict) {
      case Verdict::accepted:
        return text + "accepted, it lies in the band " + band_text(p) + ".";
      case Verdict::too_near:
        return text + "too near, the band begins at " + short_number(p.stitch_width - p.epsilon) + ".";
      case Verdict::too_far:
        return text + "too far, the band ends at " + short_number(p.stitch_width + p.epsilon) + ".";
    }
    return text;
  }
  std::string operator()(const BandMissed& s) const {
    std::string text = row() + ": nothing lies within " + band_text(p) + " of stitch " + str(s.stitch) +
                       " (" + vertex_text(s.anchor) + "); " + vertex_text(s.taken) + " at " +
                       short_number(s.distance) + ", nearest to the stitch width, is taken";
    if (s.skipped_distance >= 0.0) text += " rather than the one at " + short_number(s.skipped_distance);
    return text + ".";
  }
  std::string operator()(const RowClosed& s) const {
    std::string text =
        row() + " closes with " + stitches_text(s.stitches) + " and a gap of " + short_number(s.gap) + ", ";
    text += s.in_band ? "inside" : "outside";
    text += " the band " + band_text(p) + ".";
    if (s.dropped_last) text += " The last anchor, too near the first stitch, was dropped.";
    return text;
  }
  std::string operator()(const RowResampled& s) const {
    std::string text = row() + ": " + stitches_text(s.from) + " ";
    switch (s.reason) {
      case ResampleReason::too_few:
        return text + "picked on a cycle " + short_number(s.length) + " round is too few; " + str(s.to) +
               " are spread evenly instead.";
      case ResampleReason::more_than_double:
        return text + "are more than twice the " + str(s.below) + " below; " + str(s.to) +
               " are spread evenly instead.";
      case ResampleReason::less_than_half:
        return text + "are less than half of the " + str(s.below) + " below; " + str(s.to) +
               " are spread evenly instead.";
    }
    return text;
  }
  std::string operator()(const GapShared& s) const {
    const std::string head = row() + ": ";
    if (!s.shared) {
      return head + "the gap of " + short_number(s.gap_after) + " stays as it is; the row has " +
             stitches_text(s.stitches) + ".";
    }
    if (s.how == Closing::arc) {
      return head + "its " + stitches_text(s.stitches) + " are spread at equal arcs of " +
             short_number(s.per_stitch) + "; the gap goes from " + short_number(s.gap_before) + " to " +
             short_number(s.gap_after) + ".";
    }
    return head + "stitch i is shifted by i times " + short_number(s.per_stitch) +
           " along the cycle; the gap goes from " + short_number(s.gap_before) + " to " +
           short_number(s.gap_after) + ".";
  }
  std::string operator()(const RowsPlanned& s) const {
    if (s.rows == 0) return row() + ": nothing is left to cut.";
    std::string text = row() + ": the surface goes on for " + short_number(s.height) +
                       "; at a stitch height of " + short_number(s.stitch_height) + " it is cut " +
                       plural(s.rows, "time", "times") + ", " + short_number(s.row_height) + " apart.";
    if (s.passed_over > 0)
      text += " " + plural(s.passed_over, "cut was", "cuts were") + " too short for three half stitches.";
    return text;
  }
  std::string operator()(const CutFound& s) const {
    return row() + ": at t = " + short_number(s.time) + " the surface is cut through " +
           plural(s.edges, "edge", "edges") + " of the mesh.";
  }
  std::string operator()(const LoopClosed& s) const {
    return row() + ": the cut closes to one loop of " + plural(s.points, "point", "points") +
           ", from where rounds begin.";
  }
  std::string operator()(const LengthMeasured& s) const {
    return row() + ": the loop is " + short_number(s.length) + " long, " + short_number(s.ideal) +
           " stitch widths of " + short_number(p.stitch_width) + ".";
  }
  std::string operator()(const CountChosen& s) const;
  std::string operator()(const StitchPlaced& s) const {
    return row() + ": stitch " + str(s.stitch) + " of " + str(s.of) + " is placed, " + short_number(s.arc) +
           " along the loop.";
  }
  std::string operator()(const RowsMatched& s) const {
    return row() + ": " + plural(s.links, "link", "links") +
           " join the two rows with the least sum of squares, " + short_number(s.sum_of_squares) + "; " +
           stitches_text(s.doubled) + (s.doubled == 1 ? " has" : " have") + " two, and the longest link is " +
           short_number(s.longest) + ".";
  }
  std::string operator()(const TransitionCounted& s) const {
    std::string text = row() + ": from " + str(s.below) + " to " + stitches_text(s.above) + ", ";
    if (s.change == 0) return text + "nothing to shape.";
    const std::string what = s.change > 0 ? plural(s.change, "increase", "increases")
                                          : plural(-std::int64_t{s.change}, "decrease", "decreases");
    return text + what + " around " + plural(s.mains_wanted, "main stitch", "main stitches") +
           "; the row before has " + plural(s.mains_before, "main", "mains") + ".";
  }
  std::string operator()(const SpacingChosen& s) const {
    std::string text = row() + ": " + plural(s.mains, "main", "mains") + ", spaced by the rule " +
                       std::string(name_of(s.rule));
    if (s.spacing > 0)
      text += ", step " + str(s.spacing) + (s.remainder > 0 ? ", remainder " + str(s.remainder) : "");
    if (s.fell_back) text += "; " + std::string(name_of(s.tried)) + " left too little room";
    return text + ".";
  }
  std::string operator()(const MainPlaced& s) const {
    return row() + ": main stitch " + str(s.of_mains) + " goes to cell " + str(s.cell) + ".";
  }
  std::string operator()(const ShapingPlaced& s) const {
    return row() + ": " + std::string(name_of(s.label)) + " goes to cell " + str(s.cell) +
           ", working with cell " + str(s.partner) + " (" + str(s.count) + " placed).";
  }
  std::string operator()(const FaceMade& s) const {
    return row() + ": face " + str(s.index) + " of " + str(s.of) + " is a " +
           (s.corner_count == 4 ? "quad" : "triangle") + ", " + std::string(name_of(s.label)) + ".";
  }
  std::string operator()(const LineWritten& s) const {
    return "The line of row " + str(place.row) + " is written: it consumes " + stitches_text(s.consumed) +
           " and makes " + str(s.produced) + ".";
  }
  std::string operator()(const Stopped& s) const;
};

std::string Sentence::operator()(const CountChosen& s) const {
  std::string head = row() + ": " + stitches_text(s.count);
  const std::string tail = ", each " + short_number(s.course) + " wide.";
  const std::string instead = ", not the " + short_number(std::round(s.ideal)) + " that its length holds";
  switch (s.reason) {
    case CountReason::ideal:
      return head + ", as many as its length holds" + tail;
    case CountReason::as_cast_on:
      return head + ", as many as shall be cast on" + tail;
    case CountReason::at_least_three:
      return head + ", because a round needs three" + tail;
    case CountReason::at_most_double:
      return head + ", twice the " + str(s.below) + " below" + instead + tail;
    case CountReason::at_least_half:
      return head + ", half of the " + str(s.below) + " below" + instead + tail;
    case CountReason::room_ahead:
      return head + instead + ", so that the rows above come nearer to what theirs hold" + tail;
  }
  return head;
}

// Why a level set falls into several loops, and what a person may do.
std::string split_text(const std::string& where, const Stopped& s) {
  const std::string head = where + ": at level " + str(s.level) + ", t = " + short_number(s.time) +
                           ", the level set splits into " + str(s.count) + " loops, ";
  const std::string saddle =
      "the saddle at " + vertex_text(s.vertex) + " (t = " + short_number(s.value) + ")";
  const std::string why =
      s.cause == CriticalKind::saddle
          ? "because the surface parts at " + saddle
          : "because another lowest part of the shape has begun, which joins the first only at " + saddle;
  return head + why +
         ". One tube of knitting cannot follow several; choose an axis or a timing along which the shape "
         "does "
         "not branch.";
}

std::string Sentence::operator()(const Stopped& s) const {
  std::string where = place.stage == Stage::cast_on  ? "Cast on"
                      : place.stage == Stage::timing ? "Timing"
                                                     : row();
  const std::string level = "level " + str(s.level) + " at t = " + short_number(s.time);
  switch (s.reason) {
    case StopReason::no_extent:
      return "Timing: start and end lie at the same time along this axis; choose another axis or other end "
             "vertices.";
    case StopReason::no_row_levels:
      if (p.rows == RowSource::contours) {
        return "Cast on: none of " + plural(s.level, "cut", "cuts") +
               " is long enough for three half stitches; make the stitches narrower than " +
               short_number(s.value) + " or lower.";
      }
      return "Cast on: none of the " + str(s.level) +
             " levels of this mesh makes a first row between start and end; use a mesh with rings across the "
             "axis, "
             "another axis, or a stitch width below " +
             short_number(s.value) + ".";
    case StopReason::not_a_ring:
      if (s.vertex == no_vertex) {
        return where + ": the surface is pinched to a point where it is cut at t = " + short_number(s.time) +
               "; mend the mesh there, or choose another axis.";
      }
      return where + ": no closed ring can be made of the " + plural(s.count, "vertex", "vertices") + " of " +
             level + " (" + vertex_text(s.vertex) +
             "); use a mesh with rings across the axis, another axis, or a larger level tolerance.";
    case StopReason::splits:
      return split_text(where, s);
    case StopReason::stall:
      return where + ": nothing within " + band_text(p) + " of stitch " + str(s.count) + " (" +
             vertex_text(s.vertex) + "); nearest " + short_number(s.value) +
             ". Widen epsilon, change the stitch width, or continue on a stall.";
    case StopReason::changes_too_much:
      return where + ": " + stitches_text(s.count) + " cannot follow " + str(s.other) +
             "; a row may at most double or halve. Change the stitch width, or let such rows be resampled.";
    case StopReason::too_fine:
      return where + ": stitches as small as these make " +
             (s.value > 0.0 ? short_number(s.value) + " stitches" : str(s.count) + " rows") +
             ", more than the " + str(s.other) + " that can be worked; make them wider or higher.";
  }
  return where;
}

}  // namespace

std::string narrate(const Step& step, const Parameters& parameters) {
  return std::visit(Sentence{step.place, parameters}, step.what);
}

std::string_view work_ahead(const State& state) {
  if (std::holds_alternative<ContourWork>(state.work)) return "cutting the surface";
  const auto* timing = std::get_if<TimingWork>(&state.work);
  if (timing == nullptr || !timing->ends) return "working";
  if (!timing->times.empty()) return timing->criticals ? "sorting the levels" : "finding critical points";
  if (timing->field || timing->kind == TimingKind::arc_length) return "measuring heights";
  if (!timing->net) return "laying out the surface";
  if (timing->kind == TimingKind::harmonic) return "solving for the harmonic field";
  if (!timing->heat) return "spreading heat";
  return timing->slopes ? "solving for the distance" : "turning the slopes of the heat";
}

std::string_view kind_name(const Step& step) { return kind_names.at(step.what.index()); }

std::string_view name_of(Label label) {
  switch (label) {
    case Label::knit:
      return "knit";
    case Label::m1r:
      return "M1R";
    case Label::m1l:
      return "M1L";
    case Label::k2tog:
      return "K2tog";
    case Label::ssk:
      return "SSK";
    case Label::cast:
      return "cast on / off";
    case Label::main:
      return "main";
  }
  return "";
}

std::string_view name_of(Rule rule) {
  switch (rule) {
    case Rule::from_cast_on:
      return "from the cast on (R0)";
    case Rule::plain:
      return "plain (R1)";
    case Rule::equal:
      return "equal spacing (R2)";
    case Rule::follow:
      return "follow the mains (R3)";
    case Rule::remainder_last:
      return "remainder last (R4)";
    case Rule::dense:
      return "dense";
    case Rule::even:
      return "even";
    case Rule::nearest:
      return "nearest";
  }
  return "";
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

std::string short_number(double value) {
  std::array<char, 32> buffer{};
  const bool plain = value == 0.0 || (std::abs(value) >= 1e-4 && std::abs(value) < 1e6);
  const int length = std::snprintf(buffer.data(), buffer.size(), plain ? "%.4g" : "%.3e", value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

}  // namespace knit
