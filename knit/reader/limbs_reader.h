// Reads a pattern with limbs as a knitter would, on a needle and holders that go by a piece's name, and rebuilds the graph.
// Knows nothing of how patterns are written here; rounds are read by reader_grammar.h and worked by reader_work.h.
//
// Understood are headings ("Limb D: 5 rnds, 5 sts at the end", "Limbs B and C (make 2): ..."), remarks in brackets, which
// prove nothing, short rows (short_needles.h), Rejoin, Divide, Join, Remove the waste yarn, Break yarn, Do not break yarn, Graft, Bind off, rounds, and
// "Work as for". Everything else within a piece is a mistake. Every number is proved: counts in lines and after them,
// rounds and last count against the heading, first and last stitch taken off a holder, gaps cast on once and picked up once,
// nothing left on needle, holders and waste yarn. Nothing is repaired: the first mistake ends the reading.
// State: the needle from the marker on; of each holder its stitches and, between them, the gaps' edges, round and round.
// O(stitches).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "knit/reader/pattern_reader.h"

namespace knit {

// Stitches go by numbers, from 0 as they are cast on or made.
struct ReadStitch {
  Hand hand = Hand::knit;
  // What it is worked from: one stitch, or two that are taken together; of an increase those on both sides of its bar. -1: none.
  std::int32_t first = -1, second = -1;
  friend bool operator==(const ReadStitch&, const ReadStitch&) = default;
};

struct ReadLimb {
  std::string name;
  std::vector<std::int32_t> live;  // what its first round is worked on, from the marker; a cast on: nothing
  std::vector<std::vector<std::int32_t>> rows;  // from the marker; the cast on first
  // In working order; `row` is the one of `rows` that they stand on, -1: `live`.
  std::vector<GraphShortRow> short_rows = {};
  friend bool operator==(const ReadLimb&, const ReadLimb&) = default;
};

struct ReadLimbs {
  std::vector<ReadLimb> limbs;  // as they are worked
  std::vector<ReadStitch> stitches;
  std::vector<std::vector<std::int32_t>> gaps;      // stitches of each, by its number from 1
  std::vector<std::array<std::int32_t, 2>> grafts;  // own stitch, the other's
  std::vector<std::vector<std::int32_t>> closed;    // loops that are drawn in or bound off
  std::vector<PatternMistake> mistakes;             // one at most
  std::size_t rounds_read = 0;
  std::int64_t cast_on = 0;  // stitches of all cast ons
};

// Whether a piece has a heading there.
bool has_limb_headings(std::string_view text);
ReadLimbs read_limbs(std::string_view text);

}  // namespace knit
