// Short rows in words and back: the lines that hands read, and needles that work them to the very graph.
#include "app/files/pattern_export.h"
#include "knit/pattern/chart.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/written_pattern.h"
#include "knit/reader/pattern_reader.h"
#include "knit/stitches/appendix.h"
#include "tests/support/catch.h"
#include "tests/support/random_short_rows.h"
#include "tests/support/repeated.h"

using namespace knit;

namespace {

constexpr Gauge gauge{22.0, 32.0};
using Lines = std::vector<std::string>;

Round plain_round(std::int32_t number, std::int32_t stitches, std::vector<ShortRowPair> pairs) {
  const Operation knit_one;
  return {number, {static_cast<std::size_t>(stitches), knit_one}, stitches, stitches, std::move(pairs)};
}

Rounds plain_rounds(std::int32_t stitches, std::vector<ShortRowPair> pairs) {
  return {stitches, {plain_round(2, stitches, std::move(pairs))}};
}

Lines lines_of(const Rounds& rounds, ShortRowTurns turns = ShortRowTurns::german) {
  PatternOptions options;
  options.turns = turns;
  Lines lines;
  for (const RoundLine& line : round_lines(rounds, options)) lines.push_back(line.text());
  return lines;
}

std::string written(const Rounds& rounds, ShortRowTurns turns) {
  PatternOptions options;
  options.turns = turns;
  return pattern_as_text(write_pattern(rounds, gauge, options, "piece"));
}

std::string first_mistake(const std::string& text) {
  const ReadPattern read = read_pattern(text);
  return read.mistakes.empty() ? "" : read.mistakes.front().sentence;
}

void check_reads_back(const std::string& text, const KnitGraph& graph) {
  const ReadPattern read = read_pattern(text);
  if (!read.mistakes.empty()) {
    CAPTURE(text, read.mistakes.front().sentence);
    FAIL_CHECK("the reader finds a mistake");
    return;
  }
  CAPTURE(text);
  CHECK(read.short_rows == graph.short_rows);
  CHECK(graph_of(read.rounds) == graph);
}

// The numbers behind k and p in lines of short rows.
std::vector<std::size_t> counted_runs(const std::string& text) {
  std::vector<std::size_t> places;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    const bool worked = line.starts_with("Short row") || line.starts_with("Next row") ||
                        line.find("(cont.)") != std::string::npos;
    const std::size_t colon = line.find(": ");
    for (std::size_t i = colon; worked && colon != std::string::npos && i + 1 < line.size(); ++i) {
      const bool word = line[i - 1] == ' ' && std::string("KkPp").find(line[i]) != std::string::npos;
      const bool counted = line[i + 1] >= '0' && line[i + 1] <= '9' &&
                           line.find("tog", i) != i + 2;  // k2tog is no number of stitches
      if (word && counted) places.push_back(begin + i + 1);
    }
    begin = end + 1;
  }
  return places;
}

std::string changed_at(const std::string& text, std::size_t place, int by) {
  std::size_t end = place;
  while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
  const int number = std::stoi(text.substr(place, end - place));
  return text.substr(0, place) + std::to_string(number + by) + text.substr(end);
}

}  // namespace

TEST_CASE("short rows: a pair within the round is the published round") {
  const Rounds rounds = plain_rounds(10, {{1, 4}});
  CHECK(lines_of(rounds) == Lines{"Short row 1 (RS): K6, turn. (6 sts after BOR)",
                                  "Short row 2 (WS): DS, p5, turn. (at BOR)",
                                  "Rnd 2 (cont.): DS, knit to end. (10 sts)"});
  CHECK(lines_of(rounds, ShortRowTurns::wrap) == Lines{"Short row 1 (RS): K5, w&t. (5 sts after BOR)",
                                                       "Short row 2 (WS): P4, w&t. (1 st after BOR)",
                                                       "Rnd 2 (cont.): Knit to end. (10 sts)"});
}

