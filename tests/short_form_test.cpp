// The short form of a pattern says the very rounds that the long form says, and the checker proves both.
#include "knit/pattern/short_form.h"

#include <algorithm>
#include <random>
#include <sstream>

#include "knit/model/stitch_size.h"
#include "knit/reader/pattern_reader.h"
#include "tests/support/catch.h"
#include "tests/support/random_pattern.h"
#include "tests/support/repeated.h"
#include "tests/support/rhythm_rounds.h"

using namespace knit;
using test_support::RhythmRounds;
using test_support::SectionStyle;

namespace {

// The ball of the rhythm study: 8 more every 2nd round six times, every 3rd round three times, and back.
Rounds ball(SectionStyle style) {
  const std::int32_t sections = style == SectionStyle::pairs ? 4 : 8;
  RhythmRounds made(sections, 8, style);
  made.grow(1, 6).grow(2, 3).plain(16).shrink(2, 3).shrink(1, 6);
  return made.rounds();
}

std::string short_text(const Rounds& rounds) {
  return pattern_as_text(write_pattern(rounds, {22.0, 32.0}, {.form = PatternForm::short_form}, "ball"));
}

std::vector<std::string> lines_of(const ShortForm& form) {
  std::vector<std::string> lines;
  for (const NamedRound& round : form.named) lines.push_back(round.text());
  for (const RoundLine& line : form.lines) lines.push_back(line.text());
  return lines;
}

void check_says_the_same(const Rounds& rounds, const std::string& text) {
  const ReadPattern read = read_pattern(text);
  CAPTURE(text);
  for (const PatternMistake& mistake : read.mistakes) FAIL_CHECK(mistake.sentence);
  CHECK(graph_of(read.rounds) == graph_of(rounds));
}

// The first number of the line, one more.
std::string with_another_number(const std::string& line, std::size_t which) {
  std::size_t at = 0;
  for (std::size_t i = 0; i <= which; ++i) {
    at = line.find_first_of("0123456789", at);
    if (at == std::string::npos) return line;
    if (i == which) break;
    at = line.find_first_not_of("0123456789", at);
  }
  const std::size_t end = std::min(line.find_first_not_of("0123456789", at), line.size());
  return line.substr(0, at) + std::to_string(std::stoi(line.substr(at, end - at)) + 1) + line.substr(end);
}

}  // namespace

TEST_CASE("short form: the ball of the rhythm study in its words") {
  const auto pairs = short_form(ball(SectionStyle::pairs));
  REQUIRE(pairs);
  CHECK(pairs->sections == 4);
  CHECK(pairs->stitches_each == 2);
  CHECK(lines_of(*pairs) == std::vector<std::string>{
                                "Inc rnd: [K1, m1l, k to next m, m1r] 4 times. (+8 sts)",
                                "Dec rnd: [K1, ssk, k to 2 sts before next m, k2tog] 4 times. (-8 sts)",
                                "Rnds 2-13: [Knit 1 rnd, inc rnd] 6 times. (16, 24, 32, 40, 48, 56 sts)",
                                "Rnds 14-22: [Knit 2 rnds, inc rnd] 3 times. (64, 72, 80 sts)",
                                "Rnds 23-38: Knit. (80 sts)",
                                "Rnds 39-47: [Dec rnd, knit 2 rnds] 3 times. (72, 64, 56 sts)",
                                "Rnds 48-57: [Dec rnd, knit 1 rnd] 5 times. (48, 40, 32, 24, 16 sts)",
                                "Rnd 58: [ssk, k2tog] 4 times. (8 sts)",
                                "Rnd 59: Knit. (8 sts)",
                            });
  const auto lines = short_form(ball(SectionStyle::lines));
  REQUIRE(lines);
  CHECK(lines->sections == 8);
  CHECK(lines->named.front().text() == "Inc rnd: [K to next m, m1l] 8 times. (+8 sts)");
  CHECK(lines->named.back().text() == "Dec rnd: [K to 2 sts before next m, k2tog] 8 times. (-8 sts)");
}

