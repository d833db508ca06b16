// The document that a knitter gets: its order, its sentences, its sizes.
#include "knit/pattern/written_pattern.h"

#include <cmath>
#include <numbers>
#include <sstream>

#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/pattern_words.h"
#include "knit/run/timeline.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

// Rounds of the given sizes, shaping at the round's end.
Rounds rounds_with(const std::vector<int>& sizes) {
  Rounds rounds;
  rounds.cast_on = sizes.front();
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    Round round{static_cast<std::int32_t>(i) + 1, {}, sizes[i - 1], sizes[i]};
    const int change = sizes[i] - sizes[i - 1];
    const int knits = change >= 0 ? sizes[i - 1] : sizes[i - 1] + 2 * change;
    round.operations.assign(static_cast<std::size_t>(knits), {Hand::knit, false});
    for (int k = 0; k < std::abs(change); ++k)
      round.operations.push_back({change > 0 ? Hand::m1l : Hand::k2tog, false});
    rounds.rounds.push_back(round);
  }
  return rounds;
}

WrittenPattern written(const Rounds& rounds, const PatternOptions& options = {}) {
  return write_pattern(rounds, {22.0, 32.0}, options, "ball");
}

std::string all_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// The numbers of the rounds after which stuffing is told.
std::vector<int> told_after(const WrittenPattern& pattern) {
  std::vector<int> rounds;
  int last = 1;
  for (const auto& instruction : pattern.instructions) {
    if (instruction.round) last = instruction.round->last;
    if (contains(instruction.remark, "Stuff")) rounds.push_back(last);
  }
  return rounds;
}

Rounds ball_of(double height_cm, const Gauge& gauge) {
  Parameters parameters;
  parameters.timing.kind = TimingKind::arc_length;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  give_sizes(parameters, SizesFrom::gauge);
  give_gauge(parameters, gauge);
  parameters.size.height_cm = height_cm;
  Timeline run(make_input(sphere(96, 64)), parameters);
  run.extend_to_end();
  return rounds_of(run.furthest());
}

}  // namespace

TEST_CASE("a round's line says its number, its words and its count") {
  CHECK(RoundLine{7, 7, "[K4, m1l] 6 times", 36}.text() == "Rnd 7: [K4, m1l] 6 times. (36 sts)");
  CHECK(RoundLine{8, 12, "Knit", 30}.text() == "Rnds 8-12: Knit. (30 sts)");
  CHECK(RoundLine{9, 9, "k2tog", 1}.text() == "Rnd 9: k2tog. (1 st)");
}

TEST_CASE("equal rounds that follow each other stand on one line") {
  const std::vector<RoundLine> lines = round_lines(rounds_with({4, 4, 4, 5, 5, 6, 6, 6, 5}), {});
  std::string text;
  for (const RoundLine& line : lines) text += line.text() + "\n";
  CHECK(text ==
        "Rnds 2-3: Knit. (4 sts)\nRnd 4: K4, m1l. (5 sts)\nRnd 5: Knit. (5 sts)\n"
        "Rnd 6: K5, m1l. (6 sts)\nRnds 7-8: Knit. (6 sts)\nRnd 9: K4, k2tog. (5 sts)\n");
}

TEST_CASE("rounds of the same words and other counts are told apart") {
  Rounds rounds;
  rounds.cast_on = 4;
  for (const int below : {4, 8}) {
    Round round{below / 4 + 1, {}, below, 2 * below};
    for (int i = 0; i < below; ++i) {
      round.operations.push_back({Hand::knit, false});
      round.operations.push_back({Hand::m1l, false});
    }
    rounds.rounds.push_back(round);
  }
  const std::vector<RoundLine> lines = round_lines(rounds, {.stars = true});
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].text() == "Rnd 2: *K1, m1l; rep from * to end. (8 sts)");
  CHECK(lines[1].text() == "Rnd 3: *K1, m1l; rep from * to end. (16 sts)");
}

TEST_CASE("the document says all there is, and nothing that the piece does not need") {
  const Rounds rounds = rounds_with({6, 12, 18, 24, 24, 18, 12, 6});
  PatternOptions options;
  options.yarn = "Wool of the Hills";
  options.colour = "moss green";
  options.needle_mm = 3.25;
  const WrittenPattern pattern = written(rounds, options);
  CHECK(pattern.title == "Ball");
  CHECK(pattern.level == "Easy");
  CHECK(pattern.gauge ==
        "22 sts and 32 rnds = 10 cm (4 in) in stockinette, in the round, on 3.25 mm (US 3) needles.");
  const std::string materials = all_of(pattern.materials);
  CHECK(
      contains(materials, "Light (3), Wool of the Hills, in moss green, about 3 m (4 yd), 1 g; 15 % spare"));
  CHECK(contains(materials, "3.25 mm (US 3)"));
  CHECK(contains(materials, "double-pointed"));
  CHECK(contains(materials, "Stuffing."));
  CHECK(contains(materials, "Tapestry needle."));
  std::vector<std::string> words;
  for (const auto& [word, meaning] : pattern.abbreviations) words.push_back(word);
  CHECK(words == std::vector<std::string>{"CO", "k", "k2tog", "m1l", "rnd(s)", "st(s)"});
  CHECK(pattern.start ==
        "Using double-pointed needles, CO 6 sts (Rnd 1). Join to work in the round, being careful not to "
        "twist. "
        "Place marker.");
  CHECK(pattern.instructions.back().remark ==
        "Break yarn, thread through remaining 6 sts and pull tightly. Fasten off.");
  CHECK(contains(pattern.finishing.front(), "through the 6 sts of the cast-on edge"));
}

