// All figures of docs/performance.md, measured in one run: the goals of the program's speed and size, and what
// they are held against.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace benchmark {

nlohmann::ordered_json measure_suite(const std::filesystem::path& assets);

}  // namespace benchmark
