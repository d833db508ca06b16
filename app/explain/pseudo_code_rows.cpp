// Cast on and rows. Algorithm 2 keeps the order in which it is printed; its vn is vi here, because n counts
// stitches.
#include "app/explain/pseudo_code_texts.h"

namespace app {

namespace {

constexpr std::array cast_on_lines{
    CodeLine{"for each level after t = 0", "level", "Levels of equal time, from the start on.",
             "Thesis 3.2.2; docs/algorithm.md, Cast on", true},
    CodeLine{"  {cycle} \xE2\x86\x90 its vertices as a ring", "count",
             "The level's vertices in working order. Where they form no single ring the run stops.",
             "docs/algorithm.md, Rings"},
    CodeLine{"  if {length} \xE2\x89\xA5 1.5 {width}: begin here", "length",
             "The first ring with room for three half stitches; shorter ones are passed over.",
             "docs/algorithm.md, Cast on"},
    CodeLine{"{k} \xE2\x86\x90 stitches to cast on", "k", "As many as shall be cast on; 6 unless given.",
             "Thesis 3.2.2; docs/algorithm.md, Cast on"},
    CodeLine{"for {item} \xE2\x86\x90 1 ... {k}", "item", "One stitch after the other.", "Thesis 3.2.2",
             true},
    CodeLine{"  w[{item}] \xE2\x86\x90 {cycle} at {arc} = (i\xE2\x88\x92"
             "1) L/k",
             "arc", "Stitches stand at equal arcs along the ring, from its first vertex.",
             "Thesis 3.2.2; docs/algorithm.md, Cast on"}};

constexpr std::array ring_lines{
    CodeLine{"{cycle} \xE2\x86\x90 vertices at the next {time}", "time",
             "The next level: all vertices of one time.", "Thesis 3.2.3, step 2"},
    CodeLine{
        "order {cycle} round its centre", "by",
        "By angle about the centre, in working order; where that is not the order along the mesh, by its "
        "edges. Where there is no single ring the run stops.",
        "Thesis 3.2.3; docs/algorithm.md, Rings"},
    CodeLine{"{anchor} \xE2\x86\x90 {cycle}[0]", "anchor",
             "The anchor is the stitch from which the next is measured; first it is where rounds begin.",
             "Thesis 3.2.3, Algorithm 2, line 1"},
    CodeLine{"for each {candidate} of {cycle}", "candidate",
             "Each vertex of the ring in turn; printed as vn.", "Thesis 3.2.3, Algorithm 2, line 2", true},
    CodeLine{
        "  {d} \xE2\x86\x90 {metric}({anchor}, {candidate})", "d",
        "The distance from the anchor: straight through the air (euclidean), along the ring (arc) or along "
        "the surface (geodesic), as the metric says.",
        "Thesis 3.2.3, Algorithm 2, line 3"},
    CodeLine{"  if {d} \xE2\x88\x88 [{width} \xE2\x88\x92 {epsilon}, {width} + {epsilon}]", "verdict",
             "Is it a stitch's length away, within the tolerance? Both edges of the band belong to it.",
             "Thesis 3.2.3, Algorithm 2, line 4"},
    CodeLine{"    w[{stitch}] \xE2\x86\x90 {anchor}, {anchor} \xE2\x86\x90 {candidate}", "stitch",
             "The anchor is kept as a stitch, and the vertex becomes the next anchor.",
             "Thesis 3.2.3, Algorithm 2, lines 5 and 6"},
    CodeLine{"  else if {d} > {width} + {epsilon}", "verdict",
             "The ring has stepped over the band: as printed, the anchor would hardly ever move again.",
             "docs/algorithm.md, Rows: Stalls"},
    CodeLine{"    {anchor} \xE2\x86\x90 nearest to {width}, or stop", "skipped",
             "Of the vertices on either side of the band the one nearer to the stitch width is taken (at the "
             "ring's end its last vertex), or the run stops: as \"when nothing is in the band\" says.",
             "docs/algorithm.md, Rows: Stalls"},
    CodeLine{"{gap} \xE2\x86\x90 {metric}(last w, first w)", "gap",
             "The closing gap: from the last stitch to the first.", "Thesis 3.2.3, after Algorithm 2"},
    CodeLine{
        "if not {below}/2 \xE2\x89\xA4 {n} \xE2\x89\xA4 2{below}: spread", "n",
        "At most one increase a stitch and two stitches into one; a row outside, or of fewer than three, is "
        "spread evenly with a count that can be knitted.",
        "docs/algorithm.md, Rows: Counts that cannot be knitted"},
    CodeLine{
        "share {gap} among the {n} stitches", "share",
        "Thesis: stitch i is shifted by i times this much. Arc: stitches stand at equal arcs of this length. "
        "None: they stay.",
        "Thesis 3.2.3, shift dist; docs/algorithm.md, The closing gap"}};

constexpr std::array contour_lines{
    CodeLine{
        "plan cuts, one {stitch_height} apart", "rows",
        "As many rows of the stitch height as fit into the surface's height; it is cut at equal steps of "
        "time.",
        "docs/algorithm.md, Rows from contours"},
    CodeLine{"for each cut at {time}", "time", "From the start on; cuts too short make no row.",
             "docs/algorithm.md, Rows from contours", true},
    CodeLine{"  find where {time} crosses edges", "edges",
             "The cut goes through edges of the mesh, along which the time runs straight.",
             "docs/algorithm.md, Rows from contours"},
    CodeLine{"  {cycle} \xE2\x86\x90 the crossings as one loop", "points",
             "Its pieces are linked to a closed line; where there are several the run stops.",
             "docs/algorithm.md, Rows from contours"},
    CodeLine{"  {length} \xE2\x86\x90 length of {cycle}", "length", "Once round the loop.",
             "docs/algorithm.md, Rows from contours"},
    CodeLine{"  if first row: {n} \xE2\x86\x90 cast on, if given", "n", "As many as shall be cast on.",
             "docs/algorithm.md, Rows from contours: Count"},
    CodeLine{"  else {n} \xE2\x86\x90 round({length} / {width})", "n",
             "As many stitches as the length holds.", "docs/algorithm.md, Rows from contours: Count"},
    CodeLine{"    within 3, {below}/2 and 2{below}", "n",
             "At least three; at least half and at most twice the row below.",
             "docs/algorithm.md, Rows from contours: Count"},
    CodeLine{"    best over four rows together", "n",
             "A stitch more or fewer here may bring the rows above nearer to what theirs hold.",
             "docs/algorithm.md, Rows from contours: Count"},
    CodeLine{"  for {item} \xE2\x86\x90 1 ... {n}", "item", "One stitch after the other.",
             "docs/algorithm.md, Rows from contours: Stitches", true},
    CodeLine{"    w[{item}] \xE2\x86\x90 {cycle} at {arc} = (i\xE2\x88\x92"
             "1) L/n",
             "arc", "Stitches stand at equal arcs along the loop, from where rounds begin.",
             "docs/algorithm.md, Rows from contours: Stitches"}};

constexpr std::array<std::string_view, 3> cast_on_aside{"time", "last_level", "passed_over"};
constexpr std::array<std::string_view, 14> ring_aside{"order",  "below",   "count",  "length",       "level",
                                                      "metric", "in_band", "picked", "dropped_last", "reason",
                                                      "first",  "how",     "shared", "gap_after"};
constexpr std::array<std::string_view, 8> contour_aside{
    "level", "loops", "ideal", "course", "reason", "passed_over", "surface_height", "row_height"};

constexpr PseudoCode cast_on{"Cast on", cast_on_lines, cast_on_aside};
constexpr PseudoCode rings{"Algorithm 2: a row from a ring", ring_lines, ring_aside};
constexpr PseudoCode contours{"A row from a contour", contour_lines, contour_aside};

}  // namespace

const PseudoCode& rows_code(Listing listing) {
  if (listing == Listing::cast_on) return cast_on;
  return listing == Listing::rows_contours ? contours : rings;
}

}  // namespace app
