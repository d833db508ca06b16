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

// Rows and items count from 1; a stage without rows has row 0. Inside, a Place's items count from 0.
std::optional<At> parse_at(const std::string& text);

// "rows:12:3", as parse_at reads it. An item beyond all is the greatest that can be written.
std::string text_of(const knit::Place& place);

}  // namespace app
