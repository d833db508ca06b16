// A long life in short: the program's own actions over and over, and whether its memory stays flat.
#pragma once

#include <filesystem>

namespace benchmark {

// Opens, tunes, plays, scrubs, asks, exports, saves and opens again, as a window does, with drawing where there is
// OpenGL, for so long. Prints a line for each round: seconds, megabytes resident, megabytes in use. True when neither
// grows any more after the first rounds.
bool soak(const std::filesystem::path& assets, double seconds);

}  // namespace benchmark
