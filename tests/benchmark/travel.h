// What time travel costs: from a changed parameter to the finished picture, and scrubbing through a long run.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace benchmark {

// Milliseconds of the program's own thread, and of all its threads (a software rasteriser's too), beside a third
// of a frame at 60 Hz.
nlohmann::ordered_json measure_tuning_to_picture(const std::filesystem::path& assets);

// A run of a million steps, scrubbed from end to end as by a hand on the track.
nlohmann::ordered_json measure_long_scrubbing(const std::filesystem::path& assets);

}  // namespace benchmark
