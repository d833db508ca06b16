// A session file read, its mesh loaded and prepared: ready to be shown, nothing of it shown yet.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/files/load.h"
#include "app/files/session_json.h"
#include "app/session/action.h"
#include "app/session/document.h"
#include "app/session/session.h"

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

// The run that a session file is about: its mesh, parameters and edits, without opening it.

struct SavedRun {
  Source source;  // a file: where it lies, as seen from the working folder
  knit::Parameters base;
  std::vector<knit::Edit> edits;
};

// The error is one sentence.
std::variant<SavedRun, std::string> read_saved_run(const std::filesystem::path& path);

// A session as a small JSON file with a version: mesh reference, parameters and edits, place, camera, layers, break
// conditions, the pinned run's parameters. docs/sessions.md has the fields.

// What a session file at `path` would say; empty when nothing can be said, and `error` why, as one sentence.
struct SessionText {
  std::string text;
  std::string error;
};
SessionText session_text(const Session& session, const std::filesystem::path& path);

// Written aside and renamed; the error is one sentence.
std::optional<std::string> save_session(const Session& session, const std::filesystem::path& path);

// The session and the file at `path` that says it; none where no file can.
std::optional<SavedAs> saved_as(const Session& session, const std::filesystem::path& path);
// The session file that says exactly what the session is now.
std::optional<std::filesystem::path> saved_unchanged(const Session& session);

// Whether to open it as a session: by its ending, or by what it begins with.
bool is_session_file(const std::filesystem::path& path);
// A written pattern, by its ending: text, Markdown, HTML.
bool is_pattern_file(const std::filesystem::path& path);
// How a person's file is opened: OpenSession, CheckFile, OpenCurves or OpenFile.
Action opening_of(const std::filesystem::path& path);

}  // namespace app
