// Short rows inside pieces: what the reader knits from their words, and from JSON, is what the plan's hands knit.
#include "app/files/pattern_json.h"
#include "app/files/pattern_knitspeak.h"
#include "app/files/pattern_page.h"
#include "app/reader/pattern_json_reader.h"
#include "knit/limbs/limb_plan.h"
#include "knit/pattern/limb_groups.h"
#include "knit/pattern/written_pattern.h"
#include "tests/support/catch.h"
#include "tests/support/limb_hands.h"
#include "tests/support/random_fabric.h"
#include "tests/support/random_short_rows.h"
#include "tests/support/repeated.h"

using namespace knit;

namespace {

constexpr Gauge gauge{22.0, 32.0};

// Pairs in its rounds by chance; those of twins are the same, or not.
std::size_t add_pairs(LimbPlan& plan, std::uint32_t seed) {
  std::size_t added = 0;
  for (LimbPiece& piece : plan.pieces) {
    test_support::PatternDice dice(
        seed + (seed % 2 == 0 ? 0U : static_cast<std::uint32_t>(&piece - plan.pieces.data())));
    const Rounds rounds = rounds_of(piece);
    for (std::size_t i = 0; i < piece.rounds.size(); ++i) {
      const int most = dice.roll(0, 3);
      if (piece.rounds[i].slips_back) continue;
      piece.rounds[i].pairs = test_support::random_pairs(dice, rounds.rounds[i], most);
      added += piece.rounds[i].pairs.size();
    }
  }
  return added;
}

struct RandomLimbs {
  LimbPlan plan;
  std::size_t pairs = 0;
};
RandomLimbs random_limbs(std::uint32_t seed) {
  const State state = test_support::RandomFabric(seed).run(3 + static_cast<int>(seed % 9));
  if (!has_limbs(state)) return {};
  RandomLimbs limbs{plan_limbs(state), 0};
  limbs.pairs = add_pairs(limbs.plan, seed);
  return limbs;
}

std::string written(const LimbPlan& plan, ShortRowTurns turns) {
  PatternOptions options;
  options.turns = turns;
  return pattern_as_text(write_pattern(plan, gauge, options, "shape"));
}

void check_reads_back(const ReadLimbs& read, const std::string& text, const ReadLimbs& wanted) {
  CAPTURE(text);
  if (!read.mistakes.empty()) {
    CAPTURE(read.mistakes.front().sentence);
    FAIL_CHECK("the reader finds a mistake");
    return;
  }
  CHECK(test_support::same_graph(read, wanted));
  CHECK(read.rounds_read == wanted.rounds_read);
}

}  // namespace

TEST_CASE("short rows in pieces: random pieces come back from their words and from JSON") {
  std::size_t pairs = 0;
  for (std::uint32_t seed = 0; seed < test_support::repeated_deep(400U); ++seed) {
    const RandomLimbs limbs = random_limbs(seed);
    if (limbs.plan.pieces.empty()) continue;
    pairs += limbs.pairs;
    CAPTURE(seed);
    const ReadLimbs worked = test_support::PlanHands(limbs.plan).run();
    for (const ShortRowTurns turns : {ShortRowTurns::german, ShortRowTurns::wrap}) {
      PatternOptions options;
      options.turns = turns;
      const WrittenPattern pattern = write_pattern(limbs.plan, gauge, options, "shape");
      const std::string text = pattern_as_text(pattern), spoken = app::pattern_knitspeak(limbs.plan, options);
      check_reads_back(read_limbs(text), text, worked);
      check_reads_back(read_limbs(spoken), spoken, worked);
      if (seed % 8 != 0) continue;
      const std::string markdown = pattern_as_markdown(pattern),
                        page = app::pattern_html(pattern, app::PiecesArt{});
      check_reads_back(read_limbs(markdown), markdown, worked);
      check_reads_back(read_limbs(page), page, worked);
    }
    const std::string json = app::pattern_json(limbs.plan);
    const app::JsonPattern read = app::read_pattern_json(json);
    REQUIRE(std::holds_alternative<ReadLimbs>(read));
    check_reads_back(std::get<ReadLimbs>(read), json, worked);
  }
  CHECK(pairs > 100);
}

TEST_CASE("short rows in pieces: a changed number is refused") {
  std::size_t changed = 0;
  for (std::uint32_t seed = 0; seed < test_support::repeated_deep(400U); ++seed) {
    const RandomLimbs limbs = random_limbs(seed);
    if (limbs.pairs == 0) continue;
    std::string text = written(limbs.plan, seed % 2 == 0 ? ShortRowTurns::german : ShortRowTurns::wrap);
    const std::size_t line = text.find("Short row 1");
    const std::size_t number = text.find_first_of("0123456789", text.find(": K", line));
    ++changed;
    text.insert(number, "1");
    CAPTURE(seed, text);
    CHECK_FALSE(read_limbs(text).mistakes.empty());
  }
  CHECK(changed > 10);
}

TEST_CASE("short rows in pieces: the round after them must come") {
  const std::string begin =
      "Limb A: 2 rnds, 12 sts at the end\nRnd 1: CO 12 sts. Join in the round, place marker. (12 sts)\n";
  const std::string pair =
      "Short row 1 (RS): K5, turn. (5 sts after BOR)\nShort row 2 (WS): DS, p4, sm, p4, turn. (4 sts before "
      "BOR)\nNext row (RS): DS, k3 to BOR.\n";
  const std::string end = "Break yarn, thread through remaining 12 sts and pull tightly. Fasten off.\n";
  CHECK(read_limbs(begin + pair + "Rnd 2: Knit. (12 sts)\n" + end).mistakes.empty());
  const auto said = [](const std::string& text) {
    const ReadLimbs read = read_limbs(text);
    return read.mistakes.empty() ? "" : read.mistakes.front().sentence;
  };
  CHECK(said(begin + pair + end) == "line 6: the round after the short rows is missing.");
  CHECK(said(begin + "Rnd 2: Knit. (12 sts)\n" + pair + end) ==
        "line 4: short rows are told after Rnd 2, the last one of the heading.");
}
