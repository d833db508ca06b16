// Rounds in words, as a knitter reads them in a written pattern: `K2, [K4, m1l] 5 times, K2`.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "knit/pattern/fold.h"
#include "knit/pattern/written_pattern.h"

namespace knit {

// As it stands within a round, in small letters: "k", "m1l", "k2tog".
std::string_view word_of(Hand hand);

struct WordsOptions {
  bool stars = false;  // "*K4, m1l; rep from * to end" for a round that is one repeat
};
// Only a knit run has a count; another operation is written as often as it is done.
std::string words_of(std::span<const Phrase> phrases, const WordsOptions& options = {});

// The second round on, each once; equal rounds that follow each other on one line. A round of nothing but
// knit stitches is "Knit", markers or not.
std::vector<RoundLine> round_lines(const Rounds& rounds, const PatternOptions& options);

// "30 sts", "1 st"
std::string stitches_text(std::int32_t count);

}  // namespace knit
