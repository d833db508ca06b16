#include "knit/pattern/chart.h"

#include <algorithm>
#include <array>
#include <set>

#include "knit/model/bug.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/wales.h"
#include "knit/run/timeline.h"
#include "tests/support/catch.h"
#include "tests/support/hand_rounds.h"
#include "tests/support/run.h"

using namespace knit;
using namespace test_support;

namespace {

State sphere_run(double width, PlacementPolicy placement, FollowMains follow = FollowMains::off) {
  Parameters parameters;
  parameters.timing.kind = TimingKind::arc_length;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = placement;
  parameters.stitches.follow_mains = follow;
  give_width(parameters, width);
  Timeline timeline(thesis_sphere(), parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.stop() == nullptr);
  return timeline.furthest();
}

// A chart as text, first row first, right edge first: what a row is read as.
std::vector<std::string> letters_of(const Chart& chart) {
  const std::string letters = ".krl/\\cb";
  std::vector<std::string> rows;
  for (const ChartRow& row : chart.rows) {
    std::string& text = rows.emplace_back();
    for (const ChartSquare& square : row.squares) {
      if (square.main) text += '*';
      text += letters[static_cast<std::size_t>(square.symbol)];
    }
  }
  return rows;
}

// Per row the column of each stitch. Fails unless every stitch has exactly one square, in working order, and
// all other squares are grey.
std::vector<std::vector<std::size_t>> columns_by_stitch(const Chart& chart) {
  std::vector<std::vector<std::size_t>> all;
  for (const ChartRow& row : chart.rows) {
    REQUIRE(row.squares.size() == static_cast<std::size_t>(chart.columns));
    std::vector<std::size_t>& columns = all.emplace_back();
    for (std::size_t column = 0; column < row.squares.size(); ++column) {
      const ChartSquare& square = row.squares[column];
      REQUIRE((square.symbol == ChartSymbol::no_stitch) == (square.stitch == -1));
      if (square.stitch == -1) {
        REQUIRE_FALSE(square.main);
        continue;
      }
      REQUIRE(square.stitch == static_cast<std::int32_t>(columns.size()));
      columns.push_back(column);
    }
  }
  return all;
}

bool has_symbol_of(const ChartSquare& square, Hand hand) {
  constexpr std::array symbols{ChartSymbol::knit, ChartSymbol::m1r, ChartSymbol::m1l, ChartSymbol::k2tog,
                               ChartSymbol::ssk};
  return square.symbol == symbols[static_cast<std::size_t>(hand)];
}

// All that a chart promises about squares; that a stitch never leaves the column of what it is worked from.
void check_squares(const Rounds& rounds, const Chart& chart) {
  const auto columns = columns_by_stitch(chart);
  const KnitGraph graph = graph_of(rounds);
  REQUIRE(chart.rows.size() == graph.rows.size() + 1);
  REQUIRE(columns.back() == columns[columns.size() - 2]);
  for (std::size_t row = 0; row < graph.rows.size(); ++row) {
    const ChartRow& drawn = chart.rows[row];
    REQUIRE(columns[row].size() == graph.rows[row].size());
    REQUIRE(drawn.stitches == static_cast<std::int32_t>(graph.rows[row].size()));
    REQUIRE(drawn.number == static_cast<std::int32_t>(row) + 1);
    if (row == 0) continue;
    for (std::size_t i = 0; i < columns[row].size(); ++i) {
      const GraphStitch& stitch = graph.rows[row][i];
      const std::size_t column = columns[row][i];
      REQUIRE(has_symbol_of(drawn.squares[column], stitch.hand));
      REQUIRE(drawn.squares[column].main == rounds.rounds[row - 1].operations[i].at_main);
      const auto first = columns[row - 1].begin() + stitch.first;
      if (stitch.count > 0) REQUIRE(std::find(first, first + stitch.count, column) != first + stitch.count);
      if (stitch.count == 0) REQUIRE(chart.rows[row - 1].squares[column].stitch == -1);
    }
  }
}

// As many columns as the longest chain has of wales that stood next to each other, in a row or from one row
// to the next: fewer cannot do.
std::int32_t least_columns(const Rounds& rounds) {
  const Wales wales = wales_of(rounds);
  std::vector<std::int32_t> place(wales.hand.size(), 0);
  for (bool moved = true; moved;) {
    moved = false;
    for (std::size_t row = 0; row < wales.rows.size(); ++row) {
      std::set<Wale> both(wales.rows[row].begin(), wales.rows[row].end());
      if (row > 0) both.insert(wales.rows[row - 1].begin(), wales.rows[row - 1].end());
      std::int32_t least = 0;
      for (const Wale wale : both) {
        std::int32_t& here = place[static_cast<std::size_t>(wale)];
        moved = moved || here < least;
        here = std::max(here, least);
        least = here + 1;
      }
    }
  }
  return 1 + *std::max_element(place.begin(), place.end());
}

}  // namespace

