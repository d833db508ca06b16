// The words of the trade: what a written line is made of, and what each stitch takes and makes.
//
// Known stitches: k, knit, k4 · m1, m1l, m1r, yo (made from nothing) · k2tog, p2tog, ssk, ssp, skp (two into one) ·
// kfb, pfb (one into two) · k3tog, sssk, sk2p, s2kp, cdd (three into one) · p, purl, sl, slip (one into one).
// Only hands that Rounds knows can be handed on: m1 and yo count as m1l, kfb as a knit and an m1l, purled and
// slipped stitches as knit; three into one is counted rightly and ends what Rounds can hold.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "knit/pattern/rounds.h"

namespace knit {

struct Token {
  enum class Kind : std::uint8_t { word, number, mark, strange };
  Kind kind = Kind::strange;
  std::string text;        // words in lower case; dashes are "-", a times sign is the word "x"
  std::int64_t value = 0;  // of a number, at most `most_number`
  [[nodiscard]] bool is(std::string_view wanted) const { return text == wanted; }
  [[nodiscard]] bool is_number() const { return kind == Kind::number; }
};
using Tokens = std::vector<Token>;

inline constexpr std::int64_t most_number = 1'000'000'000;

Tokens tokens_of(std::string_view line);

struct StitchKind {
  std::string_view word;
  std::int32_t takes = 1, makes = 1;
  std::array<Hand, 2> hands{Hand::knit, Hand::knit};
  std::int32_t operations = 1;  // of `hands`; 0: Rounds has no hand for it
  bool counts = false;          // a number may follow: k4, knit 4
};

struct NamedStitch {
  StitchKind kind;
  std::optional<std::int64_t> count;  // k4; none: k
};
std::optional<NamedStitch> stitch_named(const Token& token);

bool is_stitches_word(const Token& token);  // st, sts, stitch, stitches
bool is_round_word(const Token& token);     // rnd, rounds, row ...
bool begins_work(
    const Token& token);  // could go on with a round: a stitch, a bracket, "rep", "times", a number

}  // namespace knit
