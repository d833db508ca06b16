// What was opened lately, newest first: by an absolute path, or "example:NAME".
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "app/core/action.h"

namespace app {

inline constexpr std::string_view example_prefix = "example:";
inline constexpr std::size_t most_recent = 10;

std::string recent_name(const std::filesystem::path& file);
// Comes first; each stands there once.
void note_recent(Preferences& preferences, const std::string& name);
Action opening_of_recent(const std::string& name);

// For a menu: what it is, and where.
struct RecentWords {
  std::string what;   // "bunny.obj"
  std::string where;  // its folder; of an example: "example"
};
RecentWords words_of_recent(const std::string& name);

}  // namespace app
