#include "app/files/chart_svg.h"

#include <array>
#include <cstdio>
#include <cstdlib>

#include "tests/support/catch.h"
#include "tests/support/hand_rounds.h"
#include "tests/support/session.h"
#include "tests/support/xml_check.h"

using namespace app;
using namespace test_support;
using knit::Chart;
using knit::ChartSymbol;

namespace {

std::size_t squares_with(const Chart& chart, ChartSymbol symbol) {
  std::size_t count = 0;
  for (const knit::ChartRow& row : chart.rows) {
    for (const knit::ChartSquare& square : row.squares) count += square.symbol == symbol ? 1U : 0U;
  }
  return count;
}

double attribute_of(const std::string& text, std::size_t from, const std::string& name) {
  const std::size_t at = text.find(" " + name + "=\"", from);
  REQUIRE(at != std::string::npos);
  return std::strtod(text.c_str() + at + name.size() + 3, nullptr);
}

// Of all rectangles of a class, in squares.
double area_of(const std::string& svg, const std::string& look) {
  double area = 0.0;
  const std::string opening = "<rect class=\"" + look + "\"";
  for (std::size_t at = svg.find(opening); at != std::string::npos; at = svg.find(opening, at + 1))
    area += attribute_of(svg, at, "width") * attribute_of(svg, at, "height");
  return area;
}

constexpr std::array<std::pair<ChartSymbol, const char*>, 6> drawn_symbols{
    {{ChartSymbol::m1r, "knit-m1r"},
     {ChartSymbol::m1l, "knit-m1l"},
     {ChartSymbol::k2tog, "knit-k2tog"},
     {ChartSymbol::ssk, "knit-ssk"},
     {ChartSymbol::cast_on, "knit-cast-on"},
     {ChartSymbol::bind_off, "knit-bind-off"}}};

}  // namespace

TEST_CASE("chart svg: well-formed, and every operation is drawn once") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const Chart chart = knit::chart_of(random_rounds(seed));
    ChartLook look;
    look.key = seed % 2 == 0;
    const std::string svg = chart_svg(chart, look);
    REQUIRE(xml_fault(svg) == "");
    for (const auto& [symbol, id] : drawn_symbols) {
      const std::size_t squares = squares_with(chart, symbol);
      const std::size_t in_key = look.key && squares > 0 ? 1 : 0;
      CHECK(occurrences(svg, "<use href=\"#" + std::string(id) + "\"") == squares + in_key);
      CHECK(occurrences(svg, "id=\"" + std::string(id) + "\"") == (squares > 0 ? 1 : 0));
    }
    CHECK(area_of(svg, "none") == static_cast<double>(squares_with(chart, ChartSymbol::no_stitch)));
  }
}

TEST_CASE("chart svg: the key names what is used and nothing else") {
  const Chart chart = knit::chart_of(hand_rounds(4, {"Kkrkk", "K/kk"}));
  const std::string svg = chart_svg(chart, {});
  for (const char* used : {"k: knit", "m1r: ", "k2tog: ", "CO: ", "BO: ", "no stitch", "main line"})
    CHECK(occurrences(svg, ">" + std::string(used)) == 1);
  for (const char* unused : {"m1l", "ssk"}) CHECK_FALSE(contains(svg, unused));

  const std::string plain = chart_svg(knit::chart_of(hand_rounds(4, {"kkkk"})), {});
  CHECK(occurrences(plain, "class=\"key\"") == 3);  // cast on, knit, bind off
  ChartLook bare;
  bare.key = bare.tint_mains = false;
  CHECK_FALSE(contains(chart_svg(chart, bare), "k: knit"));
  CHECK(area_of(chart_svg(chart, bare), "main") == 0.0);
}

TEST_CASE("chart svg: rounds begin at the right, and go up") {
  const Chart chart = knit::chart_of(hand_rounds(6, {"kkkk/", "\\kkk"}));
  ChartLook look;
  look.key = false;
  const std::string svg = chart_svg(chart, look);
  const std::size_t k2tog = svg.find("<use href=\"#knit-k2tog\""), ssk = svg.find("<use href=\"#knit-ssk\"");
  CHECK(attribute_of(svg, k2tog, "x") == 0.0);  // the last stitches: at the left
  CHECK(attribute_of(svg, k2tog, "y") == 2.0);  // bind off, round 3, round 2
  CHECK(attribute_of(svg, ssk, "x") == 5.0);
  CHECK(attribute_of(svg, ssk, "y") == 1.0);
}

TEST_CASE("chart svg: main wales are tinted, a rectangle for a wale") {
  const Chart chart = knit::chart_of(hand_rounds(4, {"Kkkk", "Kkkk"}));
  const std::string svg = chart_svg(chart, {});
  CHECK(occurrences(svg, "class=\"main\"") == 1);
  CHECK(area_of(svg, "main") == 4.0);
}

TEST_CASE("chart svg: strokes lean as the stitches do") {
  const std::string svg = chart_svg(knit::chart_of(hand_rounds(6, {"kr\\kkk", "l/kkkk"})), {});
  for (const auto& [id, to_the_right] :
       {std::pair{"k2tog", true}, {"ssk", false}, {"m1r", true}, {"m1l", false}}) {
    CAPTURE(id);
    const std::size_t at = svg.find(" d=\"", svg.find("id=\"knit-" + std::string(id) + "\""));
    double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;
    REQUIRE(std::sscanf(svg.c_str() + at, " d=\"M%lf %lfL%lf %lf", &x0, &y0, &x1, &y1) == 4);
    REQUIRE(y0 > y1);  // upwards
    CHECK((x1 > x0) == to_the_right);
  }
}

