// The terms themselves: to add one, put it where the alphabet has it. Tests look after links and doubles.
#include "app/explain/glossary.h"

#include <algorithm>
#include <array>
#include <string>

namespace app {

namespace {

constexpr std::array terms{
    Term{
        "anchor", "anchor vertex",
        "The stitch that the next one is measured from. When a candidate is accepted, it becomes the anchor.",
        "candidate, band, stitch", "docs/algorithm.md, Rows; the thesis, 3.2.3"},
    Term{"arc length", "arc, arc-length",
         "How long the way is along a curve, not straight through the air. Stitches at equal arcs of a ring "
         "have "
         "equally long ways between them.",
         "ring, geodesic distance, metric", "docs/algorithm.md, The closing gap"},
    Term{"axis", "direction of knitting",
         "The direction in which the piece is knitted. The time rises along it, from the start to the end.",
         "time, start and end", "docs/algorithm.md, Timing"},
    Term{"band", "",
         "The distances that are right for the next stitch: from w - \xCE\xB5 to w + \xCE\xB5. What is "
         "nearer is "
         "too near, what is farther is too far.",
         "epsilon, stitch width, verdict, stall", "docs/algorithm.md, Rows; the thesis, 3.2.3"},
    Term{"bind off", "cast off, binding off, casting off, cast on / off",
         "To close the last row, so that no loop can slip back. It is the last line of a pattern.",
         "cast on, pattern", "docs/algorithm.md, Pattern; the thesis, 2.1.2"},
    Term{"break condition", "break",
         "What a run is stopped at, such as the first stall or row 14. Playing stops there, and keys lead to "
         "the "
         "next and the one before.",
         "stall, step", "docs/time-travel.md"},
    Term{"candidate", "",
         "A vertex of the ring that may become the next stitch. Each in turn is measured from the anchor, "
         "and the "
         "first one within the band is taken.",
         "anchor, ring, verdict", "docs/algorithm.md, Rows; the thesis, 3.2.3"},
    Term{"cast on", "casting on, cast-on",
         "To make the first row of stitches on the needle. Here these stitches stand at equal arcs of the "
         "first "
         "ring. Their label is 5.",
         "bind off, row, label", "docs/algorithm.md, Cast on; the thesis, 2.1.2"},
    Term{"cell", "",
         "A place in the list that says how one row becomes the next. There is one for each stitch of the "
         "larger of "
         "the two rows, counted from 1, and each gets a label.",
         "label, link, strip", "docs/algorithm.md, Stitch index"},
    Term{"coefficient of variation", "CV",
         "How uneven lengths are: their standard deviation divided by their mean. 0 means that all are "
         "equal, 0.1 "
         "that they usually differ from the mean by a tenth.",
         "course, wale, percentile", "docs/algorithm.md, What cures the distorted quads"},
    Term{"contour", "",
         "The closed line where the surface is cut at one time. Rows can be made from contours instead of "
         "the mesh's "
         "own rings; their stitches then stand at equal arcs.",
         "level set, ring, arc length", "docs/algorithm.md, Rows from contours"},
    Term{"cotangent Laplacian", "Laplacian, Laplace equation",
         "A table of weights that tells how each vertex hangs together with its neighbours, made from the "
         "angles of "
         "the triangles. Distances along the surface and smooth times are solved for with it.",
         "harmonic, heat method, Delaunay", "docs/algorithm.md, Other timings"},
    Term{"course", "row edge",
         "A line of stitches side by side, along a row. How long a stitch is along it is its course length, "
         "which "
         "should be the stitch width.",
         "wale, row, stitch width", "docs/algorithm.md, What cures the distorted quads; the thesis, 1.1"},
    Term{"critical point", "",
         "A place where the level sets of the time change: they begin at a minimum, part or join at a saddle "
         "and end "
         "at a maximum.",
         "minimum, saddle, maximum, Morse function",
         "docs/algorithm.md, Critical points, and where one tube ends"},
    Term{"decrease", "",
         "Two stitches knitted as one, so that the row gets smaller by one. K2tog leans to the right, SSK to "
         "the left.",
         "K2tog, SSK, increase, shaping", "docs/algorithm.md, Stitch index; the thesis, 2.1.4"},
    Term{"Delaunay", "Delaunay triangulation, intrinsic Delaunay triangulation",
         "Triangles chosen so that they are as plump as can be. Edges are flipped, on the surface, until no "
         "triangle "
         "is needlessly thin; then what is solved for on them has no false peaks.",
         "cotangent Laplacian, triangle", "docs/algorithm.md, Other timings"},
    Term{"epsilon", "\xCE\xB5, eps",
         "Half the width of the band: how far a stitch may be from the stitch width w. The first vertex in "
         "the band is "
         "taken, so \xCE\xB5 sets how long stitches become: about w - \xCE\xB5.",
         "band, stitch width, stall", "docs/algorithm.md, Rows; the thesis, 3.2.3"},
    Term{"Euler characteristic", "",
         "Vertices less edges plus faces: 2 for whatever can be blown up to a ball, 0 for a ring such as the "
         "torus. "
         "Minima less saddles plus maxima must give the same number.",
         "critical point, saddle", "docs/algorithm.md, Critical points, and where one tube ends"},
    Term{"face", "",
         "A flat piece of a mesh between its edges. Each face of the knit mesh is one stitch to knit: a "
         "quad, or a "
         "triangle where there is shaping.",
         "quad, triangle, strip", "docs/algorithm.md, Faces"},
    Term{"gap", "closing gap",
         "The distance from the last stitch of a row to its first. Where it is not within the band, the row "
         "closes "
         "badly, and the gap is distributed among the stitches.",
         "band, resampling, row", "docs/algorithm.md, The closing gap; the thesis, 3.2.3"},
    Term{"gauge", "swatch",
         "How many stitches and rounds a knitter gets in 10 cm, counted on a small sample, the swatch. It "
         "turns lengths "
         "of the mesh into stitches.",
         "stitch width, stitch height", "docs/algorithm.md, Stitch size"},
    Term{"geodesic distance", "geodesic",
         "The length of the shortest way on the surface, as an ant would walk. Straight through the air is "
         "the "
         "Euclidean distance.",
         "metric, heat method, arc length", "docs/algorithm.md, Other timings; the thesis, 4.1"},
    Term{"half-edge", "",
         "One side of an edge, as one of the two triangles beside it sees it. By half-edges a program walks "
         "round "
         "faces and vertices.",
         "vertex, triangle", ""},
    Term{"harmonic", "harmonic field",
         "As smooth as can be: at each vertex the value is the weighted mean of its neighbours. A harmonic "
         "time has no "
         "peaks but its start and its end.",
         "cotangent Laplacian, time", "docs/algorithm.md, Other timings"},
    Term{"heat method", "heat",
         "A way to find distances along a surface: heat is put in at the start, and the way that it spreads "
         "tells in "
         "which direction the start lies.",
         "geodesic distance, cotangent Laplacian", "docs/algorithm.md, Other timings"},
    Term{"increase", "",
         "A new stitch made between two, so that the row gets larger by one. M1R leans to the right, M1L to "
         "the left.",
         "M1R, M1L, decrease, shaping", "docs/algorithm.md, Stitch index; the thesis, 2.1.3"},
    Term{"isoline", "",
         "A line on the surface along which the time is the same; the view draws some of them.",
         "level set, time", "docs/algorithm.md, Timing"},
    Term{"K2tog", "knit two together, knit 2 together",
         "Two stitches knitted together, the farther one on top: a decrease that leans to the right. Its "
         "label is 3.",
         "SSK, decrease, label", "the thesis, 2.1.4"},
    Term{"knit", "knit stitch",
         "The plain stitch: a loop pulled to the front through the loop below it. Its label is 0.",
         "stitch, label", "the thesis, 2.1.1"},
    Term{"label", "",
         "What is to be done at a place of a row, as a number: 0 knit, 1 M1R, 2 M1L, 3 K2tog, 4 SSK, 5 cast "
         "on or off, "
         "6 main stitch.",
         "cell, main stitch, shaping", "docs/algorithm.md, Stitch index; the thesis, 3.2.4"},
    Term{"level", "",
         "Vertices of the mesh that have the same time. Each level between the start and the end is a ring "
         "to pick "
         "stitches from.",
         "ring, time, level set", "docs/algorithm.md, Levels"},
    Term{"level set", "",
         "All places of the surface that have one time: one closed line, or several where the shape parts. "
         "One tube of "
         "knitting can follow one only.",
         "isoline, contour, saddle, tube", "docs/algorithm.md, Critical points, and where one tube ends"},
    Term{"link", "partner, column edge",
         "Which stitch of the row below a stitch is knitted into. A label works together with the stitch "
         "beside it, its "
         "partner: they share a stitch below or above.",
         "wale, cell, shaping", "docs/algorithm.md, Partners and links"},
    Term{"M1L", "make one left, make 1 left",
         "Make one left: an increase, made from the yarn between two stitches, that leans to the left. Its "
         "label is 2.",
         "M1R, increase, label", "the thesis, 2.1.3"},
    Term{"M1R", "make one right, make 1 right",
         "Make one right: an increase, made from the yarn between two stitches, that leans to the right. Its "
         "label is 1.",
         "M1L, increase, label", "the thesis, 2.1.3"},
    Term{"main line", "increase line, decrease line",
         "The line that main stitches make when they stand above each other, row after row. Increases and "
         "decreases on "
         "both sides of it look like a seam.",
         "main stitch, wale", "the thesis, 3.2.4"},
    Term{"main stitch", "main, mains",
         "A plain stitch with shaping on both sides of it: one increase or decrease before, one after. Its "
         "label is 6.",
         "main line, shaping, label, rule", "docs/algorithm.md, Stitch index; the thesis, 3.2.4"},
    Term{"maximum", "maxima", "A place where the time is higher than all around it: a level set ends there.",
         "critical point, minimum, saddle", "docs/algorithm.md, Critical points, and where one tube ends"},
    Term{"metric", "Euclidean, Euclidean distance",
         "The ruler that distances are measured with: straight through the air (Euclidean, as in the "
         "thesis), along the "
         "ring, or the shortest way on the surface.",
         "geodesic distance, arc length", "docs/algorithm.md, Rows; the thesis, 3.2.3"},
    Term{"minimum", "minima", "A place where the time is lower than all around it: a level set begins there.",
         "critical point, maximum, saddle", "docs/algorithm.md, Critical points, and where one tube ends"},
    Term{"Morse function", "",
         "A number for each place of a surface that changes smoothly and has only simple peaks, pits and "
         "saddles. Here it "
         "is the time, and its level sets become the rows.",
         "time, level set, critical point, Reeb graph",
         "docs/algorithm.md, Timing; the thesis, 2.4 and 3.2.1"},
    Term{"pattern", "",
         "The instructions in words, round by round, with the number of stitches after each. It is the last "
         "stage.",
         "round, label", "docs/pattern.md; docs/algorithm.md, Pattern; the thesis, 3.2.5"},
    Term{"percentile", "95th percentile, p95",
         "The value that so many per cent of all are below. At the 95th percentile, only one in twenty is "
         "larger.",
         "coefficient of variation", ""},
    Term{"placement", "",
         "Where main stitches and shaping go within a row. The thesis's is by its rules; even makes sections "
         "as even as "
         "can be; nearest hangs each stitch on the one that is nearest below.",
         "rule, main stitch, link", "docs/algorithm.md, Stitch index"},
    Term{"quad", "quadrilateral",
         "A face with four corners: a plain stitch, between two of its own row and two of the row below.",
         "triangle, face, strip", "docs/algorithm.md, Faces; the thesis, 2.2"},
    Term{"Reeb graph", "",
         "The skeleton of a shape: each loop of the level sets shrunk to a point. It forks where a level set "
         "parts.",
         "Morse function, saddle", "the thesis, 2.4"},
    Term{"relax", "relaxing, in the air",
         "To take the piece off the needles, before it is knitted: its stitches leave the mesh, are pulled "
         "by their "
         "neighbours and pushed by stuffing, until they come to rest. That is its size and shape as it will "
         "be.",
         "settle, stitch, stage", "docs/algorithm.md, Relaxing"},
    Term{"resampling", "resample, resampled",
         "To spread a row evenly along its ring with another number of stitches, because the number that was "
         "picked could "
         "not be knitted: at most twice and at least half of the row below, and three or more.",
         "gap, row, ring", "docs/algorithm.md, Rows"},
    Term{"ring", "cycle, loop",
         "A closed line round the surface that a row is made on: the vertices of one level in working order, "
         "or a cut. "
         "The thesis says cycle.",
         "level, contour, row", "docs/algorithm.md, Rings; the thesis, 3.2.2"},
    Term{"round", "Rnd",
         "A row that closes to a loop, as in knitting with circular needles. All rows here are rounds.",
         "row, tube", "the thesis, 2.1.1"},
    Term{"row", "",
         "The stitches on one ring, in the order in which they are knitted. Rows count from 1, which is the "
         "cast on.",
         "round, ring, course", "docs/algorithm.md, Rows; the thesis, 3.2.3"},
    Term{"rule", "R0, R1, R2, R3, R4, dense",
         "How the thesis spaces main stitches; the first that fits is taken: from the cast on (R0), plain "
         "(R1), equal "
         "spacing (R2), follow the mains (R3), remainder last (R4). Where none has room, dense takes every "
         "stitch.",
         "main stitch, placement", "docs/algorithm.md, Placement `thesis`; the thesis, 3.2.4"},
    Term{"saddle", "",
         "A place that is high in one direction and low in the other, like a mountain pass. There a level "
         "set parts into "
         "two loops, or two join.",
         "critical point, level set, stop", "docs/algorithm.md, Critical points, and where one tube ends"},
    Term{"settle", "settling, at ease",
         "To move the stitches on the surface, once they are placed and linked, until wales are as high and "
         "courses as wide "
         "as stitches are, as well as can be. The pattern stays as it is, and where stitches were placed is "
         "kept.",
         "wale, course, stitch", "docs/algorithm.md, Settling"},
    Term{"shaping", "", "Increases and decreases: what makes the fabric wider and narrower.",
         "increase, decrease, main stitch", "docs/algorithm.md, Stitch index; the thesis, 2.1.3 and 2.1.4"},
    Term{"SSK", "slip slip knit",
         "Slip, slip, knit: two stitches made one with the nearer one on top, a decrease that leans to the "
         "left. Its "
         "label is 4.",
         "K2tog, decrease, label", "the thesis, 2.1.4"},
    Term{"stage", "stages",
         "A part of the work, one after the other: import, timing, cast on, rows, stitches, faces and "
         "pattern.",
         "step", "docs/algorithm.md, The algorithm"},
    Term{"stall", "",
         "Nothing lies in the band: the ring goes from too near to too far without a vertex in between. Then "
         "the vertex "
         "nearest to the stitch width is taken, or the run stops.",
         "band, epsilon, stop", "docs/algorithm.md, Rows"},
    Term{"start and end", "start vertex, end vertex",
         "The two vertices where the time is 0 and 1. Without others picked, the lowest and the highest "
         "along the axis.",
         "time, axis", "docs/algorithm.md, Timing; the thesis, 3.2.1"},
    Term{"step", "smallest step",
         "The smallest thing that the program does: one vertex measured, one label placed, one face made. "
         "Each can be gone "
         "to, forwards and backwards.",
         "stage", "docs/rewind.md"},
    Term{"stitch", "",
         "One loop of yarn, pulled through the loop below. In the picture it is a point of a row; a face of "
         "the knit mesh "
         "is one to knit.",
         "row, stitch width, face", "the thesis, 2.1.1"},
    Term{"stitch height", "", "How high a row of stitches is, in the mesh's units; the letter h.",
         "stitch width, gauge, wale", "docs/algorithm.md, Stitch size"},
    Term{"stitch width", "stitch length",
         "How far a stitch should be from the next one of its row, in the mesh's units; the letter w.",
         "epsilon, band, gauge, course", "docs/algorithm.md, Stitch size; the thesis, 3.2.3"},
    Term{"stop", "",
         "The run cannot go on, and its last step says why: the surface parts in two, a row cannot be "
         "closed, nothing is in "
         "the band. What was made before stays.",
         "stall, saddle", "docs/algorithm.md, Stops"},
    Term{"strip", "",
         "The band of faces between a row and the next. It has a quad for each stitch of the smaller row and "
         "a triangle "
         "for each increase or decrease.",
         "face, quad, triangle", "docs/algorithm.md, Faces"},
    Term{"sweep", "", "The whole run for each of many values of a parameter, to see where it goes well.",
         "epsilon", "docs/debugging.md"},
    Term{"time", "timing, times",
         "A number from 0 to 1 for each vertex that says how early it is knitted. It rises from the start to "
         "the end.",
         "Morse function, level set, axis", "docs/algorithm.md, Timing; the thesis, 3.2.1"},
    Term{"triangle", "",
         "A face with three corners. The mesh that comes in is made of them; in the knit mesh each stands "
         "for an increase "
         "or a decrease.",
         "quad, face, shaping", "docs/algorithm.md, Faces"},
    Term{"tube", "", "What can be knitted in rounds in one go. It can grow wider and narrower but not fork.",
         "round, saddle, level set", "docs/algorithm.md, Critical points, and where one tube ends"},
    Term{"verdict", "too near, too far, accepted",
         "What becomes of a candidate: too near, accepted, or too far, by its distance from the anchor and "
         "the band.",
         "candidate, band", "docs/algorithm.md, Rows"},
    Term{"vertex", "vertices, import",
         "A corner point of the mesh, by its number. They are read when the mesh is imported, and counted "
         "from 0.",
         "triangle, weld", "docs/algorithm.md, Import"},
    Term{"wale", "wale edge",
         "A column of stitches above each other, along the knitting. How long a stitch is along it is its "
         "wale length, "
         "which should be the stitch height.",
         "course, link, stitch height", "docs/algorithm.md, What cures the distorted quads; the thesis, 1.1"},
    Term{"weld", "welded, welding",
         "To make vertices at exactly the same place one. Some files close their rings with a copy of the "
         "first vertex.",
         "vertex, ring", "docs/algorithm.md, Import"},
};

}  // namespace

std::span<const Term> glossary() { return terms; }

namespace {

constexpr std::size_t most_words = 4;  // of one form

bool is_word_byte(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80U || (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z');
}

// In small letters, hyphens as blanks; byte for byte, so that places in it are places in the text.
std::string plain(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '-') c = ' ';
  }
  return out;
}

// The next of the names in a list with commas; what is left stays in `list`.
std::string_view take_name(std::string_view& list) {
  const std::size_t comma = list.find(',');
  std::string_view name = list.substr(0, comma);
  list.remove_prefix(comma == std::string_view::npos ? list.size() : comma + 1);
  while (!name.empty() && name.front() == ' ') name.remove_prefix(1);
  return name;
}

bool is_form(std::string_view form, std::string_view words) {
  return form.size() == words.size() && plain(form) == words;
}

// `words` is plain.
const Term* term_called(std::string_view words) {
  for (const Term& term : glossary()) {
    if (is_form(term.word, words)) return &term;
    for (std::string_view forms = term.forms; !forms.empty();) {
      if (is_form(take_name(forms), words)) return &term;
    }
  }
  return nullptr;
}

bool ends_with(std::string_view words, std::string_view end) {
  return words.size() > end.size() && words.substr(words.size() - end.size()) == end;
}

// As it is, or in the plural: "rows", "stitches", "geometries".
const Term* term_of(const std::string& words) {
  if (const Term* term = term_called(words)) return term;
  if (!ends_with(words, "s")) return nullptr;
  if (const Term* term = term_called(words.substr(0, words.size() - 1))) return term;
  if (ends_with(words, "es")) return term_called(words.substr(0, words.size() - 2));
  return nullptr;
}

// Where the first words of a text end, from one that begins at `begin`; only blanks may stand between them.
std::vector<std::size_t> word_ends(const std::string& text, std::size_t begin) {
  std::vector<std::size_t> ends;
  while (ends.size() < most_words) {
    while (begin < text.size() && is_word_byte(text[begin])) ++begin;
    ends.push_back(begin);
    if (begin + 1 >= text.size() || text[begin] != ' ' || !is_word_byte(text[begin + 1])) break;
    ++begin;
  }
  return ends;
}

// The longest that begins there; without a term: to the end of the first word.
TermAt term_from(const std::string& text, std::size_t begin) {
  // In a sentence it mostly counts: "3 times as long".
  constexpr std::string_view counts = "times";
  const std::vector<std::size_t> ends = word_ends(text, begin);
  for (std::size_t words = ends.size(); words > 0; --words) {
    const std::size_t end = ends[words - 1];
    if (std::string_view(text).substr(begin, end - begin) == counts) continue;
    if (const Term* term = term_of(text.substr(begin, end - begin))) return {begin, end, term};
  }
  return {begin, ends.front(), nullptr};
}

}  // namespace

