// A chain of rounds told shortly, as published patterns tell it: markers between equal sections, each way to shape
// named once, and what comes again said once.
//
//   Place a marker (m) after every 2 sts: 4 markers.
//   Inc rnd: [K1, m1l, k to next m, m1r] 4 times. (+8 sts)
//   Rnds 2-13: [Knit 1 rnd, inc rnd] 6 times. (16, 24, 32, 40, 48, 56 sts)
//
// It says the same rounds as the long form does, operation by operation; knit/reader proves it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "knit/pattern/rounds.h"
#include "knit/pattern/written_pattern.h"

namespace knit {

// A way to shape a round, in every section alike.
struct NamedRound {
  std::string name;         // "inc rnd", "dec rnd B"
  std::string words;        // "[K1, m1l, k to next m, m1r] 4 times"
  std::int32_t change = 0;  // stitches more, or fewer
  // "Inc rnd: [K1, m1l, k to next m, m1r] 4 times. (+8 sts)"
  [[nodiscard]] std::string text() const;
};

struct ShortForm {
  std::int32_t sections = 0, stitches_each = 0;  // at the cast on; a marker stands behind each
  std::vector<std::int32_t>
      marks;                      // where halves are shaped apart: stitches of the cast on before each marker
  std::vector<NamedRound> named;  // in the order of use
  std::vector<RoundLine> lines;   // the second round on
};

// "inc rnd", or "inc rnd A" where several grow: A is the one that changes most. They stand in the order of use.
void give_names(std::vector<NamedRound>& named);

// Where sections are not alike, halves may be (halves_form.h).
// Nothing where the rounds have no sections that stay alike (every shaping round the same in each of them), or no way
// to shape comes twice: then nothing is gained. Of several numbers of sections the one with the fewest characters.
// `breaks`: rounds after which something else is told, so that no line goes on beyond them.
// Cost: for R rounds and the divisors of the cast on O(R^2) lines are weighed.
std::optional<ShortForm> short_form(const Rounds& rounds, std::span<const std::int32_t> breaks = {});

}  // namespace knit
