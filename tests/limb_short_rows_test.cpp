// Short rows inside pieces, stop by stop: each is one when knitting along, and the squares of its row of the chart are its stitches.

#include <algorithm>
#include <map>
#include <set>

#include "app/panels/pattern/piece_stops.h"
#include "app/session/chart_twins.h"
#include "app/session/document.h"
#include "app/session/planned_pieces.h"
#include "knit/pattern/limb_chart.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

namespace {

// A fork with short rows: no turn costs anything.
Session forked() {
  Session session = test_support::example_session("y");
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.short_rows.rows = knit::ShortRows::automatic;
  parameters.short_rows.kept = knit::KeptBeside::none;
  parameters.short_rows.turn_cost = 0.0;
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  return session;
}

}  // namespace

TEST_CASE("short rows in pieces are stops and squares of their own") {
  const Session session = forked();
  const PlannedPieces pieces = planned_pieces(session);
  const knit::Fabric& fabric = session.document->timeline.furthest().fabric;
  std::set<std::int32_t> wanted, stopped;
  for (const auto& row : fabric.rows())
    if (is_short(*row)) wanted.insert(row->id);
  REQUIRE_FALSE(wanted.empty());
  const std::vector<PieceStop> stops = stops_of(pieces.plan);
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const PieceStop& stop = stops[i];
    CHECK(stop_at(stops, stop.row, stop.deal) == i);
    if (stop.short_row == 0) continue;
    CHECK(stopped.insert(stop.row).second);
    const std::string words = words_of(pieces, stop);
    CAPTURE(words);
    CHECK(words.starts_with("Short row " + std::to_string(stop.short_row) + " ("));
    CHECK(place_words(pieces, stop).find("short row " + std::to_string(stop.short_row) + " before round ") !=
          std::string::npos);
    CHECK(end_words(pieces, stop).empty());
    const knit::LimbPiece& piece = pieces.plan.piece(stop.piece);
    const std::int32_t made = stop.number - 1 - (piece.is_cast_on() ? 1 : 0);
    CHECK(holding_after(pieces, stop).needle == piece.rounds[static_cast<std::size_t>(made)].before);
  }
  CHECK(stopped == wanted);
}

TEST_CASE("a chart's square of a short row in a piece is the stitch on the wale below it") {
  const Session session = forked();
  const PlannedPieces pieces = planned_pieces(session);
  const knit::Fabric& fabric = session.document->timeline.furthest().fabric;
  std::set<std::pair<std::int32_t, std::int32_t>> seen;
  std::size_t squares = 0;
  for (const knit::PieceChart& made : knit::piece_charts(pieces.plan)) {
    const knit::LimbPiece& piece = pieces.plan.piece(made.pieces.front());
    for (std::size_t row = 0; row < made.chart.rows.size(); ++row) {
      if (made.chart.rows[row].short_row == 0) continue;
      CHECK(made.rows[row] > 0);
      for (const knit::ChartSquare& square : made.chart.rows[row].squares) {
        if (square.stitch < 0) continue;
        const knit::ShortRowPlace place = knit::place_of(piece, made.chart.rows[row], square);
        REQUIRE(fabric.has_row(place.row));
        const knit::Row& made_row = fabric.row(place.row);
        REQUIRE(is_short(made_row));
        REQUIRE(place.stitch < knit::size_of(made_row));
        CHECK(seen.insert({place.row, place.stitch}).second);
        // The stitch of the round below, from the marker on.
        const std::size_t round = static_cast<std::size_t>(made.chart.rows[row].number) - 1;
        const knit::StitchRef under = fabric.under_short_rows(made_row.on).at(place.stitch);
        if (round > 0 && under.row == piece.rows[round - 1]) {
          const std::int32_t count = knit::size_of(fabric.row(under.row));
          CHECK((piece.starts[round - 1] + square.stitch) % count == under.stitch);
          ++squares;
        }
        CHECK(stitch_in_each(pieces.plan, made.pieces, {place.row, place.stitch}).size() ==
              made.pieces.size());
      }
    }
  }
  CHECK(squares > 0);
}
