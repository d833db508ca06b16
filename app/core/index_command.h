// `knit-mesh index 6,12,17`: the label arrays for a list of row sizes.
#pragma once

#include <string>

#include "app/core/command_line.h"

namespace app {

Answer index_answer(const std::string& sizes, const std::string& placement);

}  // namespace app