TEST_CASE("short form: what is written leads back to the same stitches") {
  for (const SectionStyle style : {SectionStyle::lines, SectionStyle::pairs}) {
    const Rounds rounds = ball(style);
    const std::string text = short_text(rounds);
    check_says_the_same(rounds, text);
    check_says_the_same(rounds, pattern_as_markdown(write_pattern(rounds, {22.0, 32.0},
                                                                  {.form = PatternForm::short_form}, "b")));
    CHECK(text.find("Place a marker (m) after every ") != std::string::npos);
    CHECK(text.find("\nm: marker") != std::string::npos);
    const auto instructions = [&](bool is_short) {
      const PatternOptions options{.form = is_short ? PatternForm::short_form : PatternForm::full};
      std::size_t letters = 0;
      for (const auto& told : write_pattern(rounds, {22.0, 32.0}, options, "ball").instructions)
        letters += (told.round ? told.round->text() : told.remark).size();
      return letters;
    };
    CHECK(instructions(true) * 100 < instructions(false) * 60);  // the study has 0.51 in the middle
  }
}

TEST_CASE("short form: stuffing is told where it is due, within a rhythm too") {
  const Rounds rounds = ball(SectionStyle::pairs);
  const WrittenPattern pattern =
      write_pattern(rounds, {22.0, 32.0}, {.form = PatternForm::short_form}, "ball");
  const std::vector<std::int32_t> stuffed = stuffed_after(rounds);
  REQUIRE(stuffed.size() == 1);
  std::int32_t last = 0;
  for (const auto& instruction : pattern.instructions) {
    if (instruction.round) last = instruction.round->last;
    if (instruction.remark.starts_with("Stuff")) CHECK(last == stuffed.front());
  }
}

TEST_CASE("short form: rounds without equal sections have none") {
  RhythmRounds made(4, 8, SectionStyle::pairs);
  made.grow(1, 3);
  Rounds rounds = made.rounds();
  std::swap(rounds.rounds.back().operations[1].hand, rounds.rounds.back().operations[2].hand);
  CHECK_FALSE(short_form(rounds));
  // Nothing is named that comes once.
  CHECK_FALSE(short_form(RhythmRounds(4, 8, SectionStyle::pairs).grow(1, 1).rounds()));
  CHECK_FALSE(short_form(RhythmRounds(4, 8, SectionStyle::pairs).plain(9).rounds()));
  // The long form stands in its place.
  CHECK(short_text(rounds) == pattern_as_text(write_pattern(rounds, {22.0, 32.0}, {}, "ball")));
}

TEST_CASE("short form: two step sizes are A and B, the larger A") {
  RhythmRounds made(4, 8, SectionStyle::pairs);
  made.grow(1, 4);
  Rounds rounds = made.rounds();
  RhythmRounds more(4, rounds.last_count(), SectionStyle::lines);
  more.grow(2, 3).shrink(1, 5);
  for (Round round : more.rounds().rounds) {
    round.number += static_cast<std::int32_t>(made.rounds().rounds.size());
    rounds.rounds.push_back(std::move(round));
  }
  const auto form = short_form(rounds);
  REQUIRE(form);
  REQUIRE(form->named.size() == 3);
  CHECK(form->named[0].name == "inc rnd A");
  CHECK(form->named[1].name == "inc rnd B");
  CHECK(form->named[2].name == "dec rnd");
  check_says_the_same(rounds, short_text(rounds));
}

TEST_CASE("short form: random rhythms come back") {
  for (std::uint32_t seed = 0; seed < test_support::repeated(300U); ++seed) {
    test_support::PatternDice dice(seed);
    const auto style = dice.chance(50) ? SectionStyle::lines : SectionStyle::pairs;
    const std::int32_t sections = dice.roll(2, 10);
    RhythmRounds made(sections, sections * dice.roll(1, 3), style);
    for (int i = 0; i < 12; ++i) {
      const std::int32_t each = made.rounds().last_count() / sections;
      const std::int32_t least = style == SectionStyle::pairs ? 4 : 2;
      if (dice.chance(30))
        made.plain(dice.roll(1, 9));
      else if (dice.chance(50) || each < least)
        made.grow(dice.roll(0, 3), dice.roll(1, 4));
      else
        made.shrink(dice.roll(0, 3),
                    dice.roll(1, std::max(1, style == SectionStyle::pairs ? (each - 2) / 2 : each - 1)));
    }
    CAPTURE(seed);
    check_says_the_same(made.rounds(), short_text(made.rounds()));
  }
}