TEST_CASE("a tube stays open at both ends and is not stuffed") {
  const WrittenPattern pattern = written(rounds_with({93, 93, 93, 94, 94}), {.title = "Cuff"});
  CHECK(pattern.title == "Cuff");
  CHECK(contains(pattern.start, "Using a circular needle, CO 93 sts (Rnd 1)."));
  CHECK(pattern.instructions.back().remark == "BO all 94 sts.");
  CHECK(pattern.finishing.front() == "The cast-on edge stays open.");
  CHECK_FALSE(contains(all_of(pattern.materials), "Stuffing"));
  CHECK_FALSE(contains(all_of(pattern.materials), "double-pointed"));
  CHECK(told_after(pattern).empty());
  CHECK(pattern.abbreviations.front().first == "BO");
  CHECK(written(rounds_with({30, 30})).level == "Basic");
}

TEST_CASE("what does not go around a circular needle is begun on double-pointed ones") {
  // 92 stitches at 22 in 10 cm are 41.8 cm, and a needle of 40 cm is too long for fewer.
  for (const std::int32_t cast_on : {9, 30, 92}) {
    const WrittenPattern pattern = written(rounds_with({cast_on, cast_on, cast_on}));
    CHECK(contains(pattern.start, "Using double-pointed needles, CO "));
    CHECK_FALSE(contains(all_of(pattern.materials), "circular"));
  }
  const WrittenPattern narrows = written(rounds_with({93, 93, 60, 30, 16, 8}));
  CHECK(contains(all_of(narrows.materials), "circular, and a set of five double-pointed."));
  const WrittenPattern widens = written(rounds_with({30, 60, 93, 93}));
  CHECK(contains(widens.start, "Using double-pointed needles, CO 30 sts"));
  CHECK(contains(all_of(widens.materials), "double-pointed and, for the wide part, a 40 cm"));
}

TEST_CASE("twelve stitches are drawn in, thirteen bound off") {
  CHECK(contains(written(rounds_with({6, 12, 12})).instructions.back().remark, "remaining 12 sts"));
  CHECK(written(rounds_with({6, 12, 13})).instructions.back().remark == "BO all 13 sts.");
}

TEST_CASE("stuffing is told while the opening is wide") {
  // 40 % of 60 is 24: the last round that has them.
  CHECK(stuffed_after(rounds_with({6, 12, 24, 40, 60, 60, 40, 24, 23, 12, 6})) == std::vector<int>{8});
  CHECK(told_after(written(rounds_with({6, 12, 24, 40, 60, 60, 40, 24, 23, 12, 6}))) == std::vector<int>{8});
  // Never at an opening of fewer than 12, and not at all in what is narrower.
  CHECK(stuffed_after(rounds_with({6, 12, 20, 20, 13, 11, 8, 6})) == std::vector<int>{5});
  CHECK(stuffed_after(rounds_with({6, 11, 11, 6})).empty());
  // A neck is stuffed up to, before it is too narrow for the part below.
  CHECK(stuffed_after(rounds_with({6, 12, 24, 40, 60, 30, 15, 10, 20, 40, 30, 15, 8})) ==
        std::vector<int>{6, 11});
  CHECK(stuffed_after(rounds_with({6, 12, 24, 40, 60, 30, 20, 20, 40, 30, 15, 8})) == std::vector<int>{10});
  // Ends that stay open.
  CHECK(stuffed_after(rounds_with({6, 12, 24, 40, 40})).empty());
  CHECK(stuffed_after(rounds_with({40, 40, 20, 10})).empty());
}