TEST_CASE("short rows: a pair over the beginning of the round stands alone before it") {
  const Rounds rounds = plain_rounds(31, {{-3, 3}});
  CHECK(lines_of(rounds) == Lines{"Short row 1 (RS): K5, turn. (5 sts after BOR)",
                                  "Short row 2 (WS): DS, p4, sm, p4, turn. (4 sts before BOR)",
                                  "Next row (RS): DS, k3 to BOR.", "Rnd 2: Knit. (31 sts)"});
  CHECK(lines_of(rounds, ShortRowTurns::wrap) ==
        Lines{"Short row 1 (RS): K4, w&t. (4 sts after BOR)",
              "Short row 2 (WS): P4, sm, p3, w&t. (3 sts before BOR)", "Next row (RS): K3 to BOR.",
              "Rnd 2: Knit. (31 sts)"});
}

TEST_CASE("short rows: the graph says where each row stands and what of the round is worked by then") {
  const KnitGraph graph = graph_of(plain_rounds(31, {{5, 9}, {-3, 3}}));
  REQUIRE(graph.rows.size() == 2);
  CHECK(graph.short_rows == std::vector<GraphShortRow>{{0, 0, 4, false, 0},
                                                       {0, 3, 7, true, 0},
                                                       {0, -3, 3, false, 0},
                                                       {0, 5, 5, false, 5},
                                                       {0, 9, 5, true, 5}});
  CHECK(graph.rows[1] == graph_of(plain_rounds(31, {})).rows[1]);
}

TEST_CASE("short rows: shaping before the turn counts in where it is turned") {
  Rounds rounds = plain_rounds(12, {{4, 8}});
  Round& round = rounds.rounds.front();
  round.operations.insert(round.operations.begin() + 1, Operation{Hand::m1l});
  round.after = 13;
  const Lines lines = lines_of(rounds);
  CHECK(lines == Lines{"Short row 1 (RS): K1, m1l, k9, turn. (11 sts after BOR)",
                       "Short row 2 (WS): DS, p6, turn. (4 sts after BOR)",
                       "Rnd 2 (cont.): DS, knit to end. (13 sts)"});
}

TEST_CASE("short rows: rounds on one line break at a pair") {
  Rounds rounds{20, {}};
  for (std::int32_t number = 2; number <= 9; ++number) rounds.rounds.push_back(plain_round(number, 20, {}));
  rounds.rounds[3].pairs = {{-4, 4}};
  rounds.rounds[5].pairs = {{6, 12}};
  CHECK(lines_of(rounds) == Lines{"Rnds 2-4: Knit. (20 sts)", "Short row 1 (RS): K6, turn. (6 sts after BOR)",
                                  "Short row 2 (WS): DS, p5, sm, p5, turn. (5 sts before BOR)",
                                  "Next row (RS): DS, k4 to BOR.", "Rnd 5: Knit. (20 sts)",
                                  "Rnd 6: Knit. (20 sts)", "Short row 1 (RS): K14, turn. (14 sts after BOR)",
                                  "Short row 2 (WS): DS, p8, turn. (5 sts after BOR)",
                                  "Rnd 7 (cont.): DS, knit to end. (20 sts)", "Rnds 8-9: Knit. (20 sts)"});
  check_reads_back(app::pattern_knitspeak(rounds), graph_of(rounds));
}

TEST_CASE("short rows: what a knitter must know of them is explained") {
  const std::string german = written(plain_rounds(31, {{-3, 3}}), ShortRowTurns::german);
  for (const char* const word : {"BOR: ", "DS: ", "p: ", "RS, WS: ", "sm: ", "turn: ", "double stitch (DS)"})
    CHECK(german.find(word) != std::string::npos);
  CHECK(german.find("w&t") == std::string::npos);
  const std::string wrap = written(plain_rounds(31, {{5, 9}}), ShortRowTurns::wrap);
  CHECK(wrap.find("w&t: ") != std::string::npos);
  CHECK(wrap.find("DS") == std::string::npos);
  CHECK(wrap.find("sm: ") == std::string::npos);
  const std::string none = written(plain_rounds(31, {}), ShortRowTurns::german);
  CHECK(none.find("BOR") == std::string::npos);
}

