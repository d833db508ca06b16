// Random patterns that can be knitted, and a writer of their own: what reads patterns is tried on what was written
// without knowledge of it. The same seed gives the same pattern everywhere.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "knit/pattern/rounds.h"

namespace test_support {

class PatternDice {
 public:
  explicit PatternDice(std::uint32_t seed) : engine_(seed) {}
  // From `low` to `high`, both possible.
  int roll(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint32_t>(high - low + 1));
  }
  bool chance(int percent) { return roll(1, 100) <= percent; }

 private:
  std::mt19937 engine_;
};

using Operations = std::vector<knit::Operation>;

// A unit that takes `takes` stitches: knits with some increases or some decreases among them.
inline Operations random_unit(PatternDice& dice, int takes, bool grows) {
  Operations unit;
  for (int left = takes; left > 0;) {
    if (!grows && left >= 2 && dice.chance(30)) {
      unit.push_back({dice.chance(50) ? knit::Hand::k2tog : knit::Hand::ssk});
      left -= 2;
      continue;
    }
    if (grows && dice.chance(30)) unit.push_back({dice.chance(50) ? knit::Hand::m1r : knit::Hand::m1l});
    unit.push_back({knit::Hand::knit});
    --left;
  }
  return unit;
}

inline Operations random_round(PatternDice& dice, int stitches) {
  const bool grows = stitches < 6 || (stitches < 60 && dice.chance(60));
  if (dice.chance(35)) return {static_cast<std::size_t>(stitches), knit::Operation{}};
  std::vector<int> divisors;
  for (int d = 2; d <= stitches; ++d) {
    if (stitches % d == 0) divisors.push_back(d);
  }
  const int repeats =
      dice.chance(60)
          ? divisors[static_cast<std::size_t>(dice.roll(0, static_cast<int>(divisors.size()) - 1))]
          : 1;
  const Operations unit = random_unit(dice, stitches / repeats, grows);
  Operations round;
  for (int i = 0; i < repeats; ++i) round.insert(round.end(), unit.begin(), unit.end());
  return round;
}

// Rounds of 3 to 120 stitches; none more than doubles or halves.
inline knit::Rounds random_pattern_rounds(std::uint32_t seed) {
  PatternDice dice(seed);
  knit::Rounds rounds;
  rounds.cast_on = dice.roll(3, 12);
  const int many = dice.roll(4, 24);
  for (int i = 0; i < many; ++i) {
    knit::Round round;
    round.number = i + 2;
    round.before = rounds.last_count();
    do round.operations = random_round(dice, round.before);
    while (round.operations.size() < 3 || round.operations.size() > 120);
    round.after = static_cast<std::int32_t>(round.operations.size());
    rounds.rounds.push_back(std::move(round));
  }
  return rounds;
}

enum class Style { plain, brackets, stars, knitspeak };

class RandomWriter {
 public:
  RandomWriter(Style style, std::uint32_t seed) : style_(style), dice_(seed) {}