const Term* find_term(std::string_view word) { return term_of(plain(word)); }

std::vector<const Term*> seen_from(const Term& term) {
  std::vector<const Term*> named;
  for (std::string_view names = term.see; !names.empty();) {
    if (const Term* other = find_term(take_name(names))) named.push_back(other);
  }
  return named;
}

std::vector<const Term*> search_glossary(std::string_view typed) {
  const std::string wanted = plain(typed);
  const auto rank = [&](const Term& term) {
    if (plain(term.word).rfind(wanted, 0) == 0) return 0;
    if (plain(term.word).find(wanted) != std::string::npos) return 1;
    if (plain(term.forms).find(wanted) != std::string::npos) return 2;
    return plain(term.meaning).find(wanted) != std::string::npos ? 3 : 4;
  };
  std::vector<const Term*> found;
  for (int wished = 0; wished < 4; ++wished) {
    for (const Term& term : glossary()) {
      if (rank(term) == wished) found.push_back(&term);
    }
  }
  return found;
}

std::vector<TermAt> terms_in(std::string_view text) {
  const std::string words = plain(text);
  std::vector<TermAt> found;
  for (std::size_t at = 0; at < words.size();) {
    if (!is_word_byte(words[at])) {
      ++at;
      continue;
    }
    const TermAt here = term_from(words, at);
    const bool known =
        std::any_of(found.begin(), found.end(), [&](const TermAt& t) { return t.term == here.term; });
    if (here.term != nullptr && !known) found.push_back(here);
    at = here.end;
  }
  return found;
}

}  // namespace app
