// A session file that was read takes the place of what is open.
#pragma once

#include <chrono>

#include "app/files/session_file.h"

namespace app {

// Replaces what is open; `start`: when opening began.
void show_session(Session& session, OpenedSession opened, std::chrono::steady_clock::time_point start);

}  // namespace app
