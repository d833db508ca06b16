#include "knit/pattern/limb_chart.h"

#include <algorithm>
#include <iterator>

#include "knit/pattern/limb_groups.h"
#include "knit/pattern/limb_needle.h"

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

namespace {

// Null: none was made before it.
const LimbRound* round_at(const LimbPiece& piece, std::size_t round) {
  const std::size_t before = piece.is_cast_on() ? 1 : 0;
  if (round < before || round - before >= piece.rounds.size() || round >= piece.rows.size()) return nullptr;
  return &piece.rounds[round - before];
}

std::int32_t count_of(const LimbRound& round) { return 2 * static_cast<std::int32_t>(round.pairs.size()); }

// The first short row before a round; 0: the fabric has no room for them there, as of a twin that is worked otherwise.
RowId first_before(const LimbPiece& piece, std::size_t round) {
  const LimbRound* made = round_at(piece, round);
  if (made == nullptr || made->pairs.empty()) return 0;
  const RowId first = piece.rows[round] - count_of(*made);
  const RowId below = round > 0 ? piece.rows[round - 1] : 0;
  return first > below ? first : 0;
}

// The pairs' places in the fabric's order, as they are worked.
std::vector<std::size_t> worked_order(const std::vector<ShortRowPair>& pairs) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (pairs[i].first < 0) order.push_back(i);
  const auto inside = static_cast<std::ptrdiff_t>(order.size());
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (pairs[i].first >= 0) order.push_back(i);
  std::stable_sort(order.begin() + inside, order.end(),
                   [&](std::size_t a, std::size_t b) { return pairs[a].first < pairs[b].first; });
  return order;
}

std::size_t round_of(const ChartRow& row) { return static_cast<std::size_t>(std::max(0, row.number - 1)); }

}  // namespace

std::int32_t short_rows_before(const LimbPiece& piece, std::size_t round) {
  return first_before(piece, round) == 0 ? 0 : count_of(*round_at(piece, round));
}

RowId row_of(const LimbPiece& piece, const PieceShortRow& short_row) {
  if (short_row.turn < 1 || short_row.turn > short_rows_before(piece, short_row.round)) return 0;
  const std::vector<std::size_t> order = worked_order(round_at(piece, short_row.round)->pairs);
  const std::int32_t turn = short_row.turn - 1;
  return first_before(piece, short_row.round) +
         2 * static_cast<std::int32_t>(order[static_cast<std::size_t>(turn / 2)]) + turn % 2;
}

std::optional<PieceShortRow> short_row_of(const LimbPiece& piece, RowId row) {
  const auto above = std::upper_bound(piece.rows.begin(), piece.rows.end(), row);
  if (above == piece.rows.end()) return std::nullopt;
  const auto round = static_cast<std::size_t>(above - piece.rows.begin());
  for (std::int32_t turn = 1; turn <= short_rows_before(piece, round); ++turn)
    if (row_of(piece, {round, turn}) == row) return PieceShortRow{round, turn};
  return std::nullopt;
}

std::optional<PieceShortRow> short_row_of(const LimbPiece& piece, const ChartRow& row) {
  const std::size_t round = round_of(row);
  const std::int32_t count = short_rows_before(piece, round);
  if (row.short_row == 0 || count == 0) return std::nullopt;
  return PieceShortRow{round, std::min(row.short_row, count)};
}

ShortRowPlace place_of(const LimbPiece& piece, const ChartRow& row, const ChartSquare& square) {
  const std::size_t round = round_of(row);
  if (square.stitch < 0 || short_rows_before(piece, round) == 0) return {};
  const LimbRound& made = *round_at(piece, round);
  std::int32_t under = 0;  // short rows' stitches on the wale
  for (std::size_t i = 0; i < made.pairs.size(); ++i) {
    const ShortRowPair& pair = made.pairs[i];
    const std::int32_t along = ((square.stitch - pair.first) % made.before + made.before) % made.before;
    if (along > pair.last - pair.first) continue;
    if (square.height < under + 2)
      return {first_before(piece, round) + 2 * static_cast<std::int32_t>(i) + square.height - under, along};
    under += 2;
  }
  return {};
}

}  // namespace knit
