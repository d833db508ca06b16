// Placement of a rhythm: the words of each round, and that the mains' two sides mirror each other.
#include "knit/stitches/repeats.h"

#include <algorithm>
#include <string>

#include "knit/pattern/pattern_words.h"
#include "knit/stitches/operations.h"
#include "tests/support/catch.h"

using namespace knit;
using Style = RhythmStyle;

namespace {

// Of a round of four sections.
std::string words(std::int32_t before, std::int32_t change, Style style, std::int32_t turn = 0) {
  const Join join = plan_repeats({4 * before, 4 * (before + change), 4, style, turn});
  return words_of(fold(operations_of(join)));
}

// What stands around a main, from far to near: the hands before it and those after it.
using Hands = std::vector<Hand>;
struct Sides {
  Hands before, after;
};
std::vector<Sides> sides_of_mains(const std::vector<Operation>& operations) {
  std::vector<Sides> all;
  const auto count = operations.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!operations[i].at_main) continue;
    Sides sides;
    for (std::size_t away = 1; away <= 2; ++away) {
      sides.before.push_back(operations[(i + count - away) % count].hand);
      sides.after.push_back(operations[(i + away) % count].hand);
    }
    all.push_back(sides);
  }
  return all;
}
Hand mirrored(Hand hand) {
  switch (hand) {
    case Hand::m1l:
      return Hand::m1r;
    case Hand::m1r:
      return Hand::m1l;
    case Hand::k2tog:
      return Hand::ssk;
    case Hand::ssk:
      return Hand::k2tog;
    case Hand::knit:
      break;
  }
  return hand;
}
Hands mirrored(Hands hands) {
  for (Hand& hand : hands) hand = mirrored(hand);
  return hands;
}

}  // namespace

TEST_CASE("pairs stand on both sides of a main") {
  CHECK(words(6, 2, Style::pairs) == "[K1, m1l, K5, m1r] 4 times");
  CHECK(words(2, 2, Style::pairs) == "[K1, m1l, K1, m1r] 4 times");
  CHECK(words(9, -2, Style::pairs) == "[K1, ssk, K4, k2tog] 4 times");
  CHECK(words(5, -2, Style::pairs) == "[K1, ssk, k2tog] 4 times");
  CHECK(words(4, -2, Style::pairs) == "[ssk, k2tog] 4 times");
}

TEST_CASE("with one change a section a pair takes two rounds") {
  CHECK(words(6, 1, Style::pairs, 0) == "[K1, m1l, K5] 4 times");
  CHECK(words(7, 1, Style::pairs, 1) == "[K7, m1r] 4 times");
  CHECK(words(7, -1, Style::pairs, 0) == "[K1, ssk, K4] 4 times");
  CHECK(words(6, -1, Style::pairs, 1) == "[K4, k2tog] 4 times");
  CHECK(words(1, 1, Style::pairs, 0) == "[K1, m1l] 4 times");
  CHECK(words(2, -1, Style::pairs, 0) == "[k2tog] 4 times");
}

TEST_CASE("lines, centre and stagger stand where their names say") {
  CHECK(words(6, 1, Style::lines) == "[K6, m1l] 4 times");
  CHECK(words(6, -1, Style::lines, 3) == "[K4, k2tog] 4 times");
  CHECK(words(7, 1, Style::centre, 0) == "[K3, m1r, K4] 4 times");
  CHECK(words(8, 1, Style::centre, 1) == "[K4, m1l, K4] 4 times");
  CHECK(words(1, 1, Style::centre, 0) == "[K1, m1l] 4 times");
  CHECK(words(7, -1, Style::centre, 0) == "[K2, ssk, K3] 4 times");
  CHECK(words(7, -1, Style::centre, 1) == "[K3, k2tog, K2] 4 times");
  CHECK(words(3, -1, Style::centre, 0) == "[ssk, K1] 4 times");
  CHECK(words(6, 1, Style::stagger, 0) == "[K6, m1l] 4 times");
  CHECK(words(7, 1, Style::stagger, 1) == "[K4, m1l, K3] 4 times");
  CHECK(words(6, -1, Style::stagger, 1) == "[K2, k2tog, K2] 4 times");
  CHECK(words(6, -1, Style::stagger, 2) == "[K4, k2tog] 4 times");
  for (const Style style : {Style::pairs, Style::lines, Style::centre, Style::stagger})
    CHECK(words(6, 0, style) == "K24");
}

TEST_CASE("both sides of every main mirror each other in rounds of pairs") {
  for (const std::int32_t change : {2, -2}) {
    for (std::int32_t before = 5; before < 12; ++before) {
      const Join join = plan_repeats({5 * before, 5 * (before + change), 5, Style::pairs, before});
      const std::vector<Sides> mains = sides_of_mains(operations_of(join));
      REQUIRE(mains.size() == 5);
      for (const Sides& sides : mains) {
        CHECK(sides.before.front() == (change > 0 ? Hand::m1r : Hand::k2tog));
        CHECK(mirrored(sides.before) == sides.after);
      }
    }
  }
}

TEST_CASE("every repeat is sound: links rise, each stitch has one or two, mains are wales") {
  for (const Style style : {Style::pairs, Style::lines, Style::centre, Style::stagger}) {
    for (const std::int32_t change : {-2, -1, 0, 1, 2}) {
      for (std::int32_t before = 1; before < 9; ++before) {
        const bool fits = change > 0 ? change <= before : before + change >= 1 && -2 * change <= before;
        if (!fits) continue;
        for (const std::int32_t turn : {0, 1}) {
          const Join join = plan_repeats({3 * before, 3 * (before + change), 3, style, turn, 7});
          INFO(before << " " << change << " " << static_cast<int>(style) << " " << turn);
          REQUIRE(join.link.size() == join.labels.size());
          CHECK(join.to == 7);
          std::vector<std::int32_t> links(static_cast<std::size_t>(std::min(join.below, join.above)), 0);
          std::int32_t last = 0;
          bool rising = true;
          for (const std::int32_t link : join.link) {
            rising = rising && (link == last || link == last + 1);
            last = link;
            ++links.at(static_cast<std::size_t>(link));
          }
          CHECK(rising);
          CHECK(std::all_of(links.begin(), links.end(), [](int count) { return count == 1 || count == 2; }));
          const OperationCount made = count(operations_of(join));
          CHECK(made.consumed == join.below);
          CHECK(made.produced == join.above);
          REQUIRE(join.mains.size() == 3);
          for (std::size_t i = 0; i < 3; ++i)
            CHECK(join.mains[i] == static_cast<std::int32_t>(i) * (before + change));
        }
      }
    }
  }
}
