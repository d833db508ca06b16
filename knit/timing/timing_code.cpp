#include "knit/timing/timing_code.h"

#include <array>

#include "knit/timing/timing_events.h"
#include "knit/timing/timing_variables.h"

namespace knit {

namespace {

template <TimingKind kind>
bool timed_by(const Parameters& parameters) {
  return parameters.timing.kind == kind;
}

constexpr CodeLine criticals_line{
    "count min, saddles, max of t",
    {},
    &var::euler,
    "Where level sets of the time begin, part, join or end. Minima less saddles plus maxima is the surface's "
    "Euler characteristic \xCF\x87, which checks the count.",
    "docs/algorithm.md, Critical points",
    lit_by<CriticalsFound>};
constexpr CodeLine levels_line{
    "group vertices of equal {}",
    {&var::time},
    &var::levels,
    "Vertices whose times differ by less than the tolerance are one level: a cycle to knit.",
    "docs/algorithm.md, Levels",
    lit_by<LevelsGrouped>};
constexpr CodeLine for_each_vertex{"for each vertex {}",
                                   {&var::vertex},
                                   &var::vertex,
                                   "Every vertex of the mesh in turn, by its number.",
                                   "Thesis 3.2.1, Algorithm 1, line 4",
                                   never,
                                   true};
constexpr CodeLine lay_out_net{"net \xE2\x86\x90 triangles by edge lengths",
                               {},
                               &var::net,
                               "The surface is laid out by its edge lengths alone, and edges are flipped "
                               "until all are Delaunay, so that "
                               "what is solved on it has no false peaks.",
                               "docs/algorithm.md, Other timings: Distance",
                               lit_if<&FieldSolved::which, FieldStep::net>};
constexpr CodeLine measure_height{"{} \xE2\x86\x90 height along the surface",
                                  {&var::height},
                                  &var::height,
                                  "Between two level sets lies a band; its area over the mean length of its "
                                  "edges is its height. Summed from "
                                  "the start this says how high each level set lies on the surface.",
                                  "docs/algorithm.md, Other timings: Heights",
                                  lit_by<HeightsMeasured>};

constexpr std::array choice_lines{
    CodeLine{"{} \xE2\x86\x90 share of the area across the axis",
             {&var::flat},
             &var::flat,
             "Where the surface lies within 3 degrees of square to the axis no row of linear time comes.",
             "docs/algorithm.md, Which timing",
             lit_by<TimingChosen>},
    CodeLine{"{} \xE2\x86\x90 CV of 1/slope along levels",
             {&var::unevenness},
             &var::unevenness,
             "Rows lie farther apart where the surface leans; within a row that stretches wales.",
             "docs/algorithm.md, Which timing",
             lit_by<TimingChosen>},
    CodeLine{"if {} > 2% or {} > 18%: geodesic",
             {&var::flat, &var::unevenness},
             nullptr,
             "The distance along the surface climbs everywhere alike.",
             "docs/algorithm.md, Which timing",
             lit_by<TimingChosen>},
    CodeLine{"else: linear",
             {},
             nullptr,
             "Else the axis says it best, as in the thesis.",
             "docs/algorithm.md, Which timing",
             lit_if<&TimingChosen::timing, TimingKind::linear>}};

constexpr std::array linear_lines{
    CodeLine{
        "{} \xE2\x86\x90 {} \xE2\x88\x92 {}",
        {&var::direction, &var::end, &var::start},
        &var::direction,
        "The line from the start to the end of the knitting. Without picked vertices these are the extreme "
        "ones along the axis, and d is the axis.",
        "Thesis 3.2.1, Algorithm 1, line 1",
        lit_or<lit_by<EndsFound>, lit_by_stop<StopReason::no_extent, StopReason::open_edge>>},
    CodeLine{"{} \xE2\x86\x90 |{}|",
             {&var::mag, &var::direction},
             &var::mag,
             "Its length. Where it is nothing, start and end lie at the same time and the run stops.",
             "Thesis 3.2.1, Algorithm 1, line 2",
             lit_or<lit_by<EndsFound>, lit_by_stop<StopReason::no_extent, StopReason::open_edge>>},
    CodeLine{"t({}) \xE2\x86\x90 0, t({}) \xE2\x86\x90 1",
             {&var::start, &var::end},
             nullptr,
             "The ends have their times exactly, whatever rounding says.",
             "Thesis 3.2.1, Algorithm 1, line 3",
             lit_by<EndsFound>},
    for_each_vertex,
    CodeLine{"  if {} \xE2\x89\xA0 {}",
             {&var::vertex, &var::start},
             nullptr,
             "The start has its time already.",
             "Thesis 3.2.1, Algorithm 1, line 5",
             lit_by<VertexTimed>,
             true},
    CodeLine{"    {} \xE2\x86\x90 {} \xE2\x88\x92 {}",
             {&var::diff, &var::vertex, &var::start},
             &var::diff,
             "The way from the start to the vertex.",
             "Thesis 3.2.1, Algorithm 1, line 6",
             lit_by<VertexTimed>},
    CodeLine{"    {} \xE2\x86\x90 ({} \xC2\xB7 {}) / {}\xC2\xB2",
             {&var::time, &var::diff, &var::direction, &var::mag},
             &var::time,
             "How far along d the vertex stands: 0 at the start, 1 at the end.",
             "Thesis 3.2.1, Algorithm 1, line 7",
             lit_by<VertexTimed>},
    CodeLine{"    clamp {} to [0, 1]",
             {&var::time},
             &var::clamped,
             "A vertex beyond a picked start or end gets that one's time; such vertices are counted.",
             "docs/algorithm.md, Timing: Ends",
             lit_if<&VertexTimed::clamped, true>},
    criticals_line,
    levels_line};

constexpr std::array arc_length_lines{
    CodeLine{
        "{} \xE2\x86\x90 {} \xE2\x88\x92 {}",
        {&var::direction, &var::end, &var::start},
        &var::mag,
        "The line from the start to the end of the knitting; level sets are the same as for linear timing.",
        "Thesis 3.2.1, Algorithm 1, lines 1 to 3",
        lit_or<lit_by<EndsFound>, lit_by_stop<StopReason::no_extent, StopReason::open_edge>>},
    CodeLine{"u(v) \xE2\x86\x90 place of v along {}",
             {&var::direction},
             &var::bands,
             "What Algorithm 1 gives as the time is here only the order in which vertices come.",
             "Thesis 3.2.1, Algorithm 1, line 7",
             lit_by<HeightsMeasured>},
    measure_height,
    for_each_vertex,
    CodeLine{"  clamp u({}) to [0, 1]",
             {&var::vertex},
             &var::clamped,
             "A vertex beyond a picked start or end counts as that one.",
             "docs/algorithm.md, Timing: Ends",
             lit_if<&VertexTimed::clamped, true>},
    CodeLine{"  {} \xE2\x86\x90 height of u({}) / {}",
             {&var::time, &var::vertex, &var::height},
             &var::time,
             "Equal steps of time are equally high on the surface.",
             "docs/algorithm.md, Other timings",
             lit_by<VertexTimed>},
    criticals_line,
    levels_line};

constexpr std::array geodesic_lines{
    CodeLine{
        "{}, {} \xE2\x86\x90 the ends",
        {&var::start, &var::end},
        &var::mag,
        "Extreme vertices along the axis, or those picked. Without a picked end the farthest vertex becomes "
        "the end once distances are known.",
        "docs/algorithm.md, Timing: Ends",
        lit_or<lit_by<EndsFound>, lit_by_stop<StopReason::no_extent, StopReason::open_edge>>},
    lay_out_net,
    CodeLine{"heat spreads from {}",
             {&var::start},
             &var::unknowns,
             "Heat put in at the start spreads over the surface for a short while: one linear system.",
             "docs/algorithm.md, Other timings: Distance",
             lit_if<&FieldSolved::which, FieldStep::heat>},
    CodeLine{
        "X \xE2\x86\x90 slopes of heat, turned, made 1",
        {},
        &var::slopes,
        "In each triangle the heat falls away from the start; turned round and made 1 its slope is that of "
        "the distance.",
        "docs/algorithm.md, Other timings: Distance",
        lit_if<&FieldSolved::which, FieldStep::slopes>},
    CodeLine{"solve for {} with the slopes X",
             {&var::far},
             &var::far,
             "The distance along the surface is the function that has these slopes: a second linear system.",
             "docs/algorithm.md, Other timings: Distance",
             lit_if<&FieldSolved::which, FieldStep::distance>},
    for_each_vertex,
    CodeLine{"  {} \xE2\x86\x90 \xCF\x86({}) / {}",
             {&var::time, &var::vertex, &var::far},
             &var::time,
             "The vertex's distance from the start over that of the end.",
             "docs/algorithm.md, Other timings",
             lit_by<VertexTimed>},
    CodeLine{"  clamp {} to [0, 1]",
             {&var::time},
             &var::clamped,
             "A vertex farther away than a picked end gets its time.",
             "docs/algorithm.md, Timing: Ends",
             lit_if<&VertexTimed::clamped, true>},
    criticals_line,
    levels_line};

constexpr std::array harmonic_lines{
    CodeLine{"{}, {} \xE2\x86\x90 the ends",
             {&var::start, &var::end},
             &var::mag,
             "Extreme vertices along the axis, or those picked.",
             "docs/algorithm.md, Timing: Ends",
             lit_or<lit_by<EndsFound>, lit_by_stop<StopReason::no_extent, StopReason::open_edge>>},
    lay_out_net,
    CodeLine{
        "solve \xCE\x94u = 0, u({}) = 0, u({}) = 1",
        {&var::start, &var::end},
        &var::unknowns,
        "The harmonic field: each vertex has the weighted mean of its neighbours, so nothing but the ends is "
        "extreme.",
        "docs/algorithm.md, Other timings",
        lit_if<&FieldSolved::which, FieldStep::harmonic>},
    measure_height,
    for_each_vertex,
    CodeLine{
        "  {} \xE2\x86\x90 height of u({}) / {}",
        {&var::time, &var::vertex, &var::height},
        &var::time,
        "Re-timed by height, because near a single vertex the field rises like a logarithm and rows would "
        "crowd there.",
        "docs/algorithm.md, Other timings: Why harmonic is re-timed",
        lit_by<VertexTimed>},
    criticals_line,
    levels_line};

constexpr std::array choice_aside{&var::timing_kind, &var::worst};
constexpr std::array levels_aside{&var::minima,  &var::saddles,     &var::maxima,     &var::tolerance,
                                  &var::outside, &var::split_level, &var::split_loops};

constexpr std::array harmonic_aside{&var::clamped, &var::bands,       &var::minima,
                                    &var::saddles, &var::maxima,      &var::tolerance,
                                    &var::outside, &var::split_level, &var::split_loops};

}  // namespace

const PseudoCode timing_choice_code{{Stage::timing, Stage::timing},
                                    timed_by<TimingKind::by_itself>,
                                    "Choosing the timing",
                                    choice_lines,
                                    choice_aside};
const PseudoCode linear_code{{Stage::timing, Stage::timing},
                             timed_by<TimingKind::linear>,
                             "Algorithm 1: linear timing",
                             linear_lines,
                             levels_aside};
const PseudoCode arc_length_code{{Stage::timing, Stage::timing},
                                 timed_by<TimingKind::arc_length>,
                                 "Timing by arc length",
                                 arc_length_lines,
                                 levels_aside};
const PseudoCode geodesic_code{{Stage::timing, Stage::timing},
                               timed_by<TimingKind::geodesic>,
                               "Geodesic timing",
                               geodesic_lines,
                               levels_aside};
const PseudoCode harmonic_code{{Stage::timing, Stage::timing},
                               timed_by<TimingKind::harmonic>,
                               "Harmonic timing",
                               harmonic_lines,
                               harmonic_aside};

}  // namespace knit
