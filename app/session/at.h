// A place in a run as scripts and lessons name it: "end", "1200", "rows:12:3".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "knit/model/stage.h"

namespace app {

// The end, a number of steps, or a place.
struct AtEnd {};
struct AtStage {
  knit::Stage stage = knit::Stage::timing;
};  // its first step
using At = std::variant<AtEnd, std::size_t, AtStage, knit::Place>;

std::optional<At> parse_at(const std::string& text);

}  // namespace app
