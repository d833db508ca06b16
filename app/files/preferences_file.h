// Preferences in a file, from one start to the next. Only a window has one: pictures without a display must not
// depend on who makes them.
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

// What counts for one start only, because the command line says so.
struct ForThisStart {
  std::optional<ThemeKind> theme;
  std::optional<double> scale;
};

// Keeps the file and a session's preferences alike.
class PreferencesKeeper {
 public:
  static constexpr double seconds_between = 3.0;  // writings, at least

  // Reads the file into the session, after what was opened at the start was. A file that cannot be read is told of
  // in a notice and let be until there is something to write; then it is moved to FILE.old. `file` none: nothing
  // is read or written, ever.
  PreferencesKeeper(Session& session, std::optional<std::filesystem::path> file, ForThisStart given = {});

  // Time has passed: writes when it is due and something has changed.
  void pass(Session& session, double seconds);
  // A clean end: writes what has changed since.
  void end(Session& session);

 private:
  Preferences lasting(const Preferences& preferences);
  void write(Session& session);

  std::optional<std::filesystem::path> file_;
  ForThisStart given_;
  Preferences read_;
  Preferences known_;    // as the file has them
  bool spoilt_ = false;  // the file is there and cannot be read
  bool told_ = false;    // that it cannot be written
  double waited_ = 0.0;
};

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
