// All parameters as text, to copy, keep and paste: one "key = value" a line, in the table's order, the values
// as the command line takes them. '#' begins a comment.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/model/settings_table.h"

namespace app {

// Reads back as equal parameters.
std::string parameters_text(const knit::Parameters& parameters);

// Keys that are missing stay as in `base`. The error is one sentence that names the line.
std::variant<knit::Parameters, std::string> read_parameters_text(std::string_view text,
                                                                 const knit::Parameters& base);

}  // namespace app