TEST_CASE("markers and stars are explained where they are used") {
  Rounds rounds = rounds_with({12, 12});
  rounds.rounds.clear();
  Round round{2, {}, 12, 16};
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) round.operations.push_back({Hand::knit, k == 0});
    round.operations.push_back({Hand::m1l, false});
  }
  rounds.rounds.push_back(round);
  const WrittenPattern plain = written(rounds);
  const WrittenPattern marked = written(rounds, {.markers = true});
  const WrittenPattern starred = written(rounds, {.stars = true});
  CHECK(plain.instructions.front().round->words == "[K3, m1l] 4 times");
  CHECK(marked.instructions.front().round->words == "[sm, K3, m1l] 4 times");
  CHECK(starred.instructions.front().round->words == "*K3, m1l; rep from * to end");
  CHECK(contains(all_of(marked.materials), "and 3 in another colour"));
  CHECK(contains(all_of(marked.notes), "main lines"));
  CHECK_FALSE(contains(all_of(plain.notes), "main lines"));
  CHECK(contains(all_of(plain.notes), "in [ ] the total number of times"));
  CHECK_FALSE(contains(all_of(starred.notes), "in [ ] the total number of times"));
  CHECK(contains(pattern_as_text(starred), "rep: repeat"));
  CHECK(contains(pattern_as_text(marked), "sm: slip marker"));
  CHECK_FALSE(contains(pattern_as_text(plain), "sm: slip marker"));
}

TEST_CASE("only rounds begin like rounds, and other lines are not wider than a page") {
  for (const Rounds& rounds : {ball_of(6.0, {22.0, 32.0}), rounds_with({30, 31, 31, 30})}) {
    std::size_t expected = 0;
    const WrittenPattern pattern = written(rounds);
    for (const auto& instruction : pattern.instructions) expected += instruction.round ? 1 : 0;
    for (const std::string& text : {pattern_as_text(pattern), pattern_as_markdown(pattern)}) {
      std::size_t found = 0;
      for (const std::string& line : lines_of(text)) {
        const bool is_round = line.rfind("Rnd", 0) == 0;
        found += is_round ? 1 : 0;
        if (is_round) CHECK(line.substr(line.size() - 5) == " sts)");
      }
      CHECK(found == expected);
    }
    for (const std::string& line : lines_of(pattern_as_text(pattern)))
      CHECK((line.size() <= 100 || line.rfind("Rnd", 0) == 0));
  }
}

TEST_CASE("the parts of the document stand in the usual order") {
  const WrittenPattern pattern = written(rounds_with({6, 12, 12, 6}));
  for (const std::string& text : {pattern_as_text(pattern), pattern_as_markdown(pattern)}) {
    std::size_t at = 0;
    for (const std::string part : {"Ball", "Project level: Easy", "About ", "Yarn: ", "22 sts and 32 rnds",
                                   "CO", "Worked in the round", "CO 6 sts", "Rnd 2: ", "Break yarn",
                                   "Thread the cast-on tail", "Weave in"}) {
      INFO(part);
      at = text.find(part, at);
      REQUIRE(at != std::string::npos);
    }
  }
}

TEST_CASE("Markdown shows what the person typed, signs and all") {
  const WrittenPattern pattern = written(rounds_with({6, 12, 6}), {.title = "A *bright* ball_1"});
  CHECK(contains(pattern_as_markdown(pattern), "# A \\*bright\\* ball\\_1\n"));
}

TEST_CASE("an open tube is as high as its rounds, a flat disc has no height") {
  const PatternSizes tube = sizes_of(rounds_with(std::vector<int>(64, 44)), {22.0, 32.0});
  CHECK(tube.height_cm == Approx(20.0));
  CHECK(tube.length_cm == Approx(20.0));
  CHECK(tube.around_cm == Approx(20.0));
  CHECK(tube.yarn_m == Approx(64 * 44 * 0.017271).epsilon(1e-4));
  // 22 / 32 * 2 pi = 4.32 stitches more a round are flat.
  std::vector<int> disc;
  for (int i = 1; i <= 20; ++i) disc.push_back(4 * i + i * 32 / 100 + 1);
  CHECK(sizes_of(rounds_with(disc), {22.0, 32.0}).height_cm < 1.0);
}

TEST_CASE("a ball of 12 cm is finished at 12 cm both ways") {
  const Gauge gauge{22.0, 32.0};
  const Rounds ball = ball_of(12.0, gauge);
  const PatternSizes sizes = sizes_of(ball, gauge);
  CHECK(sizes.height_cm == Approx(12.0).epsilon(0.02));
  CHECK(sizes.around_cm / std::numbers::pi == Approx(12.0).epsilon(0.02));
  // Half a great circle.
  CHECK(sizes.length_cm == Approx(6.0 * std::numbers::pi).epsilon(0.03));
  const WrittenPattern pattern = write_pattern(ball, gauge, {}, "ball");
  CHECK(pattern.size.front() ==
        "About 12 cm (4.7 in) high and 12 cm (4.7 in) across when stuffed; 37.5 cm (14.8 in) around.");
  // Two printed pages of 60 lines.
  CHECK(lines_of(pattern_as_text(pattern)).size() <= 120);
  CHECK(told_after(pattern).size() == 1);
}
