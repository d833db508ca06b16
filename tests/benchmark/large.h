// Whether a mesh of so many triangles leaves the window responsive: what each thing done in a frame costs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace benchmark {

// A sphere of about so many triangles, written to a file and opened beside a window, worked out with rows from
// contours, looked at, scrubbed and clicked. Milliseconds of the window's own thread, without drawing; at the end
// what drawing costs with whatever OpenGL there is.
nlohmann::ordered_json measure_large(const std::filesystem::path& assets, std::size_t triangles);

}  // namespace benchmark
