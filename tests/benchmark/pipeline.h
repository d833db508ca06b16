// The pipeline set against parsing the same file, stage by stage; seeks; what a tune and a copy cost.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/files/load.h"
#include "knit/run/timeline.h"

namespace benchmark {

double quantile(std::vector<double> values, double share);

// Milliseconds that tinyobjloader takes for an OBJ text.
double parse_once(const std::string& text);

// Parse, recorded run and bare run by stages in turn. `run_over_parse` is of the recorded run, as the program does
// it; each stage's ratio is of the bare machine. Medians.
nlohmann::ordered_json measure_against_parsing(const app::Loaded& loaded, const std::string& text,
                                               int rounds);

// Seeks to places drawn at random, as a person jumps.
nlohmann::ordered_json measure_seeks(knit::Timeline& timeline);

// From a changed epsilon to the finished run, shown at its end.
nlohmann::ordered_json measure_tuning(const app::Loaded& loaded);

nlohmann::ordered_json measure_copies(const app::Loaded& loaded);

// What the recorded steps of a run take beside its keyframes.
nlohmann::ordered_json measure_history(const knit::Timeline& timeline);

// A run of more than a million steps: the example sphere with very small stitches.
app::Loaded long_run(const std::filesystem::path& assets);

}  // namespace benchmark
