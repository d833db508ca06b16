// Charts of pieces: rounds as the plan has them, deals as marks, and what drawings make of them.
#include "knit/pattern/limb_chart.h"

#include "app/files/chart_svg.h"
#include "app/files/pieces_svg.h"
#include "knit/pattern/limb_groups.h"
#include "knit/pattern/limb_needle.h"
#include "tests/support/catch.h"
#include "tests/support/random_fabric.h"
#include "tests/support/xml_check.h"

using namespace knit;

namespace {

std::vector<ChartSquare> in_working_order(const ChartRow& row) {
  std::vector<ChartSquare> squares;
  for (const ChartSquare& square : row.squares) {
    if (square.stitch >= 0) squares.push_back(square);
  }
  return squares;
}

void check_rounds(const LimbPiece& piece, const Chart& chart) {
  REQUIRE(chart.rows.size() == piece.rounds.size() + 2);
  for (std::size_t r = 0; r < piece.rounds.size(); ++r) {
    const ChartRow& row = chart.rows[r + 1];
    CHECK(row.slips_back == piece.rounds[r].slips_back);
    CHECK_FALSE(row.laid);
    const std::vector<ChartSquare> squares = in_working_order(row);
    REQUIRE(squares.size() == piece.rounds[r].operations.size());
    for (std::size_t i = 0; i < squares.size(); ++i) CHECK(squares[i].stitch == static_cast<std::int32_t>(i));
  }
}

void check_deals(const LimbPlan& plan, std::int32_t number, const Chart& chart) {
  const LimbPiece& piece = plan.piece(number);
  CHECK(chart.rows.front().laid == !piece.is_cast_on());
  CHECK(chart.rows.back().laid == (piece.end.kind != LimbEndKind::closed));
  const std::vector<ChartSquare> first = in_working_order(chart.rows.front());
  CHECK(static_cast<std::int32_t>(first.size()) == piece.first_count());
  std::int32_t taken = 0, told = 0;
  for (const ChartSquare& square : first) taken += square.symbol == ChartSymbol::held ? 1 : 0;
  for (const LimbDeal& deal : piece.deals) {
    if (deal.kind == LimbDealKind::loops) told += deal.after;
    for (const LimbItem& item : deal.items) told += item.kind == LimbItemKind::take ? item.count : 0;
    if (deal.kind == LimbDealKind::divide) told = std::min(told, taken);  // some of them are put aside again
  }
  CHECK(taken <= told);
}

}  // namespace

TEST_CASE("limb charts: a chart has the rounds of its piece, and deals as rows that knit nothing") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const State state = test_support::RandomFabric(seed).run(3 + static_cast<int>(seed % 6));
    if (!has_limbs(state)) continue;
    const LimbPlan plan = plan_limbs(state);
    std::size_t pieces = 0;
    for (const PieceChart& made : piece_charts(plan)) {
      pieces += made.pieces.size();
      check_rounds(plan.piece(made.pieces.front()), made.chart);
      check_deals(plan, made.pieces.front(), made.chart);
      for (std::size_t row = 0; row < made.rows.size(); ++row) {
        if (made.rows[row] == 0) continue;
        CHECK(made.row_of(made.rows[row]) == static_cast<std::int32_t>(row));
        CHECK(made.place(row, 0) ==
              PiecePlace{made.rows[row], made.starts[row] % made.chart.rows[row].stitches});
      }
    }
    CHECK(pieces == plan.pieces.size());
  }
}

TEST_CASE("limb charts: drawings are well-formed, and define each symbol once") {
  for (unsigned seed = 0; seed < 12; ++seed) {
    CAPTURE(seed);
    const State state = test_support::RandomFabric(seed).run(4);
    if (!has_limbs(state)) continue;
    const LimbPlan plan = plan_limbs(state);
    const LimbNames names(plan, {});
    const std::vector<PieceChart> charts = piece_charts(plan, names);
    std::vector<app::NamedChart> named;
    for (const PieceChart& chart : charts) named.push_back({names.together(chart.pieces), &chart.chart});
    const std::string svg = app::charts_svg(named, {"Charts & pieces"});
    CHECK(test_support::xml_fault(svg) == "");
    CHECK(test_support::occurrences(svg, "id=\"knit-kept\"") <= 1);
    CHECK(test_support::occurrences(svg, "Start at the bottom") == 1);
    CHECK(app::charts_svgs(named, {}).size() == charts.size() + 1);
    const std::string picture = app::pieces_svg(plan, names, "Pieces");
    CHECK(test_support::xml_fault(picture) == "");
    CHECK(test_support::occurrences(picture, "class=\"piece\"") == plan.pieces.size());
  }
}

TEST_CASE("limb charts: the picture's boxes stand above what they stand on, and do not touch") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const State state = test_support::RandomFabric(seed).run(5);
    if (!has_limbs(state)) continue;
    const LimbPlan plan = plan_limbs(state);
    const app::PiecesLayout layout = app::layout_of(plan);
    for (const app::PieceThread& thread : layout.threads) {
      const auto from = static_cast<std::size_t>(thread.from), to = static_cast<std::size_t>(thread.to);
      if (!thread.grafted) CHECK(layout.places[from].layer < layout.places[to].layer);
    }
    for (std::size_t a = 0; a < layout.places.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if (layout.places[a].layer != layout.places[b].layer) continue;
        CHECK(std::abs(layout.places[a].x - layout.places[b].x) > app::piece_box_width);
      }
    }
  }
}
