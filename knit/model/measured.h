// A measured number before what it counts: "1 round", "0.3 rounds". What is written as 1 is one.
#pragma once

#include <string>
#include <string_view>

#include "knit/model/words.h"

namespace knit {

inline std::string measured(double value, std::string_view one, std::string_view many) {
  const std::string number = short_number(value);
  return number + " " + std::string(number == "1" ? one : many);
}

}  // namespace knit
