// A session as a small JSON file with a version: mesh reference, parameters and edits, place, camera, layers, break
// conditions, the pinned run's parameters. docs/sessions.md has the fields.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/core/action.h"

namespace app {

// What a session file at `path` would say; empty when nothing can be said, and `error` why, as one sentence.
struct SessionText {
  std::string text;
  std::string error;
};
SessionText session_text(const Session& session, const std::filesystem::path& path);

// Written aside and renamed; the error is one sentence.
std::optional<std::string> save_session(const Session& session, const std::filesystem::path& path);
// Replaces what is open; on failure the session stays as it was.
std::optional<std::string> open_session(Session& session, const std::filesystem::path& path);

// Remembers that the session is what the file at `path` says.
void note_saved(Session& session, const std::filesystem::path& path);
// The session file that says exactly what the session is now.
std::optional<std::filesystem::path> saved_unchanged(const Session& session);

// Whether to open it as a session: by its ending, or by what it begins with.
bool is_session_file(const std::filesystem::path& path);
// How a person's file is opened: OpenSession or OpenFile.
Action opening_of(const std::filesystem::path& path);

}  // namespace app
