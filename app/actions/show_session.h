// A session file that was read takes the place of what is open.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "app/files/session_file.h"

namespace app {

// Replaces what is open; `start`: when opening began.
void show_session(Session& session, OpenedSession opened, std::chrono::steady_clock::time_point start);
// Reads and shows it; on failure the session stays as it was, and the error is one sentence.
std::optional<std::string> open_session(Session& session, const std::filesystem::path& path);

}  // namespace app