TEST_CASE("chart svg: numbers of rounds and stitches at the edges") {
  const std::string svg = chart_svg(knit::chart_of(hand_rounds(4, {"kkklk", "kkkkk", "kkkkkr"})), {});
  for (const char* text : {">CO<", ">2<", ">3<", ">BO<"}) CHECK(occurrences(svg, text) == 1);
  CHECK(occurrences(svg, ">4<") == 2);  // stitches cast on, and the number of the last round
  CHECK(occurrences(svg, ">5<") == 2);  // stitches of two rounds
  CHECK(occurrences(svg, ">6<") == 1);
}

TEST_CASE("chart svg: fits the sheet, unless its squares would become too small") {
  knit::Rounds rounds = hand_rounds(60, {});
  for (int i = 0; i < 80; ++i) add_round(rounds, operations_of(std::string(60, 'k')));
  const std::string svg = chart_svg(knit::chart_of(rounds), {});
  CHECK(attribute_of(svg, 0, "width") <= 180.0);
  CHECK(attribute_of(svg, 0, "height") <= 255.0);
  const std::string huge = chart_svg(knit::chart_of(hand_rounds(300, {std::string(300, 'k')})), {});
  CHECK(attribute_of(huge, 0, "width") > 1.5 * 300);
  const std::string small = chart_svg(knit::chart_of(hand_rounds(6, {"kkkkkk"})), {});
  CHECK(contains(small, "scale(5.0000)"));
}

TEST_CASE("chart svg: a title is text") {
  ChartLook look;
  look.title = "<b> & \"friends\"";
  const std::string svg = chart_svg(knit::chart_of(hand_rounds(4, {"kkkk"})), look);
  CHECK(xml_fault(svg) == "");
  CHECK(occurrences(svg, "&lt;b&gt; &amp; &quot;friends&quot;") == 2);  // as the document's title and drawn
  CHECK_FALSE(contains(svg, "<b>"));
}

TEST_CASE("chart svg: sheets are turned for charts wider than high") {
  CHECK(is_wide(knit::chart_of(hand_rounds(10, {"kkkkkkkkkk"}))));
  knit::Rounds tall = hand_rounds(4, {});
  for (int i = 0; i < 10; ++i) add_round(tall, operations_of("kkkk"));
  CHECK_FALSE(is_wide(knit::chart_of(tall)));
}

namespace {

knit::Chart plain_chart(std::int32_t columns, int rounds) {
  knit::Rounds all = hand_rounds(columns, {});
  for (int i = 0; i < rounds; ++i)
    add_round(all, operations_of(std::string(static_cast<std::size_t>(columns), 'k')));
  return knit::chart_of(all);
}

double square_of(const std::string& svg) {
  const std::size_t at = svg.find("scale(");
  REQUIRE(at != std::string::npos);
  return std::strtod(svg.c_str() + at + 6, nullptr);
}

}  // namespace

TEST_CASE("chart svg: of pieces, a chart too wide to read is broken into parts") {
  const knit::Chart wide = plain_chart(127, 25), small = plain_chart(10, 8);
  const std::vector<NamedChart> charts{{"Limb A", &small}, {"Body B", &wide}};
  const std::vector<std::string> svgs = charts_svgs(charts, sheet_for(charts));
  REQUIRE(svgs.size() == 4);
  CHECK(contains(svgs[1], "Body B: columns 1 to 64 of 127"));
  CHECK(contains(svgs[2], "Body B: columns 65 to 127 of 127"));
  CHECK(contains(svgs[3], "through all columns of the chart"));
  double height = 0.0;
  for (const std::string& svg : svgs) {
    CHECK(xml_fault(svg) == "");
    CHECK(attribute_of(svg, 0, "width") <= 180.0);
    height += attribute_of(svg, 0, "height");
  }
  CHECK(height <= 246.0);
  for (std::size_t i = 0; i < 3; ++i) CHECK(square_of(svgs[i]) == square_of(svgs[0]));
  CHECK(square_of(svgs[0]) >=
        2.0);  // whole, it would have 1.95 on a sheet put sideways and less on an upright one
  // Every part has the rounds, the last part the counts.
  for (std::size_t i = 1; i < 3; ++i) CHECK(occurrences(svgs[i], ">26<") == 1);
  CHECK(occurrences(svgs[1], ">127<") == 0);
  CHECK(occurrences(svgs[2], ">127<") > 0);
  // One drawing has the same parts.
  CHECK(contains(charts_svg(charts, {}), "Body B: columns 65 to 127 of 127"));
}

TEST_CASE("chart svg: of pieces, a chart is left whole where a sheet put sideways makes it legible") {
  const knit::Chart low = plain_chart(90, 6), small = plain_chart(20, 12);
  const std::vector<NamedChart> upright{{"Limb A", &small}}, both{{"Limb A", &small}, {"Body B", &low}};
  CHECK_FALSE(is_wide(upright));
  CHECK(sheet_for(upright).width_mm == 180.0);
  CHECK(charts_svgs(upright, sheet_for(upright)).size() == 2);
  CHECK(is_wide(both));
  const std::vector<std::string> svgs = charts_svgs(both, sheet_for(both));
  REQUIRE(svgs.size() == 3);
  CHECK(contains(svgs[2], "read every round from right to left.<"));
  // What no sheet holds is broken too, over several.
  const knit::Chart huge = plain_chart(400, 90);
  const std::vector<NamedChart> alone{{"Body A", &huge}};
  for (const std::string& svg : charts_svgs(alone, sheet_for(alone)))
    CHECK(attribute_of(svg, 0, "width") <= sheet_for(alone).width_mm);
}
