// A chart for each piece with limbs; pieces made together have one.
//
// Under the rounds of a piece that is not cast on stands a row that knits nothing: what lies on the needle before round 1, from
// the marker on: kept, cast on over a gap, picked up along one, or the letter of the holder that a stitch is taken from. Over
// the rounds stands where their last stitches go: bound off, grafted, on a holder of their own, kept on the needle, or the
// letter of the piece for which they are put on a holder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "knit/limbs/limb_plan.h"
#include "knit/pattern/chart.h"
#include "knit/pattern/limb_words.h"

namespace knit {

// A stitch of the fabric.
struct PiecePlace {
  std::int32_t row = 0;  // 0: none
  std::int32_t stitch = 0;
  friend bool operator==(const PiecePlace&, const PiecePlace&) = default;
};

struct PieceChart {
  std::vector<std::int32_t> pieces;  // of the plan
  Chart chart;
  // Of the first of them: of each of the chart's rows the fabric's row, 0 where it is none's, and the stitch of it that the
  // marker stands before. A short row's stitches are found apart (`place_of`).
  std::vector<std::int32_t> rows, starts;
  // What stands at a stitch of a row of the chart, in the fabric.
  [[nodiscard]] PiecePlace place(std::size_t row, std::int32_t stitch) const;
  // The chart's row that a row of the fabric is.
  [[nodiscard]] std::int32_t row_of(std::int32_t fabric_row) const;  // -1: none
};

// In working order.
std::vector<PieceChart> piece_charts(const LimbPlan& plan, const LimbNames& names);
std::vector<PieceChart> piece_charts(const LimbPlan& plan);  // by the program's own names

// The document's last section: all charts that are narrow enough as characters, under one key.
std::string charts_as_text(const std::vector<PieceChart>& charts, const LimbNames& names);
std::string charts_as_markdown(const std::vector<PieceChart>& charts, const LimbNames& names);

// Between the short rows of a piece and the fabric's rows and stitches.
//
// The fabric numbers the short rows before a round right below it, two a pair, in the order of its pairs. The pattern and the chart
// number those that turn in working order (passes.h): pairs over the marker as they are listed, then the others by their first stitch.
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
