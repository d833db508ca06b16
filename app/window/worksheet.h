// The worksheet of the lesson that is open, with its pictures, as a file. The error is one sentence.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/session/session.h"
#include "app/window/frame.h"

namespace app {

std::optional<std::string> save_worksheet(const Session& session, const std::filesystem::path& path,
                                          FrameDrawer& drawer);
// Without any display. Where there are no pictures it is written without them, and `note` says why.
std::optional<std::string> save_worksheet_headless(const Session& session, const std::filesystem::path& path,
                                                   std::string& note);

}  // namespace app
