// A step's numbers by name, in reading order: the one list behind step logs and the window's table.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "knit/model/step.h"

namespace knit {

struct StepField {
  std::string_view name;  // "distance"
  std::variant<bool, std::int64_t, double, std::string> value;
};

std::vector<StepField> fields_of(const Step& step);

}  // namespace knit
