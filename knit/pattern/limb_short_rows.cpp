#include "knit/pattern/limb_short_rows.h"

#include <algorithm>
#include <vector>

namespace knit {

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

std::size_t round_of(const LimbPiece& /*piece*/, const ChartRow& row) {
  return static_cast<std::size_t>(std::max(0, row.number - 1));
}

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
  const std::size_t round = round_of(piece, row);
  const std::int32_t count = short_rows_before(piece, round);
  if (row.short_row == 0 || count == 0) return std::nullopt;
  const std::vector<ShortRowPair>& pairs = round_at(piece, round)->pairs;
  const auto over =
      2 * static_cast<std::int32_t>(std::count_if(pairs.begin(), pairs.end(),
                                                  [](const ShortRowPair& pair) { return pair.first < 0; }));
  const std::int32_t turn = row.short_row - (over > 0 && row.short_row > over ? 1 : 0);
  return PieceShortRow{round, std::min(turn, count)};
}

ShortRowPlace place_of(const LimbPiece& piece, const ChartRow& row, const ChartSquare& square) {
  const std::size_t round = round_of(piece, row);
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
