// The chart as characters, and its symbols' strokes.
#include "knit/pattern/chart.h"

#include <sstream>

#include "app/describe/chart_strokes.h"
#include "knit/reader/pattern_reader.h"
#include "tests/support/catch.h"
#include "tests/support/hand_rounds.h"
#include "tests/support/session.h"

using namespace knit;
using test_support::contains;
using test_support::hand_rounds;

namespace {

Chart small_chart() { return chart_of(hand_rounds(4, {"klkklk", "kkkkkk", "k/k\\"})); }

// The lines between two strokes of the pen: the grid's own.
std::vector<std::string> grid_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (const std::string& line : test_support::lines_of(text)) {
    if (line.find('|') != std::string::npos) lines.push_back(line);
  }
  return lines;
}

}  // namespace

TEST_CASE("chart text: a small chart, character by character") {
  CHECK(chart_as_text(small_chart()) ==
        "\nCHART\n"
        "Read from the bottom up, every round from right to left. At the right stands the round's\n"
        "number, at the left how many stitches there are after it.\n"
        "\n"
        "  (blank)  k: knit\n"
        "     L     m1l: make 1 left\n"
        "     /     k2tog: knit 2 together\n"
        "     \\     ssk: slip, slip, knit\n"
        "     o     CO: cast on\n"
        "     =     BO: bind off or close up\n"
        "     :     no stitch: skip it\n"
        "\n"
        "  |:===:=|\n"
        "4 |:\\ /: | 4\n"
        "6 |      | 3\n"
        "6 | L  L | 2\n"
        "4 |o:oo:o| 1\n");
}

TEST_CASE("chart text: one character a square, rounds upwards, the first stitch at the right") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const Chart chart = chart_of(test_support::random_rounds(seed));
    if (chart.columns > widest_text_chart) continue;
    const std::vector<std::string> lines = grid_lines(chart_as_text(chart));
    REQUIRE(lines.size() == chart.rows.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const ChartRow& row = chart.rows[chart.rows.size() - 1 - i];
      const std::size_t low = lines[i].find('|');
      const std::size_t high = lines[i].rfind('|');
      REQUIRE(high - low - 1 == row.squares.size());
      for (std::size_t column = 0; column < row.squares.size(); ++column)
        CHECK(lines[i][high - 1 - column] == sign_of(row.squares[column].symbol).sign);
      if (i == 0) continue;  // the bind off has neither count nor number
      CHECK(std::stoi(lines[i].substr(0, low)) == row.stitches);
      CHECK(std::stoi(lines[i].substr(high + 1)) == row.number);
    }
  }
}

TEST_CASE("chart text: columns are counted from the right in tens") {
  const Chart chart = chart_of(hand_rounds(23, {std::string(23, 'k')}));
  const auto lines = test_support::lines_of(chart_as_text(chart));
  const std::string& ruler = lines.back();
  const std::string& row = lines[lines.size() - 2];
  const std::size_t edge = row.rfind('|');
  CHECK(ruler.find("20") == edge - 20);
  CHECK(ruler.find("10") == edge - 10);
}

TEST_CASE("chart text: too wide a chart says where it is to be had") {
  const auto wide = static_cast<int>(widest_text_chart) + 1;
  const std::string text =
      chart_as_text(chart_of(hand_rounds(wide, {std::string(static_cast<std::size_t>(wide), 'k')})));
  CHECK(contains(text, "101 squares wide"));
  CHECK(contains(text, "--save-chart"));
  CHECK(grid_lines(text).empty());
  const std::string fits =
      chart_as_text(chart_of(hand_rounds(wide - 1, {std::string(static_cast<std::size_t>(wide - 1), 'k')})));
  CHECK(grid_lines(fits).size() == 3);
}

TEST_CASE("chart text: in Markdown the grid stands in a block of code") {
  const std::string text = chart_as_markdown(small_chart());
  const std::size_t block = text.find("```text\n");
  REQUIRE(block != std::string::npos);
  CHECK(text.find('|') > block);
  CHECK(text.substr(text.size() - 4) == "```\n");
}

// Nothing in it may be a round, a cast on or an end, at whatever width lines are joined.
TEST_CASE("chart text: a reader of patterns passes over it") {
  const std::string pattern = "CO 6 sts.\nRnd 1: Knit. (6 sts)\nBO all sts.\n";
  for (unsigned seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const Chart chart = chart_of(test_support::random_rounds(seed));
    for (const std::string& section : {chart_as_text(chart), chart_as_markdown(chart)}) {
      const ReadPattern read = read_pattern(pattern + section);
      CHECK(read.mistakes.empty());
      CHECK(read.rounds_read == 1);
      CHECK(read_pattern(section + pattern).mistakes.empty());
    }
  }
}

TEST_CASE("chart strokes: every symbol but blank ones is drawn, inside its square") {
  for (const app::ChartShape& shape : app::chart_shapes) {
    CAPTURE(sign_of(shape.symbol).meaning);
    CHECK(&app::shape_of(shape.symbol) == &shape);
    CHECK(shape.strokes.empty() == shape.id.empty());
    for (const app::ChartStroke& stroke : shape.strokes) {
      for (const app::ChartPoint& point : {stroke.from, stroke.to}) {
        CHECK((point.x > 0.1 && point.x < 0.9));
        CHECK((point.y > 0.1 && point.y < 0.9));
      }
    }
  }
}

TEST_CASE("chart strokes: as an SVG path, strokes that go on are one line") {
  CHECK(app::svg_path(app::chart_strokes::m1r) == "M.28 .84L.8 .18M.52 .54L.24 .2");
  CHECK(app::svg_path(app::chart_strokes::cast_on) == "M.26 .3L.26 .5Q.26 .74 .5 .74Q.74 .74 .74 .5L.74 .3");
  CHECK(app::svg_path(app::chart_strokes::bind_off) == "M.2 .64Q.5 .16 .8 .64");
}

// k2tog leans right and ssk left; each increase is the other's mirror image.
TEST_CASE("chart strokes: symbols lean as the stitches do") {
  const auto leans_right = [](const app::ChartStroke& stroke) { return stroke.to.x > stroke.from.x; };
  CHECK(leans_right(app::chart_strokes::k2tog.front()));
  CHECK_FALSE(leans_right(app::chart_strokes::ssk.front()));
  for (std::size_t i = 0; i < 2; ++i) {
    const app::ChartStroke& right = app::chart_strokes::m1r.at(i);
    const app::ChartStroke& left = app::chart_strokes::m1l.at(i);
    CHECK(right.from.x + left.from.x == Approx(1.0));
    CHECK(right.to.x + left.to.x == Approx(1.0));
    CHECK(right.from.y == left.from.y);
  }
}
