// What the smallest steps of the stage settle do.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/model/event.h"

namespace knit {

struct SettlingBegun {
  static constexpr std::string_view kind = "settling-begun";
  std::int32_t stitches, wales, courses;
  double sum;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const SettlingBegun&, const SettlingBegun&) = default;
};

struct StitchesSettled {
  static constexpr std::string_view kind = "stitches-settled";
  std::int32_t iteration, tries;
  bool taken, last;
  float before, after, shift;      // of the sum; shift: that was used
  float mean_move, greatest_move;  // in w
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const StitchesSettled&, const StitchesSettled&) = default;
};

using SettleEvent = std::variant<SettlingBegun, StitchesSettled>;

}  // namespace knit
