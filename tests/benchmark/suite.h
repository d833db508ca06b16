// All figures of docs/performance.md, measured in one run: the goals of the program's speed and size, and what
// they are held against.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace benchmark {

// `branching`: a mesh of a shape that branches; empty: one made in code.
nlohmann::ordered_json measure_suite(const std::filesystem::path& assets,
                                     const std::filesystem::path& branching);

}  // namespace benchmark
