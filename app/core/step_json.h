// A step as JSON, one object a line: what step logs and reports are made of.
#pragma once

#include <nlohmann/json.hpp>

#include "knit/parameters.h"
#include "knit/step.h"

namespace app {

nlohmann::ordered_json to_json(const knit::Parameters& parameters);

// `index`: the step's number in the run, from 1.
nlohmann::ordered_json to_json(const knit::Step& step, std::size_t index, const knit::Parameters& parameters);

}  // namespace app
