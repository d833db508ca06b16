// What checking a written pattern costs: a megabyte of it, and one key typed into a long one.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace benchmark {

// `over_parse`: a megabyte of pattern over parsing as much of a mesh's text. `sizes_over_one`: as much text that tells 40
// sizes, over that. `key`: one letter typed into a pattern of 1,000 lines, with all that the panels do in its frame.
// Processor time, in turn; medians.
nlohmann::ordered_json measure_checking(const std::filesystem::path& assets);

}  // namespace benchmark
