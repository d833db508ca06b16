#include "knit/pattern/limb_chart.h"

#include <algorithm>
#include <iterator>

#include "knit/pattern/limb_groups.h"
#include "knit/pattern/limb_needle.h"
#include "knit/pattern/limb_short_rows.h"

namespace knit {

namespace {

ChartSquare laid_square(const NeedleStitch& stitch) {
  ChartSquare square;
  switch (stitch.use) {
    case NeedleUse::kept:
      square.symbol = ChartSymbol::kept;
      break;
    case NeedleUse::taken:
      square.symbol = ChartSymbol::held;
      square.piece = stitch.holder;
      break;
    case NeedleUse::cast_on:
      square.symbol = ChartSymbol::cast_on;
      break;
    case NeedleUse::picked_up:
      square.symbol = ChartSymbol::picked_up;
      break;
  }
  return square;
}

ChartSquare last_square(LimbEndKind end, std::int32_t set_aside) {
  ChartSquare square;
  switch (end) {
    case LimbEndKind::closed:
      square.symbol = ChartSymbol::bind_off;
      break;
    case LimbEndKind::grafted:
      square.symbol = ChartSymbol::grafted;
      break;
    case LimbEndKind::held:
      square.symbol = ChartSymbol::on_holder;
      break;
    case LimbEndKind::goes_on:
      square.symbol = set_aside < 0 ? ChartSymbol::kept : ChartSymbol::held;
      square.piece = set_aside;
      break;
  }
  return square;
}

// The squares of a row anew, by their stitches; where they stand stays.
template <class Square>
void set_squares(ChartRow& row, const Square& square_of) {
  for (ChartSquare& square : row.squares) {
    if (square.stitch < 0) continue;
    ChartSquare made = square_of(static_cast<std::size_t>(square.stitch));
    made.main = square.main;
    made.stitch = square.stitch;
    square = made;
  }
}

PieceChart chart_of_piece(const LimbPiece& piece, const PieceNeedle& needle) {
  PieceChart made;
  made.chart = chart_of(rounds_of(piece), slips_of(piece));
  std::vector<ChartRow>& rows = made.chart.rows;
  if (!piece.is_cast_on()) {
    rows.front().laid = true;
    rows.front().number = 0;
    set_squares(rows.front(), [&](std::size_t i) { return laid_square(needle.begin[i]); });
  }
  if (piece.end.kind != LimbEndKind::closed) {
    rows.back().laid = true;
    rows.back().number = piece.round_count() + 1;
    set_squares(rows.back(), [&](std::size_t i) { return last_square(piece.end.kind, needle.set_aside[i]); });
  }
  made.rows.assign(rows.size(), 0);
  made.starts.assign(rows.size(), 0);
  const std::size_t first = piece.is_cast_on() ? 0 : 1;
  for (std::size_t i = 0, at = first; i < piece.rows.size() && at < rows.size(); ++at) {
    if (rows[at].short_row != 0) {
      if (const auto short_row = short_row_of(piece, rows[at])) made.rows[at] = row_of(piece, *short_row);
      continue;
    }
    made.rows[at] = piece.rows[i];
    made.starts[at] = piece.starts[i];
    ++i;
  }
  return made;
}

constexpr const char* how_pieces_read =
    "Read from the bottom up, every round from right to left. At the right stands the round's\n"
    "number, at the left how many stitches there are after it. A row without a number knits\n"
    "nothing: it tells what lies on the needle before Rnd 1, or where the last stitches go.\n";
constexpr const char* how_it_slips = "     <     beside a round's number: slip the last stitch back first\n";

bool any_slips(const std::vector<PieceChart>& charts) {
  return std::any_of(charts.begin(), charts.end(), [](const PieceChart& piece) {
    return std::any_of(piece.chart.rows.begin(), piece.chart.rows.end(),
                       [](const ChartRow& row) { return row.slips_back; });
  });
}

std::string key_of_all(const std::vector<PieceChart>& charts) {
  std::vector<const Chart*> all;
  all.reserve(charts.size());
  for (const PieceChart& piece : charts) all.push_back(&piece.chart);
  return chart_key(all) + (any_slips(charts) ? how_it_slips : "");
}

std::string grid_or_words(const Chart& chart) {
  if (chart.columns <= widest_text_chart) return chart_grid(chart);
  return "(" + std::to_string(chart.columns) +
         " squares wide, too wide for text; save the chart as a drawing.)\n";
}

}  // namespace

PiecePlace PieceChart::place(std::size_t row, std::int32_t stitch) const {
  if (row >= rows.size() || rows[row] == 0 || stitch < 0) return {};
  const std::int32_t count = chart.rows[row].stitches;
  return {rows[row], (starts[row] + stitch) % std::max(1, count)};
}

std::int32_t PieceChart::row_of(std::int32_t fabric_row) const {
  const auto found = std::find(rows.begin(), rows.end(), fabric_row);
  return fabric_row <= 0 || found == rows.end()
             ? -1
             : static_cast<std::int32_t>(std::distance(rows.begin(), found));
}

std::vector<PieceChart> piece_charts(const LimbPlan& plan, const LimbNames& names) {
  const std::vector<PieceNeedle> needles = needles_of(plan);
  std::vector<PieceChart> charts;
  for (std::vector<std::int32_t>& group : groups_of(plan, names)) {
    const std::int32_t first = group.front();
    charts.push_back(chart_of_piece(plan.piece(first), needles[static_cast<std::size_t>(first)]));
    charts.back().pieces = std::move(group);
  }
  return charts;
}

std::vector<PieceChart> piece_charts(const LimbPlan& plan) {
  return piece_charts(plan, LimbNames(plan, PatternOptions{}));
}

std::string charts_as_text(const std::vector<PieceChart>& charts, const LimbNames& names) {
  std::string text = "\nCHARTS\n" + std::string(how_pieces_read) + "\n" + key_of_all(charts);
  for (const PieceChart& piece : charts)
    text += "\n" + names.together(piece.pieces) + "\n" + grid_or_words(piece.chart);
  return text;
}

std::string charts_as_markdown(const std::vector<PieceChart>& charts, const LimbNames& names) {
  std::string text =
      "\n## Charts\n\n" + std::string(how_pieces_read) + "\n```text\n" + key_of_all(charts) + "```\n";
  for (const PieceChart& piece : charts)
    text += "\n" + names.together(piece.pieces) + "\n\n```text\n" + grid_or_words(piece.chart) + "```\n";
  return text;
}

}  // namespace knit
