// The pattern for other programs: JSON with the graph of stitches; its fields are in docs/pattern.md.
#pragma once

#include <string>

#include "knit/limbs/limb_plan.h"
#include "knit/pattern/rounds.h"
#include "knit/pattern/written_pattern.h"

namespace app {

// Operations run-length encoded, a round a line; the graph a row a line.
std::string pattern_json(const knit::Rounds& rounds);
// Version 2: a piece a line, with what it begins on, its rounds and its end.
std::string pattern_json(const knit::LimbPlan& plan, const knit::PatternOptions& options = {});

}  // namespace app
