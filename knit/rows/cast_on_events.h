// What the smallest steps of the stage cast on do, where rows are rings of vertices.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/model/event.h"

namespace knit {

struct CycleFound {
  static constexpr std::string_view kind = "cycle-found";
  std::int32_t level, last_level, vertices, passed_over;
  double time, length;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const CycleFound&, const CycleFound&) = default;
};

struct StitchCastOn {
  static constexpr std::string_view kind = "stitch-cast-on";
  std::int32_t stitch, of;
  double arc;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const StitchCastOn&, const StitchCastOn&) = default;
};

using CastOnEvent = std::variant<CycleFound, StitchCastOn>;

}  // namespace knit
