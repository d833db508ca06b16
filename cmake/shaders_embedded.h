#pragma once

#include <string_view>

namespace shaders {

// The text of shaders/<name> as it was when the program was configured; empty if there is no such file.
std::string_view source(std::string_view name);

}  // namespace shaders
