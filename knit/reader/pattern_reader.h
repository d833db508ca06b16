// A second pair of eyes: reads a written pattern as a knitter would, works it on live stitches, and says where it
// does not add up. Knows nothing of how patterns are written here; shares only the words of the trade.
//
// Reads plain text, Markdown and knitspeak: rounds ("Rnd 7:", "Rnds 8-12:", "Round 3:", "Row 4:"), operations
// (k, k4, knit, m1, m1r, m1l, kfb, k2tog, ssk, s2kp ... as listed in the source), repeats ("[K4, m1l] 6 times",
// "(k1, m1) 6x", "*k1, m1l; rep from * to end", "..., repeat from *", "rep from * 5 more times"), plain rounds
// ("Knit.", "K all sts"), short rows (short_needles.h), cast on, bind off, draw through, markers, stated counts "(30 sts)". Other lines are not
// pattern and are passed over; a line that begins like a round and cannot be read is a mistake. Nothing is repaired.
// A text with headings of pieces is read by limbs_reader.h. This program's own words are read, to the graph of stitches;
// the world's are checked_pattern.h's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "knit/pattern/rounds.h"

namespace knit {

struct PatternMistake {
  std::size_t line = 0;  // of the text, from 1
  std::string sentence;  // "line 12: Rnd 7 makes 29 stitches, the line says 30."
};

struct ReadPattern {
  // The rounds before the first mistake, repeats unfolded; numbered as rows are, whatever the labels say. Every
  // round takes exactly what is there.
  Rounds rounds;
  // Between these rounds, as they were worked on the needles.
  std::vector<GraphShortRow> short_rows = {};
  std::vector<PatternMistake> mistakes;  // by line
  std::size_t rounds_read = 0;           // without the cast on, with those that have mistakes
  std::int64_t stitches = 0;             // cast on and made in all, as far as it could be worked
  std::int32_t closed_with = 0;          // stitches bound off or drawn through; 0: the pattern does not say
};

ReadPattern read_pattern(std::string_view text);

// Of a pattern with limbs (limbs_reader.h): what is told of any pattern. Its rounds are no single chain, so they are not
// handed on.
struct ReadLimbs;
ReadPattern as_pattern(ReadLimbs limbs);

}  // namespace knit
