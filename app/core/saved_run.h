// The run that a session file is about: its mesh, parameters and edits, without opening it.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "app/core/session.h"

namespace app {

struct SavedRun {
  Source source;  // a file: where it lies, as seen from the working folder
  knit::Parameters base;
  std::vector<knit::Edit> edits;
};

// The error is one sentence.
std::variant<SavedRun, std::string> read_saved_run(const std::filesystem::path& path);

}  // namespace app
