// Rounds written by hand, or at random, for tests of patterns and charts.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "knit/pattern/rounds.h"
#include "tests/support/rough_sphere.h"

namespace test_support {

// A letter an operation, in working order: k, r (m1r), l (m1l), / (k2tog), \ (ssk); a capital K and what
// stands after a * work a main stitch.
inline std::vector<knit::Operation> operations_of(const std::string& letters) {
  std::vector<knit::Operation> made;
  bool main = false;
  for (const char c : letters) {
    switch (c) {
      case '*':
        main = true;
        continue;
      case 'k':
      case 'K':
        made.push_back({knit::Hand::knit, main || c == 'K'});
        break;
      case 'r':
        made.push_back({knit::Hand::m1r, main});
        break;
      case 'l':
        made.push_back({knit::Hand::m1l, main});
        break;
      case '/':
        made.push_back({knit::Hand::k2tog, main});
        break;
      case '\\':
        made.push_back({knit::Hand::ssk, main});
        break;
      default:
        throw std::invalid_argument("no operation: " + letters);
    }
    main = false;
  }
  return made;
}

inline void add_round(knit::Rounds& rounds, std::vector<knit::Operation> operations) {
  knit::Round round;
  round.number = static_cast<std::int32_t>(rounds.rounds.size()) + 2;
  round.before = rounds.last_count();
  round.after = static_cast<std::int32_t>(operations.size());
  round.operations = std::move(operations);
  rounds.rounds.push_back(std::move(round));
}

inline knit::Rounds hand_rounds(int cast_on, const std::vector<std::string>& rounds) {
  knit::Rounds made;
  made.cast_on = cast_on;
  for (const std::string& letters : rounds) add_round(made, operations_of(letters));
  return made;
}

// Increases and decreases in any mixture, at least three stitches left. Mains as if thrown in.
inline knit::Rounds random_rounds(unsigned seed) {
  Dice dice(seed);
  knit::Rounds made;
  made.cast_on = 3 + static_cast<std::int32_t>(dice.below(12));
  const std::size_t count = dice.below(30);
  const std::size_t often = 2 + dice.below(20);  // one in so many is shaping
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<knit::Operation> round;
    std::int32_t left = made.last_count();
    while (left > 0) {
      const std::size_t what = dice.below(2 * often);
      const bool main = dice.below(9) == 0;
      const bool may_decrease = left >= 2 && static_cast<std::int32_t>(round.size()) + left > 3;
      if (what == 0 && may_decrease) {
        round.push_back({dice.below(2) == 0 ? knit::Hand::k2tog : knit::Hand::ssk, main});
        left -= 2;
        continue;
      }
      if (what == 1) round.push_back({dice.below(2) == 0 ? knit::Hand::m1r : knit::Hand::m1l, false});
      round.push_back({knit::Hand::knit, main});
      --left;
      if (what == 2 && left == 0) round.push_back({knit::Hand::m1l, false});
    }
    add_round(made, std::move(round));
  }
  return made;
}

inline std::int32_t most_stitches(const knit::Rounds& rounds) {
  std::int32_t most = rounds.cast_on;
  for (const knit::Round& round : rounds.rounds) most = std::max(most, round.after);
  return most;
}

// A hand (`knit` for plain stitches) over all rounds.
inline std::size_t count_of(const knit::Rounds& rounds, knit::Hand hand) {
  std::size_t count = 0;
  for (const knit::Round& round : rounds.rounds) {
    for (const knit::Operation& operation : round.operations) count += operation.hand == hand ? 1U : 0U;
  }
  return count;
}

}  // namespace test_support
