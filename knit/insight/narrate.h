// What a step did, in one sentence with its numbers: for the window, the problem list, error messages and
// step logs.
#pragma once

#include <string>
#include <string_view>

#include "knit/model/settings.h"
#include "knit/run/state.h"
#include "knit/run/step.h"

namespace knit {

// `parameters`: those in force for the step.
std::string narrate(const Step& step, const Parameters& parameters);

// What the step to come is about, for a person who waits for it: "solving for the distance".
std::string_view work_ahead(const State& state);

// A short name of the step's kind, the same in step logs and tests: "candidate-measured".
std::string_view kind_name(const Step& step);

}  // namespace knit
