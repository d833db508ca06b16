// The stitch index by its three placements, faces and pattern.
#include "app/explain/pseudo_code_texts.h"

namespace app {

namespace {

constexpr CodeLine count_change{"{change} \xE2\x86\x90 {above} \xE2\x88\x92 {below}", "change",
                                "Stitches to add to the row below, or to take away.", "Thesis 3.2.4, step 1"};
constexpr CodeLine count_mains{"{wanted} \xE2\x86\x90 |{change}| / 2, rounded up", "wanted",
                               "Each main stitch brings two increases or decreases, one on either side.",
                               "Thesis 3.2.4, step 1: curr mains"};
constexpr CodeLine place_main{"for each {main}: {cell} \xE2\x86\x90 6", "cell",
                              "The mains are set first, at the cells that were chosen.", "Thesis 3.2.4"};
constexpr CodeLine place_after{
    "  after it: {cell} \xE2\x86\x90 M1R or SSK", "cell",
    "First a label after each main, until none is left: M1R where the row grows, SSK "
    "where it shrinks. A cell that is taken is passed over.",
    "Thesis 3.2.4; docs/algorithm.md, Stitch index"};
constexpr CodeLine place_before{
    "  before it: {cell} \xE2\x86\x90 M1L or K2tog", "cell",
    "Then a label before each main: M1L where the row grows, K2tog where it shrinks.",
    "Thesis 3.2.4; docs/algorithm.md, Stitch index"};

constexpr std::array thesis_lines{
    count_change,
    count_mains,
    CodeLine{"if cast on below: all mains (R0)", "",
             "Every old stitch is a main, with the shaping spread between them.",
             "Appendix A, row 2; docs/algorithm.md, Placement thesis"},
    CodeLine{"else if {change} = 0: as below (R1)", "", "Mains stay in their cells.",
             "Appendix A; docs/algorithm.md, Placement thesis"},
    CodeLine{
        "else if {wanted} divides {mains}: equal (R2)", "spacing",
        "The row grows and has more mains below than needed: equal sections, which may give one too many.",
        "Thesis 3.2.4, step 3; docs/algorithm.md, Placement thesis"},
    CodeLine{"else if {mains} \xE2\x89\xA5 {wanted}: follow (R3)", "spacing",
             "Mains of the row below are followed, moved by the increases before them.",
             "Thesis 3.2.4, step 3; docs/algorithm.md, Placement thesis"},
    CodeLine{"else: remainder last (R4)", "spacing",
             "Equal spacing, and what is left over goes to the last one.",
             "Thesis 3.2.4, step 4; docs/algorithm.md, Placement thesis"},
    CodeLine{
        "if no room: dense", "",
        "R2 and R3 give way to R4 and that to a main at every stitch, where labels would not find a cell.",
        "docs/algorithm.md, Placement thesis: Room"},
    place_main,
    place_after,
    place_before};

constexpr std::array even_lines{
    count_change,
    count_mains,
    CodeLine{"if {change} = 0: as below (R1)", "", "Mains stay in their cells.",
             "docs/algorithm.md, Placement even"},
    CodeLine{"else: {wanted} equal sections", "spacing",
             "Mains at sections of the smaller row that are as equal as can be.",
             "docs/algorithm.md, Placement even"},
    CodeLine{"if no room: dense", "", "A main at every stitch of the smaller row.",
             "docs/algorithm.md, Placement even"},
    place_main,
    place_after,
    place_before};

constexpr std::array nearest_lines{
    count_change,
    CodeLine{"for each matching, both in order", "",
             "Every stitch has one link or two, and links never cross.",
             "docs/algorithm.md, Placement nearest", true},
    CodeLine{"  {sum} \xE2\x86\x90 sum of |wale edge|\xC2\xB2", "sum",
             "Of all matchings the one with the least sum is found by dynamic programming.",
             "docs/algorithm.md, Placement nearest"},
    CodeLine{"for each {main} below: its {cell}", "cell", "Mains are wales, carried along the links.",
             "docs/algorithm.md, Placement nearest"},
    CodeLine{
        "for each doubled stitch: its {cell}", "cell",
        "A stitch with two links is shaping: an increase where the row grows, a decrease where it shrinks. "
        "Its label leans by the side on which the nearest main stands.",
        "docs/algorithm.md, Placement nearest"}};

constexpr std::array face_lines{
    CodeLine{"for each cell b of the larger row", "", "Round the row, the last cell with the first.",
             "docs/algorithm.md, Faces", true},
    CodeLine{"  i, j \xE2\x86\x90 links of b and of b + 1", "face",
             "The stitches of the smaller row that the two cells hang on.", "docs/algorithm.md, Faces"},
    CodeLine{"  {label} \xE2\x86\x90 label of b", "label",
             "A quad is main where its cell is; a triangle has the label of its increase or decrease.",
             "Thesis 3.2.4; docs/algorithm.md, Faces"},
    CodeLine{"  if i \xE2\x89\xA0 j: quad i, b, b+1, j", "corners", "Linked to two stitches: a quad.",
             "Thesis 3.2.4; docs/algorithm.md, Faces"},
    CodeLine{"  else: triangle i, b, b+1", "corners", "Linked to one and the same stitch: a triangle.",
             "Thesis 3.2.4; docs/algorithm.md, Faces"}};

constexpr std::array pattern_lines{
    CodeLine{"write \"cast on {produced}\"", "produced", "The first line.",
             "Thesis 3.2.5; docs/algorithm.md, Pattern"},
    CodeLine{"for each row after it", "row", "A line a row.", "Thesis 3.2.5; docs/algorithm.md, Pattern",
             true},
    CodeLine{"  read its labels, cell by cell", "consumed",
             "Plain stitches are counted together; a decrease and its partner are one word.",
             "docs/algorithm.md, Pattern"},
    CodeLine{"  write \"Rnd: ... ({produced} sts)\"", "produced",
             "The line counts for itself what it consumes and makes.", "docs/algorithm.md, Pattern"},
    CodeLine{"bind off {consumed}", "consumed", "The last line.", "docs/algorithm.md, Pattern"}};

constexpr std::array<std::string_view, 9> placing_aside{"mains",     "rule",  "spacing", "remainder", "tried",
                                                        "mains_set", "label", "partner", "placed"};
constexpr std::array<std::string_view, 8> nearest_aside{"links", "doubled", "longest", "wanted",
                                                        "mains", "label",   "partner", "placed"};
constexpr std::array<std::string_view, 1> face_aside{"of"};

constexpr PseudoCode thesis{"Stitch index by the thesis's rules", thesis_lines, placing_aside};
constexpr PseudoCode even{"Stitch index, spread evenly", even_lines, placing_aside};
constexpr PseudoCode nearest{"Stitch index by nearest stitches", nearest_lines, nearest_aside};
constexpr PseudoCode faces{"Faces between two rows", face_lines, face_aside};
constexpr PseudoCode pattern{"The written pattern", pattern_lines, {}};

}  // namespace

const PseudoCode& stitch_code(Listing listing) {
  if (listing == Listing::index_even) return even;
  if (listing == Listing::index_nearest) return nearest;
  if (listing == Listing::faces) return faces;
  return listing == Listing::pattern ? pattern : thesis;
}

}  // namespace app
