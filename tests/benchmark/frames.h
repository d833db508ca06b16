// What a whole frame costs, with drawing by whatever OpenGL there is.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace benchmark {

// Frames of the thesis sphere bare, with its times, half picked and finished, taken in turn; `over_bare`: the
// finished one's wall time in those of the bare one.
nlohmann::ordered_json measure_frames(const std::filesystem::path& assets);

}  // namespace benchmark
