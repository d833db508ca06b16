#include "app/session/chart_twins.h"

#include <algorithm>

#include "knit/pattern/limb_chart.h"

namespace app {

namespace {

// Which round of the piece a row of the fabric is, from 0; nothing: none.
std::optional<std::size_t> round_in(const knit::LimbPiece& piece, std::int32_t row) {
  const auto found = std::find(piece.rows.begin(), piece.rows.end(), row);
  if (found == piece.rows.end()) return std::nullopt;
  return static_cast<std::size_t>(found - piece.rows.begin());
}

std::int32_t stitches_in(const knit::LimbPiece& piece, std::size_t round) {
  const std::size_t before = piece.is_cast_on() ? 1 : 0;
  return round < before ? piece.first_count() : piece.rounds[round - before].after;
}

}  // namespace

std::vector<StitchAt> stitch_in_each(const knit::LimbPlan& plan, const std::vector<std::int32_t>& pieces,
                                     const StitchAt& at) {
  std::vector<StitchAt> all;
  for (const std::int32_t number : pieces) {
    const auto short_row = knit::short_row_of(plan.piece(number), at.row);
    if (short_row) {
      for (const std::int32_t twin : pieces) {
        if (const knit::RowId row = knit::row_of(plan.piece(twin), *short_row); row > 0)
          all.push_back({row, at.stitch});
      }
      break;
    }
    const auto round = round_in(plan.piece(number), at.row);
    if (!round) continue;
    const std::int32_t count = stitches_in(plan.piece(number), *round);
    const std::int32_t from_marker = (at.stitch - plan.piece(number).starts[*round] + count) % count;
    for (const std::int32_t twin : pieces) {
      const knit::LimbPiece& piece = plan.piece(twin);
      if (*round < piece.rows.size())
        all.push_back({piece.rows[*round], (piece.starts[*round] + from_marker) % count});
    }
    break;
  }
  return all;
}

std::int32_t row_in_first(const knit::LimbPlan& plan, const std::vector<std::int32_t>& pieces,
                          std::int32_t row) {
  const std::vector<knit::RowId>& first = plan.piece(pieces.front()).rows;
  for (const std::int32_t number : pieces) {
    const auto round = round_in(plan.piece(number), row);
    if (round && *round < first.size()) return first[*round];
    const auto short_row = knit::short_row_of(plan.piece(number), row);
    const knit::RowId twin = short_row ? knit::row_of(plan.piece(pieces.front()), *short_row) : 0;
    if (twin > 0) return twin;
  }
  return row;
}

std::optional<std::size_t> chart_of_piece(const std::vector<knit::PieceChart>& charts,
                                          const PlannedPieces& planned, const std::string& letters) {
  const auto named = std::find(planned.letters.begin(), planned.letters.end(), letters);
  if (named == planned.letters.end()) return std::nullopt;
  const auto piece = static_cast<std::int32_t>(named - planned.letters.begin());
  for (std::size_t i = 0; i < charts.size(); ++i) {
    if (std::count(charts[i].pieces.begin(), charts[i].pieces.end(), piece) > 0) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> chart_with_row(const std::vector<knit::PieceChart>& charts,
                                          const knit::LimbPlan& plan, std::int32_t row) {
  for (std::size_t i = 0; i < charts.size(); ++i) {
    for (const std::int32_t piece : charts[i].pieces) {
      if (round_in(plan.piece(piece), row) || knit::short_row_of(plan.piece(piece), row)) return i;
    }
  }
  return std::nullopt;
}

}  // namespace app
