// Mistakes planted in random patterns are found where they are; bytes of any kind upset nothing.
#include <functional>

#include "knit/reader/pattern_reader.h"
#include "tests/support/catch.h"
#include "tests/support/random_pattern.h"
#include "tests/support/repeated.h"

using namespace knit;
using test_support::PatternDice;
using test_support::RandomWriter;
using test_support::Style;

namespace {

using Lines = std::vector<std::string>;

// Puts `with` for the first `what`; false where there is none.
bool swap_text(std::string& line, const std::string& what, const std::string& with) {
  const std::size_t at = line.find(what);
  if (at == std::string::npos) return false;
  line.replace(at, what.size(), with);
  return true;
}

bool add_one(std::string& line, std::size_t digits) {
  const std::size_t end = line.find_first_not_of("0123456789", digits);
  const int number = std::stoi(line.substr(digits, end - digits));
  line.replace(digits, end - digits, std::to_string(number + 1));
  return true;
}

bool is_round(const std::string& line) { return line.rfind("Rnd", 0) == 0; }

// Spoils line `at`; the line (from 0) where it shows, or -1 where the line is not fit for it.
struct Plant {
  const char* name;
  std::function<int(Lines&, std::size_t at)> spoil;
};

Plant in_line(const char* name, std::function<bool(std::string&)> change) {
  return {name, [change = std::move(change)](Lines& lines, std::size_t at) {
            return is_round(lines[at]) && change(lines[at]) ? static_cast<int>(at) : -1;
          }};
}

Plant in_words(const char* name, const std::string& what, const std::string& with) {
  return in_line(name, [=](std::string& line) { return swap_text(line, what, with); });
}

std::vector<Plant> all_plants() {
  const auto one_label = [](const std::string& line) { return line.rfind("Rnd ", 0) == 0; };
  const auto middle = [](const Lines& lines, std::size_t at) {
    return is_round(lines[at]) && is_round(lines[at - 1]) && is_round(lines[at + 1]);
  };
  return {
      in_line("wrong count", [](std::string& line) { return add_one(line, line.rfind('(') + 1); }),
      in_line("missing increase",
              [](std::string& line) { return swap_text(line, "m1l, ", "") || swap_text(line, ", m1r", ""); }),
      in_line("swapped repeat count",
              [](std::string& line) {
                const std::size_t at = line.find("] ");
                return at != std::string::npos && add_one(line, at + 2);
              }),
      in_words("lost closing bracket", "] ", " "),
      in_words("lost opening bracket", ": [", ": "),
      in_words("lost parenthesis", ") x", " x"),
      in_words("k2tog beyond the end", ". (", ", k2tog. ("),
      in_words("stitch left over", ": K", ": K1, m1l, K"),
      in_words("misspelt increase", "m1l", "m1i"),
      in_words("misspelt decrease", "k2tog", "k2tgo"),
      in_words("misspelt times", "times", "tiems"),
      in_words("misspelt knit", "Knit", "Kint"),
      in_words("misspelt label", "Rnd ", "Rdn "),
      in_words("lost colon", ": ", " "),
      in_words("times without number", "] 2 times", "] times"),
      {"duplicated round",
       [=](Lines& lines, std::size_t at) {
         if (!middle(lines, at)) return -1;
         lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), lines[at]);
         return static_cast<int>(at + 1);
       }},
      {"missing round",
       [=](Lines& lines, std::size_t at) {
         if (!middle(lines, at)) return -1;
         lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at));
         return static_cast<int>(at);
       }},
      {"wrong number",
       [=](Lines& lines, std::size_t at) {
         return middle(lines, at) && one_label(lines[at]) && add_one(lines[at], 4) ? static_cast<int>(at)
                                                                                   : -1;
       }},
      {"wrong closing number",
       [](Lines& lines, std::size_t at) {
         const std::size_t number = lines[at].find("remaining ");
         return number != std::string::npos && add_one(lines[at], number + 10) ? static_cast<int>(at) : -1;
       }},
      {"no cast on",
       [](Lines& lines, std::size_t at) {
         if (lines[at].find("CO ") == std::string::npos || is_round(lines[at])) return -1;
         lines[at].clear();
         return static_cast<int>(at + 1);
       }},
  };
}

std::string told(const ReadPattern& read) {
  std::string text;
  for (const PatternMistake& mistake : read.mistakes) text += mistake.sentence + "\n";
  return text;
}

}  // namespace

