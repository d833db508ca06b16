#include "knit/rows/row_code.h"

#include <array>

#include "knit/rows/cast_on_events.h"
#include "knit/rows/choice.h"
#include "knit/rows/contour_events.h"
#include "knit/rows/ring_events.h"
#include "knit/rows/row_variables.h"
#include "knit/timing/timing_variables.h"

namespace knit {

namespace {

template <RowSource source>
bool made_from(const Parameters& parameters) {
  return parameters.rows.source == source;
}

constexpr std::array choice_lines{
    CodeLine{"if every level is a ring: rings",
             {},
             nullptr,
             "Algorithm 2 walks the mesh's own vertices, where they lie in rings from end to end.",
             "docs/algorithm.md, Rings or contours",
             lit_if<&RowsChosen::source, RowSource::rings>},
    CodeLine{"else: contours",
             {},
             nullptr,
             "Cuts through the surface follow any shape, tube by tube.",
             "docs/algorithm.md, Rings or contours",
             lit_if<&RowsChosen::source, RowSource::contours>}};

constexpr std::array choice_aside{&var::rows_from, &var::level, &var::count, &var::without_ring};

constexpr std::array cast_on_lines{
    CodeLine{"for each level after t = 0",
             {},
             &var::level,
             "Levels of equal time, from the start on.",
             "Thesis 3.2.2; docs/algorithm.md, Cast on",
             never,
             true},
    CodeLine{"  {} \xE2\x86\x90 its vertices as a ring",
             {&var::cycle},
             &var::count,
             "The level's vertices in working order. Where they form no single ring the run stops.",
             "docs/algorithm.md, Rings",
             lit_or<lit_by<CycleFound>,
                    lit_by_stop<StopReason::no_row_levels, StopReason::not_a_ring, StopReason::splits>>},
    CodeLine{"  if {} \xE2\x89\xA5 1.5 {}: begin here",
             {&var::length, &var::width},
             &var::length,
             "The first ring with room for three half stitches; shorter ones are passed over.",
             "docs/algorithm.md, Cast on",
             lit_or<lit_by<CycleFound>, lit_by_stop<StopReason::no_row_levels>>},
    CodeLine{"{} \xE2\x86\x90 stitches to cast on",
             {&var::k},
             &var::k,
             "As many as shall be cast on; 6 unless given.",
             "Thesis 3.2.2; docs/algorithm.md, Cast on",
             lit_if<&StitchCastOn::stitch, 1>},
    CodeLine{"for {} \xE2\x86\x90 1 ... {}",
             {&var::item, &var::k},
             &var::item,
             "One stitch after the other.",
             "Thesis 3.2.2",
             never,
             true},
    CodeLine{"  w[{}] \xE2\x86\x90 {} at {} = (i\xE2\x88\x92"
             "1) L/k",
             {&var::item, &var::cycle, &var::arc},
             &var::arc,
             "Stitches stand at equal arcs along the ring, from its first vertex.",
             "Thesis 3.2.2; docs/algorithm.md, Cast on",
             lit_by<StitchCastOn>}};

constexpr std::array ring_lines{
    CodeLine{"{} \xE2\x86\x90 vertices at the next {}",
             {&var::cycle, &var::time},
             &var::time,
             "The next level: all vertices of one time.",
             "Thesis 3.2.3, step 2",
             lit_by<CycleGathered>},
    CodeLine{
        "order {} round its centre",
        {&var::cycle},
        &var::by,
        "By angle about the centre, in working order; where that is not the order along the mesh, by its "
        "edges. Where there is no single ring the run stops.",
        "Thesis 3.2.3; docs/algorithm.md, Rings",
        lit_or<lit_by<CycleOrdered>, lit_by_stop<StopReason::not_a_ring, StopReason::splits>>},
    CodeLine{"{} \xE2\x86\x90 {}[0]",
             {&var::anchor, &var::cycle},
             &var::anchor,
             "The anchor is the stitch from which the next is measured; first it is where rounds begin.",
             "Thesis 3.2.3, Algorithm 2, line 1",
             lit_by<CycleOrdered>},
    CodeLine{"for each {} of {}",
             {&var::candidate, &var::cycle},
             &var::candidate,
             "Each vertex of the ring in turn; printed as vn.",
             "Thesis 3.2.3, Algorithm 2, line 2",
             never,
             true},
    CodeLine{
        "  {} \xE2\x86\x90 {}({}, {})",
        {&var::d, &var::metric, &var::anchor, &var::candidate},
        &var::d,
        "The distance from the anchor: straight through the air (euclidean), along the ring (arc) or along "
        "the surface (geodesic), as the metric says.",
        "Thesis 3.2.3, Algorithm 2, line 3",
        lit_by<CandidateMeasured>},
    CodeLine{"  if {} \xE2\x88\x88 [{} \xE2\x88\x92 {}, {} + {}]",
             {&var::d, &var::width, &var::epsilon, &var::width, &var::epsilon},
             &var::verdict,
             "Is it a stitch's length away, within the tolerance? Both edges of the band belong to it.",
             "Thesis 3.2.3, Algorithm 2, line 4",
             lit_by<CandidateMeasured>},
    CodeLine{"    w[{}] \xE2\x86\x90 {}, {} \xE2\x86\x90 {}",
             {&var::stitch, &var::anchor, &var::anchor, &var::candidate},
             &var::stitch,
             "The anchor is kept as a stitch, and the vertex becomes the next anchor.",
             "Thesis 3.2.3, Algorithm 2, lines 5 and 6",
             lit_if<&CandidateMeasured::verdict, Verdict::accepted>},
    CodeLine{"  else if {} > {} + {}",
             {&var::d, &var::width, &var::epsilon},
             &var::verdict,
             "The ring has stepped over the band: as printed, the anchor would hardly ever move again.",
             "docs/algorithm.md, Rows: Stalls",
             lit_if<&CandidateMeasured::verdict, Verdict::too_far>},
    CodeLine{"    {} \xE2\x86\x90 nearest to {}, or stop",
             {&var::anchor, &var::width},
             &var::skipped,
             "Of the vertices on either side of the band the one nearer to the stitch width is taken (at the "
             "ring's end its last vertex), or the run stops: as \"On a stall\" says.",
             "docs/algorithm.md, Rows: Stalls",
             lit_or<lit_by<BandMissed>, lit_by_stop<StopReason::stall>>},
    CodeLine{"{} \xE2\x86\x90 {}(last w, first w)",
             {&var::gap, &var::metric},
             &var::gap,
             "The closing gap: from the last stitch to the first.",
             "Thesis 3.2.3, after Algorithm 2",
             lit_by<RowClosed>},
    CodeLine{
        "if not {}/2 \xE2\x89\xA4 {} \xE2\x89\xA4 2{}: spread",
        {&var::below, &var::n, &var::below},
        &var::n,
        "At most one increase a stitch and two stitches into one; a row outside, or of fewer than three, is "
        "spread evenly with a count that can be knitted.",
        "docs/algorithm.md, Rows: Counts that cannot be knitted",
        lit_or<lit_by<RowResampled>, lit_by_stop<StopReason::changes_too_much>>},
    CodeLine{
        "share {} among the {} stitches",
        {&var::gap, &var::n},
        &var::share,
        "Thesis: stitch i is shifted by i times this much. Arc: stitches stand at equal arcs of this length. "
        "None: they stay.",
        "Thesis 3.2.3, shift dist; docs/algorithm.md, The closing gap",
        lit_by<GapShared>}};

constexpr std::array contour_lines{
    CodeLine{"for each tube, in working order",
             {},
             &var::tube,
             "A tube comes after those that it grows out of; of the orders tried the one that costs a "
             "knitter least.",
             "docs/algorithm.md, Order",
             lit_by<TubeTaken>,
             true},
    CodeLine{"  if rhythm: plan {} of all its curves",
             {&var::n},
             &var::rhythms,
             "Counts that come in few and regular rhythms, multiples of M, as near to L / w as the tolerance "
             "asks: "
             "a dynamic programme over rows and counts.",
             "docs/algorithm.md, Rhythm",
             lit_by<RhythmPlanned>},
    CodeLine{"  for each of its curves",
             {},
             &var::time,
             "Rows lie at equal heights along the tube, each tube's own; curves too short make no row.",
             "docs/algorithm.md, Rows from contours",
             lit_or<lit_by<RowsReplanned>, lit_by<CutFound>, lit_by<LoopClosed>>},
    CodeLine{"    {} \xE2\x86\x90 length of {}",
             {&var::length, &var::cycle},
             &var::length,
             "Once round the loop.",
             "docs/algorithm.md, Rows from contours",
             lit_by<LengthMeasured>},
    CodeLine{"    if cast on or rhythm says: {} \xE2\x86\x90 that",
             {&var::n},
             &var::n,
             "As many as shall be cast on, in the first row; as many as the rhythm has planned.",
             "docs/algorithm.md, Rows from contours: Count",
             lit_if<&CountChosen::reason, CountReason::as_cast_on, CountReason::rhythm_change,
                    CountReason::rhythm_rest, CountReason::rhythm_begins>},
    CodeLine{
        "    else {} \xE2\x86\x90 round({} / {})",
        {&var::n, &var::length, &var::width},
        &var::n,
        "As many stitches as the length holds: at least three, at least half and at most twice what they are "
        "worked on, and as four rows together come nearest to theirs.",
        "docs/algorithm.md, Rows from contours: Count",
        lit_if<&CountChosen::reason, CountReason::ideal, CountReason::at_least_three,
               CountReason::at_most_double, CountReason::at_least_half, CountReason::room_ahead,
               CountReason::undone>},
    CodeLine{
        "      if undone in 8 rounds: {} \xE2\x86\x90 what lasts",
        {&var::n},
        &var::n,
        "No increase that a decrease undoes within eight rounds, nor the other way round, where counts at "
        "most 3.5 % off allow that; else the shape wins.",
        "docs/algorithm.md, Rows from contours: Lasting",
        lit_if<&CountChosen::reason, CountReason::would_be_undone, CountReason::undone>},
    CodeLine{"    begin where wales are shortest",
             {},
             &var::squares,
             "The round is matched to the live stitches at every turn, slid by its mean offset and matched "
             "again; it "
             "begins on the first live stitch.",
             "docs/algorithm.md, Rows from contours: Beginning",
             lit_by<RoundBegun>},
    CodeLine{"    w[{}] \xE2\x86\x90 {} at {} = (i\xE2\x88\x92"
             "1) L/n",
             {&var::item, &var::cycle, &var::arc},
             &var::arc,
             "Stitches stand at equal arcs along the loop, from where the round begins.",
             "docs/algorithm.md, Rows from contours: Stitches",
             lit_by<StitchPlaced>},
    CodeLine{
        "  if its loops can be dealt: find gaps",
        {},
        &var::saddle_gap,
        "A split gives each child one arc, the cheapest way; a join opens each loop nearest to the saddle.",
        "docs/algorithm.md, Splits and joins",
        lit_by<GapsFound>},
    CodeLine{"    cast on {} across {}",
             {&var::bridge, &var::saddle},
             &var::bridge,
             "As many stitches as the gap is wide, less one; both sides are worked on them.",
             "docs/algorithm.md, Splits and joins",
             lit_by<BridgeCastOn>},
    CodeLine{"    deal the loops",
             {},
             &var::loops,
             "One loop becomes two, or two become one; nothing is knitted.",
             "docs/algorithm.md, Splits and joins",
             lit_by<LoopsDealt>}};

constexpr std::array cast_on_aside{&var::time, &var::last_level, &var::passed_over};
constexpr std::array ring_aside{&var::order,  &var::below,   &var::count,  &var::length,       &var::level,
                                &var::metric, &var::in_band, &var::picked, &var::dropped_last, &var::reason,
                                &var::first,  &var::how,     &var::shared, &var::gap_after};
constexpr std::array contour_aside{
    &var::dealt_from, &var::dealt_to,       &var::laid_aside,       &var::level,
    &var::points,     &var::ideal,          &var::course,           &var::reason,
    &var::rows,       &var::surface_height, &var::row_height,       &var::passes,
    &var::slid,       &var::below,          &var::arcs_tried,       &var::one,
    &var::two,        &var::whole,          &var::stitch_height,    &var::changes,
    &var::sections,   &var::style,          &var::shaping_rounds,   &var::seen,
    &var::most_off,   &var::score,          &var::within_tolerance, &var::has_rhythm};

// Only its own step shows it.
bool never_chosen(const Parameters& /*parameters*/) { return false; }

}  // namespace

const PseudoCode rows_choice_code{
    {Stage::timing, Stage::timing}, never_chosen, "Choosing rings or contours", choice_lines, choice_aside};
const PseudoCode cast_on_code{
    {Stage::cast_on, Stage::cast_on}, made_from<RowSource::rings>, "Cast on", cast_on_lines, cast_on_aside};
const PseudoCode ring_code{{Stage::rows, Stage::rows},
                           made_from<RowSource::rings>,
                           "Algorithm 2: a row from a ring",
                           ring_lines,
                           ring_aside};
const PseudoCode contour_code{{Stage::rows, Stage::cast_on},
                              made_from<RowSource::contours>,
                              "A row from a contour",
                              contour_lines,
                              contour_aside};

}  // namespace knit
