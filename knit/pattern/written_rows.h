// Between the fabric's rows and what the pattern calls them. The fabric numbers short rows among all others; the pattern numbers
// rounds without them, and counts the short rows before each round from 1. Of a single chain of rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "knit/fabric/fabric.h"
#include "knit/pattern/chart.h"

namespace knit {

struct WrittenRow {
  std::int32_t round = 1;      // a short row's: the round that is worked over it
  std::int32_t short_row = 0;  // its number before that round, as its line says it; 0: the round itself
  friend bool operator==(const WrittenRow&, const WrittenRow&) = default;
};
// Of each row of the fabric. A short row's number is its turn's: what is worked home to the beginning of the round has none.
std::vector<WrittenRow> written_rows(const Fabric& fabric);

// How the pattern calls a row; none: there is no such row.
std::optional<WrittenRow> written_row(const Fabric& fabric, RowId row);

// The row of the fabric that is called so; 0: none.
RowId row_called(const Fabric& fabric, const WrittenRow& called);

// The row that a round of the pattern is; 0: none.
RowId row_of_round(const Fabric& fabric, std::int32_t round);

// Which rows and stitches of the fabric a chart's are. A row of the chart that leads home belongs to the last short row before it;
// its squares are stitches all the same: in each wale they come in the order in which they are worked.
class ChartStitches {
 public:
  ChartStitches() = default;
  ChartStitches(const Fabric& fabric, const Chart& chart);
  // 0: no row, the bind off.
  [[nodiscard]] RowId row(std::size_t chart_row) const {
    return chart_row < rows_.size() ? rows_[chart_row] : 0;
  }
  // The first row of the chart that is this one; past the end: none.
  [[nodiscard]] std::size_t chart_row_of(RowId row) const;
  [[nodiscard]] std::optional<StitchRef> stitch(std::size_t chart_row, const ChartSquare& square) const;

 private:
  using Stacks = std::vector<std::vector<StitchRef>>;  // on each stitch of a round, from below
  std::vector<RowId> rows_;
  std::vector<Stacks> over_;               // of each round, the short rows' stitches on it
  std::vector<std::int32_t> round_below_;  // of each row of the chart: of `over_`; -1: it is no short row
};

}  // namespace knit
