// What a step did, in one sentence with its numbers: for the window, the problem list, error messages and
// step logs.
#pragma once

#include <string>

#include "knit/model/parameters.h"
#include "knit/model/step.h"
#include "knit/run/state.h"

namespace knit {

// `parameters`: those in force for the step.
std::string narrate(const Step& step, const Parameters& parameters);

// What the step to come is about, for a person who waits for it: "solving for the distance".
std::string_view work_ahead(const State& state);

// A short name of the step's kind, the same in step logs and tests: "candidate-measured".
std::string_view kind_name(const Step& step);

std::string_view name_of(Label label);      // "M1R"
std::string_view name_of(Rule rule);        // "remainder last (R4)"
std::string_view name_of(Verdict verdict);  // "too near"

// Three significant digits are enough for a sentence: "0.0483".
std::string short_number(double value);

}  // namespace knit