TEST_CASE("short rows: pairs that cannot be worked are told") {
  const auto works = [](std::vector<ShortRowPair> pairs) {
    return can_be_worked(plain_round(2, 10, std::move(pairs)));
  };
  CHECK(works({{1, 8}}));
  CHECK_FALSE(works({{0, 4}}));
  CHECK_FALSE(works({{1, 9}}));
  CHECK_FALSE(works({{3, 4}}));
  CHECK(works({{-4, 3}}));
  CHECK_FALSE(works({{-4, 4}}));
  CHECK_FALSE(works({{-4, -1}}));
  Round shaped = plain_round(2, 10, {{2, 5}});
  CHECK(can_be_worked(shaped));
  shaped.operations.insert(shaped.operations.begin() + 2, Operation{Hand::m1l});
  CHECK_FALSE(can_be_worked(shaped));
}

TEST_CASE("short rows: two thousand random tubes come back from both techniques") {
  for (std::uint32_t seed = 0; seed < test_support::repeated_deep(2000U); ++seed) {
    const Rounds rounds = test_support::random_short_row_rounds(seed);
    const KnitGraph graph = graph_of(rounds);
    CAPTURE(seed);
    for (const ShortRowTurns turns : {ShortRowTurns::german, ShortRowTurns::wrap})
      check_reads_back(written(rounds, turns), graph);
  }
}

TEST_CASE("short rows: every document holds the same rounds") {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Rounds rounds = test_support::random_short_row_rounds(seed);
    const KnitGraph graph = graph_of(rounds);
    const WrittenPattern pattern = write_pattern(rounds, gauge, {}, "piece");
    const Chart chart = chart_of(rounds);
    CAPTURE(seed);
    check_reads_back(pattern_as_text(pattern) + chart_as_text(chart), graph);
    check_reads_back(pattern_as_markdown(pattern) + chart_as_markdown(chart), graph);
    check_reads_back(app::pattern_html(pattern, chart), graph);
    check_reads_back(app::pattern_knitspeak(rounds), graph);
  }
}

TEST_CASE("short rows: a text with one number changed is refused") {
  std::size_t changed = 0, refused = 0;
  for (std::uint32_t seed = 0; seed < test_support::repeated_deep(2000U); ++seed) {
    const Rounds rounds = test_support::random_short_row_rounds(seed);
    test_support::PatternDice dice(seed);
    for (const ShortRowTurns turns : {ShortRowTurns::german, ShortRowTurns::wrap}) {
      const std::string text = written(rounds, turns);
      const std::vector<std::size_t> places = counted_runs(text);
      if (places.empty()) continue;
      const auto which = static_cast<std::size_t>(dice.roll(0, static_cast<int>(places.size()) - 1));
      ++changed;
      const std::string other = changed_at(text, places[which], dice.chance(50) ? 1 : -1);
      CAPTURE(seed, other);
      const bool blamed = !first_mistake(other).empty();
      CHECK(blamed);
      refused += blamed ? 1U : 0U;
    }
  }
  CHECK(changed > 200);
  CHECK(refused == changed);
}

