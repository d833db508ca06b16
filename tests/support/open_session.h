// A session file opened at once: a person's goes through the background.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "app/actions/show_session.h"
#include "app/session/program.h"
#include "app/session/session.h"

namespace test_support {

// On failure the session stays as it was, and the error is one sentence.
inline std::optional<std::string> open_session(app::Session& session, const std::filesystem::path& path) {
  auto read = app::read_session(session.program->assets, path);
  if (auto* error = std::get_if<std::string>(&read)) return std::move(*error);
  app::show_session(session, std::get<app::OpenedSession>(std::move(read)), std::chrono::steady_clock::now());
  return std::nullopt;
}

}  // namespace test_support
