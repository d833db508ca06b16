// What the smallest steps of the stage relax do. Lengths in mesh units.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/model/event.h"

namespace knit {

struct RelaxPlanned {
  static constexpr std::string_view kind = "relax-planned";
  std::int32_t stitches, springs;
  std::int32_t lidded;  // inner rows, which lie below a lid
  float stuffing;
  double pressure, radius;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const RelaxPlanned&, const RelaxPlanned&) = default;
};

struct StitchesRelaxed {
  static constexpr std::string_view kind = "relaxed";
  std::int32_t iteration, touching;  // touching: pairs
  bool restarted, last;
  float greatest_move;  // in w
  double volume;        // inside the walls
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const StitchesRelaxed&, const StitchesRelaxed&) = default;
};

struct RelaxDone {
  static constexpr std::string_view kind = "relax-done";
  std::int32_t iterations;
  bool came_to_rest;
  float height, width, asked_height, asked_width;
  float sunk_first, sunk_last;  // of one tube; else 0
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const RelaxDone&, const RelaxDone&) = default;
};

using RelaxEvent = std::variant<RelaxPlanned, StitchesRelaxed, RelaxDone>;

}  // namespace knit
