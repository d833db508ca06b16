// Preferences as a file has them, where that file is, and what was opened lately.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "app/session/action.h"
#include "app/session/session.h"

namespace app {

enum class Platform : std::uint8_t { xdg, mac, windows };

// An environment variable's value; empty: not set.
using Environment = std::function<std::string(const char*)>;

// The usual place of such a system; none where the environment does not say where that is.
std::optional<std::filesystem::path> preferences_file(Platform platform, const Environment& variable);
std::optional<std::filesystem::path> preferences_file();  // of this one

std::string preferences_text(const Preferences& preferences);
// Or one sentence that names the field. A field that is not there is as it was at first; one that is wrong spoils
// the file.
std::variant<Preferences, std::string> read_preferences(std::string_view text);

// What was opened lately, newest first: by an absolute path, or "example:NAME".

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