TEST_CASE("each planted mistake is found on its line, and nothing else") {
  int planted = 0;
  for (const Plant& plant : all_plants()) {
    int here = 0;
    for (std::uint32_t seed = 1; seed <= 400 && here < 20; ++seed) {
      PatternDice dice(seed * 7919);
      Lines lines =
          RandomWriter(Style::brackets, seed).lines(test_support::random_pattern_rounds(seed), true);
      const auto at = static_cast<std::size_t>(dice.roll(4, static_cast<int>(lines.size()) - 2));
      const int shows = plant.spoil(lines, at);
      if (shows < 0) continue;
      ++here;
      const std::string text = RandomWriter::joined(lines);
      const ReadPattern read = read_pattern(text);
      CAPTURE(plant.name, seed, at, text, told(read));
      REQUIRE(read.mistakes.size() == 1);
      REQUIRE(read.mistakes[0].line == static_cast<std::size_t>(shows) + 1);
      REQUIRE(read.mistakes[0].sentence.rfind("line " + std::to_string(shows + 1) + ": ", 0) == 0);
    }
    CAPTURE(plant.name);
    CHECK(here >= 8);
    planted += here;
  }
  CHECK(planted >= 300);
}

TEST_CASE("any bytes are read to the end, and what is handed on can be worked") {
  Lines good;
  for (std::uint32_t seed = 1; seed <= 24; ++seed)
    good.push_back(RandomWriter::joined(RandomWriter(static_cast<Style>(seed % 4), seed)
                                            .lines(test_support::random_pattern_rounds(seed), false)));
  good.emplace_back(
      "<html><p>CO 6 sts</p><table><td>Rnd 1:<td>K6</td></table><svg>x</svg>&#42;&times;</html>");
  const std::string marks = "*[](){},;.:-0123456789 \n\r\t\"<>&#\\xkKm\xC3\x97\xE2";
  std::size_t mistakes = 0;
  PatternDice dice(4711);
  for (int i = 0; i < test_support::repeated(20000); ++i) {
    std::string text = good[static_cast<std::size_t>(i) % good.size()];
    for (int changes = dice.roll(1, 8); changes > 0 && !text.empty(); --changes) {
      const auto at = static_cast<std::size_t>(dice.roll(0, static_cast<int>(text.size()) - 1));
      const char mark = marks[static_cast<std::size_t>(dice.roll(0, static_cast<int>(marks.size()) - 1))];
      switch (dice.roll(0, 4)) {
        case 0:
          text[at] = static_cast<char>(dice.roll(0, 255));
          break;
        case 1:
          text.insert(at, 1, mark);
          break;
        case 2:
          text.erase(at, static_cast<std::size_t>(dice.roll(1, 12)));
          break;
        case 3:
          text.insert(at, text.substr(at, static_cast<std::size_t>(dice.roll(1, 40))));
          break;
        default:
          text[at] = mark;
      }
    }
    const ReadPattern read = read_pattern(text);
    mistakes += read.mistakes.size();
    const KnitGraph graph = graph_of(read.rounds);
    const bool by_line =
        std::is_sorted(read.mistakes.begin(), read.mistakes.end(),
                       [](const PatternMistake& a, const PatternMistake& b) { return a.line < b.line; });
    if (graph.rows.size() != read.rounds.rounds.size() + 1 || !by_line) FAIL(text);
  }
  if (test_support::whole()) CHECK(mistakes > 10000);
}

TEST_CASE("hostile texts end quickly") {
  const auto many = [](const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += part;
    return text;
  };
  const int most = 100000;
  const int n = test_support::repeated(most);
  for (const std::string& text :
       {"CO 6 sts\nRnd 1: " + many("[", n),
        "CO 6 sts\nRnd 1: " + many("*", n),
        "CO 6 sts\nRnd 1: " + many("k1, ", n),
        "CO 6 sts\nRnd 1: K6\n" + many("draw ", n),
        "CO 6 sts\nRnd 1: K6\n" + many("thread through ", n),
        "CO 6 sts\nRnd 1: K6 " + many("(6 ", n),
        "CO 100000 sts\nRnds 1-9999: Knit.\n" + many("Rnd 1: Knit.\n", n),
        "CO 6 sts\nRnds 1" + many(", 2", n),
        many("<td>", n),
        many("<svg>", n),
        many("<", n),
        many("&", n),
        "<p>" + many("<!--", n),
        many("</p><td>Rnd 1:", n),
        many("CO ", n),
        many("Rnd ", n),
        many("rnd 1: ", n),
        many(". Rnd 1: K1", n),
        many("a\n", n),
        many("CO 6\n", n),
        "CO 1 st\n" + many("Rnd 1: [m1l] 99999 times\n", n),
        std::string(static_cast<std::size_t>(n), '\0'),
        std::string("CO 6 sts\nRnd 1: K6") + std::string(static_cast<std::size_t>(n), '9') + " sts",
        many("place the ", n),
        "CO 6 sts\nRnd 1: k " + many("the ", n),
        "CO 3 sts\nRnd 1: " + many("around of the ", n)}) {
    CAPTURE(text.substr(0, 60));
    CHECK(read_pattern(text).rounds.cast_on <= most);
  }
}
