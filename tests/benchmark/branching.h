// What a shape that branches costs: parsing, the run with each kind of time, seeks, and a frame while a knob is dragged.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace benchmark {

// The mesh from a file, a teddy bear's for one; empty: a body of cubes with a head, ears, arms and legs. Rows are contours,
// stitches 2 % of the diagonal wide. Ratios are to parsing the same file, or to the solve of the time.
nlohmann::ordered_json measure_branching(const std::filesystem::path& assets,
                                         const std::filesystem::path& mesh);

}  // namespace benchmark
