// A colour as a person types it: "#rrggbb", in digits of base sixteen of either case.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/scene/colour.h"

namespace app {

std::string hex_text(Colour colour);
// None for any other text.
std::optional<Colour> colour_of_hex(std::string_view text);

}  // namespace app
