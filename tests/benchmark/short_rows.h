// What choosing short rows costs a run: with them against without, in turn.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

namespace benchmark {

// Of each mesh with linear and with geodesic time, as the preset "best-rows" knits it: processor time of a run without short
// rows and with `auto`, medians, and their ratio; the ratio of all sums. No meshes: the examples that bend or branch.
nlohmann::ordered_json measure_short_rows(const std::filesystem::path& assets,
                                          const std::vector<std::filesystem::path>& meshes);

}  // namespace benchmark