TEST_CASE("short form: a number that is changed is found in its line") {
  for (const SectionStyle style : {SectionStyle::lines, SectionStyle::pairs}) {
    std::vector<std::string> lines;
    std::istringstream in(short_text(ball(style)));
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    std::size_t tried = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool told = lines[i].starts_with("Rnd") || lines[i].find(" rnd: ") != std::string::npos;
      if (!told) continue;
      for (std::size_t which = 0; which < 12; ++which) {
        std::vector<std::string> changed = lines;
        changed[i] = with_another_number(lines[i], which);
        // "K2" for "K1" before a marker is another pattern that adds up; so is "m1l", which has a number in its word.
        const bool other = lines[i].find("rnd:") != std::string::npos &&
                           changed[i].find(" times. (") != std::string::npos &&
                           changed[i].substr(changed[i].find("] ")) == lines[i].substr(lines[i].find("] "));
        if (changed[i] == lines[i] || other) continue;
        std::string text;
        for (const std::string& line : changed) text += line + "\n";
        const ReadPattern read = read_pattern(text);
        CAPTURE(changed[i]);
        REQUIRE_FALSE(read.mistakes.empty());
        // Where a line of plain rounds ends is seen in the number that the next one begins with.
        const bool plain = lines[i].find(": Knit.") != std::string::npos && which == 1;
        CHECK(read.mistakes.front().line - (plain ? 1 : 0) <= i + 1);
        CHECK(read.mistakes.front().line >= i + 1);
        ++tried;
      }
    }
    CHECK(tried >= 30);
  }
}

TEST_CASE("short form: what a reader must refuse is named") {
  const std::string start =
      "CO 8 sts (Rnd 1). Place a marker (m) after every 2 sts: 4 markers.\n"
      "Inc rnd: [K1, m1l, k to next m, m1r] 4 times. (+8 sts)\n";
  const auto first = [&](const std::string& text) {
    const ReadPattern read = read_pattern(text);
    return read.mistakes.empty() ? std::string() : read.mistakes.front().sentence;
  };
  CHECK(first(start + "Rnds 2-5: [Knit 1 rnd, inc rnd] 2 times. (16, 24 sts)\n").empty());
  CHECK(first(start + "Rnds 2-6: [Knit 1 rnd, inc rnd] 2 times. (16, 24 sts)\n") ==
        "line 3: Rnds 2-6: its words are 4 rounds, the label names 5.");
  CHECK(first(start + "Rnds 2-5: [Knit 1 rnd, inc rnd] 2 times. (16, 24, 32 sts)\n") ==
        "line 3: Rnds 2-5: it is shaped in 2 rounds, and 3 counts are told.");
  CHECK(first(start + "Rnds 2-5: [Knit 1 rnd, inc rnd] 2 times. (16, 25 sts)\n") ==
        "line 3: Rnd 5 makes 24 stitches, the line says 25.");
  CHECK(first(start + "Rnds 2-5: [Knit 1 rnd, dec rnd] 2 times. (16, 24 sts)\n") ==
        "line 3: Rnds 2-5: no line before tells what the dec rnd is.");
  CHECK(first("CO 8 sts (Rnd 1). Place a marker (m) after every 3 sts: 3 markers.\n") ==
        "line 1: a marker after every 3 stitches and 3 markers do not go round 8 stitches.");
  CHECK(
      first("CO 8 sts (Rnd 1).\nInc rnd: [K to next m, m1l] 4 times. (+4 sts)\nRnd 2: Inc rnd. (12 sts)\n") ==
      "line 3: Rnd 2: it goes to the next marker, and none is placed.");
  CHECK(first(start + "Inc rnd: [K1, m1l] 4 times. (+4 sts)\n") ==
        "line 3: the inc rnd is told twice; give each way to shape a name of its own.");
  CHECK(first("CO 8 sts (Rnd 1). Place a marker (m) after every 2 sts: 4 markers.\n"
              "Inc rnd: [K1, m1l, k to next m, m1r] 4 times. (+9 sts)\n") ==
        "line 2: the inc rnd makes 8 stitches more, the line says 9 stitches more.");
}
