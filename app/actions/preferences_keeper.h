// Keeps a session's preferences and their file alike, from one start to the next. Only a window has one: pictures
// without a display must not depend on who makes them.
#pragma once

#include <filesystem>
#include <optional>

#include "app/session/preferences.h"
#include "app/session/session.h"

namespace app {

// What counts for one start only, because the command line says so.
struct ForThisStart {
  std::optional<ThemeKind> theme;
  std::optional<double> scale;
  std::optional<decltype(Preferences::row_columns)> row_columns = std::nullopt;
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

}  // namespace app