TEST_CASE("chart: an increase opens a column beside its neighbour, a decrease leaves one grey") {
  const Rounds rounds = hand_rounds(3, {"Kkk", "Krkk", "K\\k", "Kkk"});
  CHECK(letters_of(chart_of(rounds)) ==
        std::vector<std::string>{"*c.cc", "*k.kk", "*krkk", "*k\\.k", "*kk.k", "*bb.b"});
}

TEST_CASE("chart: where there is room, an increase stands beside the stitch that it is made next to") {
  CHECK(letters_of(chart_of(hand_rounds(3, {"krkk", "\\kk", "kkk", "krrrkk"})))[1] == "kr..kk");
  CHECK(letters_of(chart_of(hand_rounds(3, {"klkk", "\\kk", "kkk", "krrrkk"})))[1] == "k..lkk");
}

TEST_CASE("chart: of two stitches taken together the upper one keeps its column, a main before it") {
  const auto worked = [](const std::string& round, const std::string& before = "kkkk") {
    return letters_of(chart_of(hand_rounds(4, {before, round})))[2];
  };
  CHECK(worked("k/k") == "k./k");
  CHECK(worked("k\\k") == "k\\.k");
  CHECK(worked("k*/k", "kKkk") == "k*/.k");
  CHECK(worked("k*/k", "kkKk") == "k.*/k");
  CHECK(worked("k*\\k", "kkKk") == "k.*\\k");
}

TEST_CASE("chart: rows are numbered as rounds, the bind off after them") {
  const Chart chart = chart_of(hand_rounds(3, {"klkk", "kk/"}));
  REQUIRE(chart.rows.size() == 4);
  CHECK(chart.rows[0].number == 1);
  CHECK(chart.rows[1].stitches == 4);
  CHECK(chart.rows[2].stitches == 3);
  CHECK(chart.rows[3].number == 4);
  CHECK(chart.rows[3].stitches == 0);
}

TEST_CASE("chart: a pattern that is cast on and nothing else") {
  const Rounds rounds = hand_rounds(5, {});
  CHECK(letters_of(chart_of(rounds)) == std::vector<std::string>{"ccccc", "bbbbb"});
}

TEST_CASE("chart: a wale takes over the column of one that has ended") {
  const Rounds elsewhere = hand_rounds(4, {"k\\k", "kkkl"});
  CHECK(chart_of(elsewhere).columns == 5);
  const Rounds at_once = hand_rounds(4, {"k\\lk"});
  CHECK(chart_of(at_once).columns == 5);
  const Rounds between = hand_rounds(4, {"k\\k", "kklk"});
  CHECK(chart_of(between).columns == 4);
}

TEST_CASE("chart: rounds that do not add up are a bug") {
  CHECK_THROWS_AS(chart_of(hand_rounds(4, {"kkk"})), Bug);
}

TEST_CASE("chart: whatever is knitted, stitches stand above those they are worked from") {
  double widest = 0.0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    const Rounds rounds = random_rounds(seed);
    const Chart chart = chart_of(rounds);
    check_squares(rounds, chart);
    REQUIRE(chart.columns == least_columns(rounds));
    REQUIRE(chart.columns >= most_stitches(rounds));
    REQUIRE(static_cast<std::size_t>(chart.columns) <= static_cast<std::size_t>(rounds.cast_on) +
                                                           count_of(rounds, Hand::m1r) +
                                                           count_of(rounds, Hand::m1l));
    REQUIRE(chart.rows == chart_of(rounds).rows);
    widest = std::max(widest, static_cast<double>(chart.columns) / most_stitches(rounds));
  }
  CHECK(widest > 1.2);  // some of them must need more columns than they ever have stitches
}

TEST_CASE("chart: a ball is as wide as its widest round, and all stitches keep their columns") {
  for (std::size_t i = 0; i < placement_names.size(); ++i) {
    const auto placement = static_cast<PlacementPolicy>(i);
    for (const double width : {0.15, 0.1}) {
      CAPTURE(static_cast<int>(placement), width);
      const Rounds rounds = rounds_of(sphere_run(width, placement));
      const Chart chart = chart_of(rounds);
      check_squares(rounds, chart);
      CHECK(chart.columns == most_stitches(rounds));
    }
  }
}

TEST_CASE("chart: main wales stand in one column from cast on to bind off") {
  for (const auto follow : {FollowMains::off, FollowMains::on}) {
    const Chart chart = chart_of(rounds_of(sphere_run(0.15, PlacementPolicy::nearest, follow)));
    std::size_t mains = 0;
    for (std::size_t row = 1; row < chart.rows.size(); ++row) {
      for (std::size_t column = 0; column < chart.rows[row].squares.size(); ++column) {
        if (!chart.rows[row].squares[column].main) continue;
        ++mains;
        REQUIRE(chart.rows[row - 1].squares[column].main);
      }
    }
    CHECK(mains > 3 * chart.rows.size());
  }
}
