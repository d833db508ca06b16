#include "knit/stitches/stitch_code.h"

#include <array>

#include "knit/rows/row_variables.h"
#include "knit/stitches/faces_events.h"
#include "knit/stitches/index_events.h"
#include "knit/stitches/pattern_events.h"
#include "knit/stitches/placement.h"
#include "knit/stitches/stitch_variables.h"

namespace knit {

namespace {

bool in_rhythm(const Parameters& parameters) {
  return parameters.rhythm.counts == CountPlanning::rhythm && parameters.rows.source == RowSource::contours;
}
template <PlacementPolicy policy>
bool placed_by(const Parameters& parameters) {
  return !in_rhythm(parameters) && placement_of(parameters.stitches.placement).told_as == policy;
}

bool is_line(const AnyEvent& event) { return event.get_if<LineWritten>() != nullptr; }
bool lit_by_cast_on(const AnyEvent& event) {
  return is_line(event) && event.place.row == 1 && event.place.item == 0;
}
bool lit_by_round(const AnyEvent& event) {
  return is_line(event) && event.place.row > 1 && event.place.item == 0;
}
bool lit_by_bind_off(const AnyEvent& event) { return is_line(event) && event.place.item > 0; }

constexpr CodeLine count_change{"{} \xE2\x86\x90 {} \xE2\x88\x92 {}",
                                {&var::change, &var::above, &var::below},
                                &var::change,
                                "Stitches to add to the row below, or to take away.",
                                "Thesis 3.2.4, step 1",
                                lit_by<JoinCounted>};
constexpr CodeLine mark_turn{
    "where a short row turned: {} {}",
    {&var::cell, &var::label},
    &var::label,
    "Short rows end with a turn, and the stitch beyond is marked in the row that works it.",
    "docs/algorithm.md, Short rows",
    lit_by<TurnPlaced>};
constexpr CodeLine count_mains{"{} \xE2\x86\x90 |{}| / 2, rounded up",
                               {&var::wanted, &var::change},
                               &var::wanted,
                               "Each main stitch brings two increases or decreases, one on either side.",
                               "Thesis 3.2.4, step 1: curr mains",
                               lit_by<JoinCounted>};
constexpr CodeLine place_main{"for each {}: {} \xE2\x86\x90 6",
                              {&var::main, &var::cell},
                              &var::cell,
                              "The mains are set first, at the cells that were chosen.",
                              "Thesis 3.2.4",
                              lit_by<MainPlaced>};
constexpr CodeLine place_after{
    "  after it: {} \xE2\x86\x90 M1R or SSK",
    {&var::cell},
    &var::cell,
    "First a label after each main, until none is left: M1R where the row grows, SSK "
    "where it shrinks. A cell that is taken is passed over.",
    "Thesis 3.2.4; docs/algorithm.md, Stitch index",
    lit_if<&ShapingPlaced::label, Label::m1r, Label::ssk>};
constexpr CodeLine place_before{
    "  before it: {} \xE2\x86\x90 M1L or K2tog",
    {&var::cell},
    &var::cell,
    "Then a label before each main: M1L where the row grows, K2tog where it shrinks. Where a short row "
    "turned, its labels.",
    "Thesis 3.2.4; docs/algorithm.md, Stitch index",
    lit_or<lit_if<&ShapingPlaced::label, Label::m1l, Label::k2tog>, lit_by<TurnPlaced>>};

constexpr std::array thesis_lines{
    count_change,
    count_mains,
    CodeLine{"if cast on below: all mains (R0)",
             {},
             nullptr,
             "Every old stitch is a main, with the shaping spread between them.",
             "Appendix A, row 2; docs/algorithm.md, Placement thesis",
             lit_if<&SpacingChosen::rule, Rule::from_cast_on, Rule::plain, Rule::equal, Rule::follow,
                    Rule::remainder_last, Rule::dense>},
    CodeLine{"else if {} = 0: as below (R1)",
             {&var::change},
             nullptr,
             "Mains stay in their cells.",
             "Appendix A; docs/algorithm.md, Placement thesis",
             lit_if<&SpacingChosen::rule, Rule::plain>},
    CodeLine{
        "else if {} divides {}: equal (R2)",
        {&var::wanted, &var::mains},
        &var::spacing,
        "The row grows and has more mains below than needed: equal sections, which may give one too many.",
        "Thesis 3.2.4, step 3; docs/algorithm.md, Placement thesis",
        lit_if<&SpacingChosen::rule, Rule::equal>},
    CodeLine{"else if {} \xE2\x89\xA5 {}: follow (R3)",
             {&var::mains, &var::wanted},
             &var::spacing,
             "Mains of the row below are followed, moved by the increases before them.",
             "Thesis 3.2.4, step 3; docs/algorithm.md, Placement thesis",
             lit_if<&SpacingChosen::rule, Rule::follow>},
    CodeLine{"else: remainder last (R4)",
             {},
             &var::spacing,
             "Equal spacing, and what is left over goes to the last one.",
             "Thesis 3.2.4, step 4; docs/algorithm.md, Placement thesis",
             lit_if<&SpacingChosen::rule, Rule::remainder_last>},
    CodeLine{
        "if no room: dense",
        {},
        nullptr,
        "R2 and R3 give way to R4 and that to a main at every stitch, where labels would not find a cell.",
        "docs/algorithm.md, Placement thesis: Room",
        lit_if<&SpacingChosen::rule, Rule::dense>},
    place_main,
    place_after,
    place_before};

constexpr std::array even_lines{count_change,
                                count_mains,
                                CodeLine{"if {} = 0: as below (R1)",
                                         {&var::change},
                                         nullptr,
                                         "Mains stay in their cells.",
                                         "docs/algorithm.md, Placement even",
                                         lit_if<&SpacingChosen::rule, Rule::plain, Rule::even, Rule::dense>},
                                CodeLine{"else: {} equal sections",
                                         {&var::wanted},
                                         &var::spacing,
                                         "Mains at sections of the smaller row that are as equal as can be.",
                                         "docs/algorithm.md, Placement even",
                                         lit_if<&SpacingChosen::rule, Rule::even>},
                                CodeLine{"if no room: dense",
                                         {},
                                         nullptr,
                                         "A main at every stitch of the smaller row.",
                                         "docs/algorithm.md, Placement even",
                                         lit_if<&SpacingChosen::rule, Rule::dense>},
                                place_main,
                                place_after,
                                place_before};

constexpr std::array nearest_lines{
    count_change,
    CodeLine{"for each matching, both in order",
             {},
             nullptr,
             "Every stitch has one link or two, and links never cross.",
             "docs/algorithm.md, Placement nearest",
             never,
             true},
    CodeLine{"  {} \xE2\x86\x90 sum of |wale edge|\xC2\xB2",
             {&var::sum},
             &var::sum,
             "Of all matchings the one with the least sum is found by dynamic programming.",
             "docs/algorithm.md, Placement nearest",
             lit_by<RowsMatched>},
    CodeLine{"for each {} below: its {}",
             {&var::main, &var::cell},
             &var::cell,
             "Mains are wales, carried along the links.",
             "docs/algorithm.md, Placement nearest",
             lit_by<MainPlaced>},
    CodeLine{
        "for each doubled stitch: its {}",
        {&var::cell},
        &var::cell,
        "A stitch with two links is shaping: an increase where the row grows, a decrease where it shrinks. "
        "Its label leans by the side on which the nearest main stands.",
        "docs/algorithm.md, Placement nearest",
        lit_by<ShapingPlaced>},
    mark_turn};

constexpr std::array repeat_lines{
    count_change,
    CodeLine{"if in rhythm: {} equal sections",
             {&var::mains_set},
             &var::spacing,
             "A main begins each, and stays the same wale.",
             "docs/algorithm.md, Rhythm: Placement",
             lit_if<&SpacingChosen::rule, Rule::repeat>},
    CodeLine{
        "else: as placement has it",
        {},
        nullptr,
        "Rows that the rhythm has no counts for.",
        "docs/algorithm.md, Rhythm: Placement",
        lit_or<lit_by<RowsMatched>, lit_if<&SpacingChosen::rule, Rule::from_cast_on, Rule::plain, Rule::equal,
                                           Rule::follow, Rule::remainder_last, Rule::dense, Rule::even>>,
        true},
    place_main,
    CodeLine{"for each section: its {}",
             {&var::label},
             &var::cell,
             "At the same place in every section, as the style has it: on both sides of the mains, before "
             "the next "
             "one, in the middle, or in turn.",
             "docs/algorithm.md, Rhythm: Placement",
             lit_by<ShapingPlaced>},
    mark_turn};

constexpr std::array face_lines{
    CodeLine{"for each cell b of the larger row",
             {},
             nullptr,
             "Round the row, the last cell with the first.",
             "docs/algorithm.md, Faces",
             never,
             true},
    CodeLine{"  i, j \xE2\x86\x90 links of b and of b + 1",
             {},
             &var::face,
             "The stitches of the smaller row that the two cells hang on.",
             "docs/algorithm.md, Faces",
             lit_by<FaceMade>},
    CodeLine{"  {} \xE2\x86\x90 label of b",
             {&var::label},
             &var::label,
             "A quad is main where its cell is; a triangle has the label of its increase or decrease.",
             "Thesis 3.2.4; docs/algorithm.md, Faces",
             lit_by<FaceMade>},
    CodeLine{"  if i \xE2\x89\xA0 j: quad i, b, b+1, j",
             {},
             &var::corners,
             "Linked to two stitches: a quad.",
             "Thesis 3.2.4; docs/algorithm.md, Faces",
             lit_if<&FaceMade::corner_count, 4>},
    CodeLine{"  else: triangle i, b, b+1",
             {},
             &var::corners,
             "Linked to one and the same stitch: a triangle.",
             "Thesis 3.2.4; docs/algorithm.md, Faces",
             lit_if<&FaceMade::corner_count, 3>}};

constexpr std::array pattern_lines{
    CodeLine{"write \"cast on {}\"",
             {&var::produced},
             &var::produced,
             "The first line.",
             "Thesis 3.2.5; docs/algorithm.md, Pattern",
             lit_by_cast_on},
    CodeLine{"for each row after it",
             {},
             &var::row,
             "A line a row.",
             "Thesis 3.2.5; docs/algorithm.md, Pattern",
             never,
             true},
    CodeLine{"  read its labels, cell by cell",
             {},
             &var::consumed,
             "Plain stitches are counted together; a decrease and its partner are one word.",
             "docs/algorithm.md, Pattern",
             lit_by_round},
    CodeLine{"  write \"Rnd: ... ({} sts)\"",
             {&var::produced},
             &var::produced,
             "The line counts for itself what it consumes and makes.",
             "docs/algorithm.md, Pattern",
             lit_by_round},
    CodeLine{"bind off {}",
             {&var::consumed},
             &var::consumed,
             "The last line.",
             "docs/algorithm.md, Pattern",
             lit_by_bind_off}};

constexpr std::array placing_aside{&var::mains,     &var::rule,  &var::spacing, &var::remainder, &var::tried,
                                   &var::mains_set, &var::label, &var::partner, &var::placed};
constexpr std::array nearest_aside{&var::links, &var::doubled, &var::longest, &var::wanted,
                                   &var::mains, &var::label,   &var::partner, &var::placed};
constexpr std::array repeat_aside{&var::mains,   &var::rule,    &var::remainder, &var::tried,
                                  &var::wanted,  &var::partner, &var::placed,    &var::links,
                                  &var::doubled, &var::longest, &var::sum};
constexpr std::array face_aside{&var::of};

}  // namespace

const PseudoCode thesis_index_code{{Stage::stitches, Stage::stitches},
                                   placed_by<PlacementPolicy::thesis>,
                                   "Stitch index by the thesis's rules",
                                   thesis_lines,
                                   placing_aside};
const PseudoCode even_index_code{{Stage::stitches, Stage::stitches},
                                 placed_by<PlacementPolicy::even>,
                                 "Stitch index, spread evenly",
                                 even_lines,
                                 placing_aside};
const PseudoCode nearest_index_code{{Stage::stitches, Stage::stitches},
                                    placed_by<PlacementPolicy::nearest>,
                                    "Stitch index by nearest stitches",
                                    nearest_lines,
                                    nearest_aside};
const PseudoCode repeat_index_code{
    {Stage::stitches, Stage::stitches}, in_rhythm, "Stitch index of a rhythm", repeat_lines, repeat_aside};
const PseudoCode faces_code{
    {Stage::faces, Stage::faces}, always, "Faces between two rows", face_lines, face_aside};
const PseudoCode pattern_code{
    {Stage::pattern, Stage::done}, always, "The written pattern", pattern_lines, {}};

}  // namespace knit
