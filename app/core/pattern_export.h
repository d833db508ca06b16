// The pattern for other programs: knitspeak, and JSON with the graph of stitches; see docs/pattern.md.
#pragma once

#include <string>

#include "knit/rounds.h"

namespace app {

// "CO 6 sts (Rnd 1)." and then "Round 2: *k1, M1L, repeat from *. (12 sts)", "Rounds 3-5: knit. (12 sts)".
std::string pattern_knitspeak(const knit::Rounds& rounds);

// Operations run-length encoded, a round a line; the graph a row a line.
std::string pattern_json(const knit::Rounds& rounds);

}  // namespace app
