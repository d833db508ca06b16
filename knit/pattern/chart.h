// The chart of the pattern: one row of squares a round, wales kept in columns by grey squares where there is no
// stitch.
//
// Rows go bottom to top, each is worked from right to left: column 0 is the right edge, where rounds begin. A
// square belongs to the round that works it: an increase stands in the round that makes it, a decrease in the
// round that takes two together.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "knit/pattern/rounds.h"

namespace knit {

enum class ChartSymbol : std::uint8_t {
  no_stitch,
  knit,
  m1r,
  m1l,
  k2tog,
  ssk,
  cast_on,
  bind_off,
  // Of pieces with limbs, in rows that knit nothing (limb_chart.h).
  kept,       // stays on the needle
  held,       // of a holder, that has its piece's letter
  picked_up,  // along a gap
  on_holder,  // goes on a holder, of its own piece
  grafted,
  // Of short rows: a double or wrapped stitch in the row that works it, and where a short row turns, at its end.
  marked,
  turn_left,
  turn_right
};
// A grey square.
inline bool has_no_stitch(ChartSymbol symbol) {
  return symbol == ChartSymbol::no_stitch || symbol == ChartSymbol::turn_left ||
         symbol == ChartSymbol::turn_right;
}

struct ChartSquare {
  ChartSymbol symbol = ChartSymbol::no_stitch;
  bool main = false;         // of a main wale
  std::int32_t stitch = -1;  // of its row, from 0; -1: no stitch
  std::int32_t piece = -1;   // held: the piece whose letter stands there
  std::int32_t height =
      0;  // of a short row, whose squares name the stitch of the round that they stand over: so many are between
  friend bool operator==(const ChartSquare&, const ChartSquare&) = default;
};
struct ChartRow {
  std::int32_t number = 1;    // of the round
  std::int32_t stitches = 0;  // on the needles afterwards
  std::vector<ChartSquare> squares;
  bool laid =
      false;  // knits nothing: what lies on the needle before the first round, or where stitches go in the end
  bool slips_back = false;  // the last stitch of the round before is taken together with the first
  // A short row before the round: its number there, from 1, as its line in the pattern says it; 0: the round itself. Its squares
  // are no stitches of the round: each has the stitch of the round below that it stands over. It is worked from the right, on the wrong side from the left.
  std::int32_t short_row = 0;
  bool wrong_side = false;
  // The way on to the beginning of the round, the pattern's "Next row (RS)": `short_row` is the last turn's number, its own is none.
  bool home = false;
  friend bool operator==(const ChartRow&, const ChartRow&) = default;
};
struct Chart {
  std::int32_t columns = 0;
  std::vector<ChartRow> rows;  // the cast on first
  // Where the round of this number stands; past the end: nowhere.
  [[nodiscard]] std::size_t row_of(std::int32_t round) const {
    std::size_t row = 0;
    while (row < rows.size() && (rows[row].number != round || rows[row].short_row != 0)) ++row;
    return row;
  }
};
// What stands beside a row: "12", "12 <", "s1", "next".
std::string name_of(const ChartRow& row);

// Columns are chosen so that a stitch stands above the one it is worked from wherever it can, and main wales
// keep their column all the way.
// `slips_back`, of each round, as for wales_of.
Chart chart_of(const Rounds& rounds, const std::vector<std::uint8_t>& slips_back = {});

// The chart as characters, for the plain documents: one a square, under its key, bottom to top and right to left.
//
// Plain knitting is blank and grey squares are dotted, as on the drawing, so that the shaping stands out. The
// section holds no line that a reader of patterns could take for a round, a cast on or an end.

// What a square means: a character and words. The key of every form of the chart speaks these words.
struct ChartSign {
  ChartSymbol symbol;
  char sign;
  std::string_view meaning;
};
inline constexpr std::array<ChartSign, 16> chart_signs{{
    {ChartSymbol::knit, ' ', "k: knit"},
    {ChartSymbol::m1r, 'R', "m1r: make 1 right"},
    {ChartSymbol::m1l, 'L', "m1l: make 1 left"},
    {ChartSymbol::k2tog, '/', "k2tog: knit 2 together"},
    {ChartSymbol::ssk, '\\', "ssk: slip, slip, knit"},
    {ChartSymbol::cast_on, 'o', "CO: cast on"},
    {ChartSymbol::bind_off, '=', "BO: bind off or close up"},
    {ChartSymbol::kept, '.', "stays on the needle"},
    {ChartSymbol::held, 'A', "a letter: on the holder of that piece"},
    {ChartSymbol::picked_up, 'u', "picked up along a gap"},
    {ChartSymbol::on_holder, '-', "goes on a holder"},
    {ChartSymbol::grafted, '~', "grafted"},
    {ChartSymbol::marked, 'V', "a double or wrapped stitch: work it as one"},
    {ChartSymbol::turn_left, ')', "turn here, to the WS"},
    {ChartSymbol::turn_right, '(', "turn here, to the RS"},
    {ChartSymbol::no_stitch, ':', "no stitch: skip it"},
}};
const ChartSign& sign_of(ChartSymbol symbol);

// A wider chart is no use as text.
inline constexpr std::int32_t widest_text_chart = 100;

// The characters of a chart alone: rows from the top down, numbers beside them, the columns' numbers below.
std::string chart_grid(const Chart& chart);
// Of all charts together: a line for each symbol that is there.
std::string chart_key(const std::vector<const Chart*>& charts);
bool has_short_rows(const Chart& chart);
bool has_way_home(const Chart& chart);
bool has_symbol(const Chart& chart, ChartSymbol symbol);

// The document's last section, with an empty line before it. Of a chart that is too wide it says where the
// chart is to be had.
std::string chart_as_text(const Chart& chart);
std::string chart_as_markdown(const Chart& chart);

}  // namespace knit
