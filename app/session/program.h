// What belongs to the program itself, whatever is open.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/session/preferences.h"

namespace app {

// A session from before a crash, offered.
struct Rescued {
  std::filesystem::path path;
  std::string words;  // "thesis-sphere, row 14"
  friend bool operator==(const Rescued&, const Rescued&) = default;
};

struct Program {
  std::filesystem::path assets;  // the folder of examples and fonts
  Preferences preferences;
  std::optional<Rescued> rescued;
  bool embedded = false;  // in a course page: without menus
  friend bool operator==(const Program&, const Program&) = default;
};

}  // namespace app
