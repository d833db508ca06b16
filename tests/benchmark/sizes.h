// What the timings and rows from contours cost on spheres of 10 k, 100 k and 1 M triangles.
#pragma once

#include <nlohmann/json.hpp>

namespace benchmark {

// Ratios to parsing the same mesh, each the median of a few turns of both.
nlohmann::ordered_json measure_sizes();

}  // namespace benchmark
