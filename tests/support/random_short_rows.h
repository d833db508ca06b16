// Random rounds with short rows: over the beginning of the round and within it, nested, overlapping and apart.
#pragma once

#include <algorithm>

#include "knit/pattern/passes.h"
#include "tests/support/random_pattern.h"

namespace test_support {

// Pairs that can be worked in this round, up to `most`.
inline std::vector<knit::ShortRowPair> random_pairs(PatternDice& dice, knit::Round round, int most) {
  std::vector<knit::ShortRowPair> pairs;
  const int n = round.before;
  for (int tries = 0; tries < 8 * most && static_cast<int>(pairs.size()) < most; ++tries) {
    const bool over = dice.chance(50);
    const int first = over ? -dice.roll(1, n) : dice.roll(1, n);
    const int last = over ? dice.roll(0, n) : dice.roll(first, n);
    round.pairs = {{first, last}};
    if (knit::can_be_worked(round)) pairs.push_back({first, last});
  }
  return pairs;
}

// A tube whose rounds are shaped loosely enough to turn between the shaped stitches.
inline knit::Rounds random_short_row_rounds(std::uint32_t seed) {
  PatternDice dice(seed);
  knit::Rounds rounds;
  rounds.cast_on = dice.roll(6, 40);
  const int many = dice.roll(2, 8);
  for (int i = 0; i < many; ++i) {
    knit::Round round;
    round.number = i + 2;
    round.before = rounds.last_count();
    const bool plain = dice.chance(30), grows = round.before < 60 && dice.chance(60);
    for (int left = round.before; left > 0;) {
      const bool shaped = !plain && dice.chance(20);
      if (shaped && grows) round.operations.push_back({dice.chance(50) ? knit::Hand::m1r : knit::Hand::m1l});
      if (shaped && !grows && left >= 2 && round.before > 12) {
        round.operations.push_back({dice.chance(50) ? knit::Hand::k2tog : knit::Hand::ssk});
        left -= 2;
        continue;
      }
      round.operations.push_back({knit::Hand::knit});
      --left;
    }
    round.after = static_cast<std::int32_t>(round.operations.size());
    round.pairs = random_pairs(dice, round, dice.roll(0, 4));
    rounds.rounds.push_back(std::move(round));
  }
  return rounds;
}

}  // namespace test_support
