// Between the short rows of a piece and the fabric's rows and stitches.
//
// The fabric numbers the short rows before a round right below it, two a pair, in the order of its pairs. The pattern and the chart
// number those that turn in working order (passes.h): pairs over the marker as they are listed, then the others by their first stitch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "knit/limbs/limb_plan.h"
#include "knit/pattern/chart.h"

namespace knit {

struct PieceShortRow {
  std::size_t round = 0;  // of the piece's rows, from 0, that it is worked before
  std::int32_t turn = 0;  // its number there, from 1, in working order
  friend bool operator==(const PieceShortRow&, const PieceShortRow&) = default;
};

// How many short rows turn before that one of the piece's rows.
std::int32_t short_rows_before(const LimbPiece& piece, std::size_t round);
// The fabric's row; 0: there is none.
RowId row_of(const LimbPiece& piece, const PieceShortRow& short_row);
std::optional<PieceShortRow> short_row_of(const LimbPiece& piece, RowId row);
// The short row that a row of the piece's chart is; one that leads home belongs to the last before it. None: a round.
std::optional<PieceShortRow> short_row_of(const LimbPiece& piece, const ChartRow& row);

// What a square of such a row makes, in the fabric: of each wale they come in the order of working.
struct ShortRowPlace {
  RowId row = 0;  // 0: none
  std::int32_t stitch = 0;
};
ShortRowPlace place_of(const LimbPiece& piece, const ChartRow& row, const ChartSquare& square);

}  // namespace knit
