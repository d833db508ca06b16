// The pattern for other programs in knitspeak, which has words for rounds and nothing else.
#pragma once

#include <string>

#include "knit/limbs/limb_plan.h"
#include "knit/pattern/rounds.h"
#include "knit/pattern/written_pattern.h"

namespace app {

// "CO 6 sts (Rnd 1)." and then "Round 2: *k1, M1L, repeat from *. (12 sts)", "Rounds 3-5: knit. (12 sts)".
std::string pattern_knitspeak(const knit::Rounds& rounds,
                              knit::ShortRowTurns turns = knit::ShortRowTurns::usual);
// Of pieces the rounds are knitspeak, twins' too; headings, deals and ends stand between them in the written pattern's words. A
// remark at the head says that other tools may not read those.
std::string pattern_knitspeak(const knit::LimbPlan& plan, const knit::PatternOptions& options = {});

}  // namespace app
