// A session file read, its mesh loaded and prepared: ready to be shown, nothing of it shown yet.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "app/core/load.h"
#include "app/core/session_json.h"

namespace app {

struct OpenedSession {
  std::filesystem::path path;
  SavedSession saved;
  Loaded loaded;                             // findings are those of `input`
  std::shared_ptr<const knit::Input> input;  // the mesh as the session's parameters weld it
  std::optional<Pin> pinned;
  bool changed = false;  // it is another mesh than when the session was saved
};

// Reads nothing but files: it may run beside the session. The error is one sentence; `progress` as in load.h.
std::variant<OpenedSession, std::string> read_session(const std::filesystem::path& assets,
                                                      const std::filesystem::path& path,
                                                      knit::Progress* progress = nullptr);
// Replaces what is open; `start`: when opening began.
void show_session(Session& session, OpenedSession opened, std::chrono::steady_clock::time_point start);

}  // namespace app
