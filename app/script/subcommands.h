// `knit-mesh check FILE`: a written pattern read as a knitter reads it, and every place where it does not add up.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/script/command_line.h"

namespace app {

// 0 where every count holds, 1 where something does not add up (each a line of `out`, then a summary), 5 where a line of
// work is not understood, 2 where `text` holds no pattern. `name` is what the text is called in a message.
enum class CheckForm : std::uint8_t { lines, json };
Answer check_text(std::string_view text, const std::string& name, CheckForm form = CheckForm::lines);

// "-" reads standard input; 2 also where it cannot be read.
Answer check_file(const std::filesystem::path& path, CheckForm form = CheckForm::lines);

// `knit-mesh index 6,12,17`: the label arrays for a list of row sizes.

// The placements that need no more than sizes: "thesis or even".
std::string placements_of_index();
Answer index_answer(const std::string& sizes, const std::string& placement);

}  // namespace app
