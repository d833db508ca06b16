// Stage timing, in its four ways. Algorithm 1 keeps the order in which it is printed.
#include "app/explain/pseudo_code_texts.h"

namespace app {

namespace {

constexpr CodeLine find_criticals{
    "count min, saddles, max of t", "euler",
    "Where level sets of the time begin, part, join or end. Minima less saddles plus maxima is the surface's "
    "Euler characteristic \xCF\x87, which checks the count.",
    "docs/algorithm.md, Critical points"};
constexpr CodeLine group_levels{
    "group vertices of equal {time}", "levels",
    "Vertices whose times differ by less than the tolerance are one level: a cycle to knit.",
    "docs/algorithm.md, Levels"};
constexpr CodeLine for_each_vertex{"for each vertex {vertex}", "vertex",
                                   "Every vertex of the mesh in turn, by its number.",
                                   "Thesis 3.2.1, Algorithm 1, line 4", true};
constexpr CodeLine lay_out_net{"net \xE2\x86\x90 triangles by edge lengths", "net",
                               "The surface is laid out by its edge lengths alone, and edges are flipped "
                               "until all are Delaunay, so that "
                               "what is solved on it has no false peaks.",
                               "docs/algorithm.md, Other timings: Distance"};
constexpr CodeLine measure_height{"{height} \xE2\x86\x90 height along the surface", "height",
                                  "Between two level sets lies a band; its area over the mean length of its "
                                  "edges is its height. Summed from "
                                  "the start this says how high each level set lies on the surface.",
                                  "docs/algorithm.md, Other timings: Heights"};

constexpr std::array linear_lines{
    CodeLine{
        "{direction} \xE2\x86\x90 {end} \xE2\x88\x92 {start}", "direction",
        "The line from the start to the end of the knitting. Without picked vertices these are the extreme "
        "ones along the axis, and d is the axis.",
        "Thesis 3.2.1, Algorithm 1, line 1"},
    CodeLine{"{mag} \xE2\x86\x90 |{direction}|", "mag",
             "Its length. Where it is nothing, start and end lie at the same time and the run stops.",
             "Thesis 3.2.1, Algorithm 1, line 2"},
    CodeLine{"t({start}) \xE2\x86\x90 0, t({end}) \xE2\x86\x90 1", "",
             "The ends have their times exactly, whatever rounding says.",
             "Thesis 3.2.1, Algorithm 1, line 3"},
    for_each_vertex,
    CodeLine{"  if {vertex} \xE2\x89\xA0 {start}", "", "The start has its time already.",
             "Thesis 3.2.1, Algorithm 1, line 5", true},
    CodeLine{"    {diff} \xE2\x86\x90 {vertex} \xE2\x88\x92 {start}", "diff",
             "The way from the start to the vertex.", "Thesis 3.2.1, Algorithm 1, line 6"},
    CodeLine{"    {time} \xE2\x86\x90 ({diff} \xC2\xB7 {direction}) / {mag}\xC2\xB2", "time",
             "How far along d the vertex stands: 0 at the start, 1 at the end.",
             "Thesis 3.2.1, Algorithm 1, line 7"},
    CodeLine{"    clamp {time} to [0, 1]", "clamped",
             "A vertex beyond a picked start or end gets that one's time; such vertices are counted.",
             "docs/algorithm.md, Timing: Ends"},
    find_criticals,
    group_levels};

constexpr std::array arc_length_lines{
    CodeLine{
        "{direction} \xE2\x86\x90 {end} \xE2\x88\x92 {start}", "mag",
        "The line from the start to the end of the knitting; level sets are the same as for linear timing.",
        "Thesis 3.2.1, Algorithm 1, lines 1 to 3"},
    CodeLine{"u(v) \xE2\x86\x90 place of v along {direction}", "bands",
             "What Algorithm 1 gives as the time is here only the order in which vertices come.",
             "Thesis 3.2.1, Algorithm 1, line 7"},
    measure_height,
    for_each_vertex,
    CodeLine{"  clamp u({vertex}) to [0, 1]", "clamped",
             "A vertex beyond a picked start or end counts as that one.", "docs/algorithm.md, Timing: Ends"},
    CodeLine{"  {time} \xE2\x86\x90 height of u({vertex}) / {height}", "time",
             "Equal steps of time are equally high on the surface.", "docs/algorithm.md, Other timings"},
    find_criticals,
    group_levels};

constexpr std::array geodesic_lines{
    CodeLine{
        "{start}, {end} \xE2\x86\x90 the ends", "mag",
        "Extreme vertices along the axis, or those picked. Without a picked end the farthest vertex becomes "
        "the end once distances are known.",
        "docs/algorithm.md, Timing: Ends"},
    lay_out_net,
    CodeLine{"heat spreads from {start}", "unknowns",
             "Heat put in at the start spreads over the surface for a short while: one linear system.",
             "docs/algorithm.md, Other timings: Distance"},
    CodeLine{
        "X \xE2\x86\x90 slopes of heat, turned, made 1", "slopes",
        "In each triangle the heat falls away from the start; turned round and made 1 its slope is that of "
        "the distance.",
        "docs/algorithm.md, Other timings: Distance"},
    CodeLine{"solve for {far} with the slopes X", "far",
             "The distance along the surface is the function that has these slopes: a second linear system.",
             "docs/algorithm.md, Other timings: Distance"},
    for_each_vertex,
    CodeLine{"  {time} \xE2\x86\x90 \xCF\x86({vertex}) / {far}", "time",
             "The vertex's distance from the start over that of the end.",
             "docs/algorithm.md, Other timings"},
    CodeLine{"  clamp {time} to [0, 1]", "clamped", "A vertex farther away than a picked end gets its time.",
             "docs/algorithm.md, Timing: Ends"},
    find_criticals,
    group_levels};

constexpr std::array harmonic_lines{
    CodeLine{"{start}, {end} \xE2\x86\x90 the ends", "mag",
             "Extreme vertices along the axis, or those picked.", "docs/algorithm.md, Timing: Ends"},
    lay_out_net,
    CodeLine{
        "solve \xCE\x94u = 0, u({start}) = 0, u({end}) = 1", "unknowns",
        "The harmonic field: each vertex has the weighted mean of its neighbours, so nothing but the ends is "
        "extreme.",
        "docs/algorithm.md, Other timings"},
    measure_height,
    for_each_vertex,
    CodeLine{
        "  {time} \xE2\x86\x90 height of u({vertex}) / {height}", "time",
        "Re-timed by height, because near a single vertex the field rises like a logarithm and rows would "
        "crowd there.",
        "docs/algorithm.md, Other timings: Why harmonic is re-timed"},
    find_criticals,
    group_levels};

constexpr std::array<std::string_view, 7> levels_aside{"minima",  "saddles",     "maxima",     "tolerance",
                                                       "outside", "split_level", "split_loops"};

constexpr std::array<std::string_view, 9> harmonic_aside{
    "clamped", "bands", "minima", "saddles", "maxima", "tolerance", "outside", "split_level", "split_loops"};

constexpr PseudoCode linear{"Algorithm 1: linear timing", linear_lines, levels_aside};
constexpr PseudoCode arc_length{"Timing by arc length", arc_length_lines, levels_aside};
constexpr PseudoCode geodesic{"Geodesic timing", geodesic_lines, levels_aside};
constexpr PseudoCode harmonic{"Harmonic timing", harmonic_lines, harmonic_aside};

}  // namespace

const PseudoCode& timing_code(Listing listing) {
  if (listing == Listing::timing_arc_length) return arc_length;
  if (listing == Listing::timing_geodesic) return geodesic;
  return listing == Listing::timing_harmonic ? harmonic : linear;
}

}  // namespace app