TEST_CASE("short rows: the reader says what does not add up") {
  const auto said = [](const std::string& lines) { return first_mistake("CO 12 sts (Rnd 1).\n" + lines); };
  const std::string out = "Short row 1 (RS): K6, turn. (6 sts after BOR)\n";
  const std::string back = "Short row 2 (WS): DS, p3, turn. (2 sts after BOR)\n";
  const std::string rest = "Rnd 2 (cont.): DS, knit to end. (12 sts)\n";
  CHECK(said(out + back + rest).empty());
  CHECK(said("Short row 1 (WS): P6, turn. (6 sts after BOR)\n") ==
        "line 2: the needles show the RS here, the line says WS.");
  CHECK(said(out + "Short row 2 (WS): P3, turn. (2 sts after BOR)\n") ==
        "line 3: after a turn the first stitch must be a DS.");
  CHECK(said("Short row 1 (RS): DS, k6, turn. (6 sts after BOR)\n") ==
        "line 2: DS without a turn before it.");
  CHECK(said("Short row 1 (RS): Turn. (at BOR)\nShort row 2 (WS): DS, p3, turn. (4 sts before BOR)\n") ==
        "line 3: DS is not made from the stitch that was worked last.");
  CHECK(said(out + "Short row 2 (WS): DS, k3, turn. (2 sts after BOR)\n") ==
        "line 3: k on the WS of stockinette.");
  CHECK(said("Short row 1 (RS): K3, sm, k2, turn. (5 sts after BOR)\n") ==
        "line 2: the marker is not here: 3 stitches away.");
  CHECK(said(out +
             "Short row 2 (WS): DS, p5, sm, p3, turn. (3 sts before BOR)\nNext row (RS): DS, k1 to BOR.\n") ==
        "line 4: BOR is 1 stitch away.");
  CHECK(said("Short row 1 (RS): K6, turn. (7 sts after BOR)\n") ==
        "line 2: the turn is 6 stitches after BOR, the line says 7 after BOR.");
  CHECK(said(out + back + "Rnd 2 (cont.): DS, k8. (12 sts)\n") == "line 4: Rnd 2 works 11 of 12 stitches.");
  CHECK(said(out + back + "Rnd 2 (cont.): DS, knit to end. (13 sts)\n") ==
        "line 4: Rnd 2 makes 12 stitches, the line says 13.");
  CHECK(said("Short row 1 (RS): K6. (6 sts after BOR)\n") == "line 2: a short row must end with a turn.");
  CHECK(said("Short row 1 (RS): K13, turn. (13 sts after BOR)\n") ==
        "line 2: the round has no more stitches.");
  CHECK(said("Short row 1 (RS): K6, turn.\n") ==
        "line 2: say where the short row turns: (6 stitches after BOR).");
  CHECK(said(out + back + "Rnd 2: Knit. (12 sts)\n") ==
        "line 4: Rnd 2 begins 2 stitches after the BOR; go on to the BOR first, or say (cont.).");
  CHECK(said("Rnd 2 (cont.): Knit to end. (12 sts)\n") == "line 2: no short row was worked before it.");
  CHECK(said(out + back + "BO all sts.\n").find("the round after the short rows is missing") !=
        std::string::npos);
  CHECK(said(out + back) == "line 3: the text ends, and the round after the short rows is missing.");
  CHECK(said(out + "Short row 3 (WS): DS, p3, turn. (2 sts after BOR)\n") ==
        "line 3: Short row 3 stands here, and Short row 2 comes next.");
  CHECK(said(out + "Short row 2 (WS): DS, p3, hop, turn. (2 sts after BOR)\n") ==
        "line 3: not understood: \"hop\".");
}

TEST_CASE("short rows: the chart has a row for each, with its hook and the marked stitch") {
  Rounds rounds = plain_rounds(10, {{1, 4}});
  rounds.rounds.push_back(plain_round(3, 10, {{-2, 2}}));
  const Chart chart = chart_of(rounds);
  // A double stitch is worked in the row that comes to it next: those of the wrong side in the round above.
  CHECK(chart_grid(chart) ==
        "   |==========|\n"
        "10 |  V   V   | 3\n"
        "   |  ::::::::| next\n"
        "s2 |  (::::   |\n"
        "   |::::::)  V| s1\n"
        "10 |    V     | 2\n"
        "s2 |:::::    (|\n"
        "   |::::)    :| s1\n"
        "10 |oooooooooo| 1\n"
        "    10\n");
  const std::string key = chart_key({&chart});
  CHECK(key.find("V     a double or wrapped stitch") != std::string::npos);
  CHECK(key.find("s1    a short row") != std::string::npos);
  CHECK(key.find("next  on from the last turn") != std::string::npos);
  CHECK_FALSE(has_way_home(chart_of(plain_rounds(10, {{1, 4}}))));
  CHECK(chart.row_of(2) == 3);
  CHECK(chart.row_of(3) == 7);
  CHECK_FALSE(has_short_rows(chart_of(plain_rounds(10, {}))));
}

