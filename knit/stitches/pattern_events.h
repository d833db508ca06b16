// What the smallest steps of the stage pattern do.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/model/event.h"

namespace knit {

struct LineWritten {
  static constexpr std::string_view kind = "line-written";
  std::int32_t consumed, produced;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const LineWritten&, const LineWritten&) = default;
};

using PatternEvent = std::variant<LineWritten>;

}  // namespace knit