  // The lines of a pattern; every count is stated when `all_counts`.
  std::vector<std::string> lines(const knit::Rounds& rounds, bool all_counts) {
    std::vector<std::string> text{"# A thing to knit", "", "Gauge: 22 sts and 34 rnds = 10 cm (4 in)", ""};
    const int first = dice_.roll(1, 2);
    const std::string six = std::to_string(rounds.cast_on) + (dice_.chance(50) ? " sts" : " stitches");
    if (first == 1)
      text.push_back("Using double-pointed needles, CO " + six +
                     ". Join to work in the round. Place marker.");
    else if (dice_.chance(50))
      text.push_back(label(1, 1) + "CO " + six + ", join in the round, pm." + count(rounds.cast_on));
    else
      text.push_back("Cast on " + six + ". This is Rnd 1.");
    const auto& all = rounds.rounds;
    for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
      end = i + 1;
      while (end < all.size() && all[end].operations == all[i].operations) ++end;
      const int at = first + static_cast<int>(i);
      std::string line = label(at, at + static_cast<int>(end - i) - 1) + round(all[i].operations) + ".";
      if (all_counts || all[i].before != all[i].after || dice_.chance(50)) line += count(all[i].after);
      text.push_back(std::move(line));
    }
    text.emplace_back();
    const std::string left = std::to_string(rounds.last_count());
    text.push_back(dice_.chance(30)
                       ? "BO all sts."
                       : "Break yarn, thread through remaining " + left + " sts and pull tightly.");
    text.emplace_back("Weave in ends.");
    return text;
  }

  static std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
  }

 private:
  static std::string count(int stitches) { return " (" + std::to_string(stitches) + " sts)"; }

  [[nodiscard]] std::string label(int first, int last) const {
    const std::string word = style_ == Style::knitspeak ? "Round" : "Rnd";
    if (first == last) return word + " " + std::to_string(first) + ": ";
    return word + "s " + std::to_string(first) + "-" + std::to_string(last) + ": ";
  }

  [[nodiscard]] std::string word(knit::Hand hand) const {
    const bool large = style_ == Style::knitspeak;
    switch (hand) {
      case knit::Hand::m1r:
        return large ? "M1R" : "m1r";
      case knit::Hand::m1l:
        return large ? "M1L" : "m1l";
      case knit::Hand::k2tog:
        return "k2tog";
      case knit::Hand::ssk:
        return "ssk";
      case knit::Hand::knit:
        break;
    }
    return large ? "k" : "K";
  }

  // "K4, m1l, K1"
  [[nodiscard]] std::string runs(const Operations& ops) const {
    std::string text;
    for (std::size_t i = 0, end = 0; i < ops.size(); i = end) {
      end = i + 1;
      const bool knits = ops[i].hand == knit::Hand::knit;
      while (knits && end < ops.size() && ops[end] == ops[i]) ++end;
      text += (i > 0 ? ", " : "") + word(ops[i].hand) + (knits ? std::to_string(end - i) : "");
    }
    return text;
  }

  // How many operations at the front repeat: the shortest unit that does so to the very end, or the whole.
  static std::size_t period(const Operations& ops) {
    for (std::size_t p = 1; p < ops.size(); ++p) {
      if (ops.size() % p == 0 &&
          std::equal(ops.begin() + static_cast<std::ptrdiff_t>(p), ops.end(), ops.begin()))
        return p;
    }
    return ops.size();
  }

  // Repeats in brackets wherever a few operations come twice or more, two deep at most.
  [[nodiscard]] std::string bracketed(const Operations& ops, int depth) const {
    if (depth == 2) return runs(ops);
    const std::size_t whole = period(ops);
    if (whole > 1 && whole < ops.size())
      return "[" + bracketed({ops.begin(), ops.begin() + static_cast<std::ptrdiff_t>(whole)}, depth + 1) +
             "] " + std::to_string(ops.size() / whole) + " times";
    std::string text;
    Operations rest;
    const auto flush = [&] {
      if (!rest.empty()) text += (text.empty() ? "" : ", ") + runs(rest);
      rest.clear();
    };
    for (std::size_t i = 0; i < ops.size();) {
      std::size_t unit = 0, times = 1;
      for (std::size_t p = 2; p <= 6 && unit == 0; ++p) {
        while (i + (times + 1) * p <= ops.size() &&
               std::equal(at(ops, i), at(ops, i + p), at(ops, i + times * p)))
          ++times;
        if (times > 1 && period({at(ops, i), at(ops, i + p)}) == p) unit = p;
        if (unit == 0) times = 1;
      }
      if (unit == 0) {
        rest.push_back(ops[i++]);
        continue;
      }
      flush();
      text += (text.empty() ? "(" : ", (") + runs({at(ops, i), at(ops, i + unit)}) + ") x " +
              std::to_string(times);
      i += unit * times;
    }
    flush();
    return text;
  }
  static Operations::const_iterator at(const Operations& ops, std::size_t i) {
    return ops.begin() + static_cast<std::ptrdiff_t>(i);
  }

  // "*K4, m1l; rep from * to last 3 sts, K3": whole where the round is one repeat, else as far as it goes.
  std::string starred(const Operations& ops) {
    const std::size_t whole = period(ops);
    if (whole < ops.size()) {
      const std::string unit = "*" + runs({ops.begin(), at(ops, whole)});
      if (style_ == Style::knitspeak) return unit + ", repeat from *";
      if (dice_.chance(30))
        return unit + "; rep from * " + std::to_string(ops.size() / whole - 1) + " more times";
      return unit + "; rep from * " + (dice_.chance(50) ? "to end" : "around");
    }
    for (std::size_t p = 2; p <= ops.size() / 2; ++p) {
      if (!std::equal(ops.begin(), at(ops, p), at(ops, p))) continue;
      std::size_t end = 2 * p;
      while (end + p <= ops.size() && std::equal(ops.begin(), at(ops, p), at(ops, end))) end += p;
      int tail = 0;
      for (auto op = at(ops, end); op != ops.end(); ++op) tail += knit::consumed_by(op->hand);
      if (tail == 0) continue;
      return "*" + runs({ops.begin(), at(ops, p)}) + "; rep from * to last " + std::to_string(tail) +
             (tail == 1 ? " st, " : " sts, ") + runs({at(ops, end), ops.end()});
    }
    return runs(ops);
  }

  std::string round(const Operations& ops) {
    const bool all_knit =
        std::all_of(ops.begin(), ops.end(), [](const auto& op) { return op.hand == knit::Hand::knit; });
    if (all_knit && dice_.chance(70)) return dice_.chance(70) ? "Knit" : "K all sts";
    if (style_ == Style::plain) return runs(ops);
    return style_ == Style::brackets ? bracketed(ops, 0) : starred(ops);
  }

  Style style_;
  PatternDice dice_;
};

}  // namespace test_support