TEST_CASE("short rows: the chart numbers them as their lines do") {
  std::size_t homes = 0, after = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const Rounds rounds = test_support::random_short_row_rounds(seed);
    Lines said, drawn;
    for (const RoundLine& line : round_lines(rounds, {})) {
      if (!line.short_row) continue;
      const bool home = line.label == "Next row (RS)", goes_on = !said.empty() && said.back() == "next";
      said.push_back(home ? "next" : "s" + line.label.substr(10, line.label.find(' ', 10) - 10));
      homes += home ? 1 : 0;
      after += goes_on && said.back() != "s1" ? 1 : 0;
    }
    for (const ChartRow& row : chart_of(rounds).rows)
      if (row.short_row > 0) drawn.push_back(name_of(row));
    CAPTURE(seed);
    CHECK(said == drawn);
  }
  CHECK(homes > 20);
  CHECK(after > 5);
}

TEST_CASE("short rows: a pair adds its height where it is worked") {
  const auto sizes = [](const Rounds& rounds) { return sizes_of(rounds, gauge); };
  const double row = 10.0 / gauge.rounds, plain = sizes(plain_rounds(30, {})).height_cm;
  CHECK(sizes(plain_rounds(30, {})).longer_cm == plain);
  const auto check = [&](std::vector<ShortRowPair> pairs, double shorter, double longer) {
    const PatternSizes made = sizes(plain_rounds(30, std::move(pairs)));
    CHECK(made.height_cm == Approx(plain + shorter * row));
    CHECK(made.longer_cm == Approx(plain + longer * row));
  };
  check({{-4, 4}}, 0, 2);
  check({{-4, 4}, {-8, 8}, {10, 20}}, 0, 4);
  check({{-10, 10}, {5, 25}}, 2, 4);  // all round, and twice where they overlap
  const auto size_of_piece = [](const Rounds& rounds) {
    return write_pattern(rounds, gauge, {}, "piece").size.front();
  };
  Rounds bent = plain_rounds(30, {{-4, 4}});
  for (std::int32_t number = 3; number < 33; ++number)
    bent.rounds.push_back(plain_round(number, 30, {{-8, 8}}));
  CHECK(size_of_piece(bent) ==
        "About 10 cm (3.9 in) along its shorter side, 29.5 cm (11.6 in) along its longer, 13.5 cm (5.3 in) "
        "around at the widest.");
  for (Round& round : bent.rounds) round.pairs.clear();
  CHECK(size_of_piece(bent) == "About 10 cm (3.9 in) high, 13.5 cm (5.3 in) around at the widest.");
}

TEST_CASE("short rows: a list of labels says on which row and stitch it stands") {
  CHECK(text_of(LabelRow{12, std::nullopt, {Label::knit, Label::main, Label::knit}, 2, -5}) ==
        "12.2 @-5: [0, 6, 0]");
  CHECK(text_of(LabelRow{12, std::nullopt, {Label::knit}}) == "12: [0]");
}

TEST_CASE("short rows: after a mistake among them the next count stands") {
  const ReadPattern read = read_pattern(
      "CO 12 sts (Rnd 1).\nShort row 1 (RS): K5, turn. (6 sts after BOR)\nShort row 2 (WS): DS, p3, turn. (2 "
      "sts "
      "after BOR)\nRnd 2 (cont.): DS, knit to end. (12 sts)\nRnd 3: Knit. (12 sts)\nRnd 4: K11. (12 sts)\n");
  REQUIRE(read.mistakes.size() == 2);
  CHECK(read.mistakes[0].line == 2);
  CHECK(read.mistakes[1].line == 6);
}
