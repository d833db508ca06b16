// What the timings and rows from contours cost on spheres of 10 k, 100 k and 1 M triangles.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace benchmark {

// Milliseconds that tinyobjloader takes for an OBJ text.
double parse_once(const std::string& text);

// Ratios to parsing the same mesh, each the median of a few turns of both.
nlohmann::ordered_json measure_sizes();

}  // namespace benchmark
