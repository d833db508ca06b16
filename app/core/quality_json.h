// The report card as JSON, for the report and for scripts. Its fields are a contract.
//
// What is not there yet is null: a whole group without values (`wale`, `mirror`, `distance`), else the value.
#pragma once

#include <nlohmann/json.hpp>

#include "knit/closeness.h"
#include "knit/quality.h"

namespace app {

nlohmann::ordered_json to_json(const knit::Quality& quality);
nlohmann::ordered_json to_json(const knit::Closeness& closeness);

// Both in one object. Without a closeness, `distance` and `area_ratio` are null.
nlohmann::ordered_json quality_json(const knit::Quality& quality, const knit::Closeness* closeness);

}  // namespace app
