#include "app/actions/preferences_keeper.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

#include "app/actions/hosting.h"
#include "app/base/files.h"
#include "app/files/preferences_file.h"
#include "app/session/outbox.h"
#include "app/session/program.h"

namespace app {

namespace fs = std::filesystem;

namespace {

// None: there is no such file.
std::optional<std::string> content_of(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return std::nullopt;
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::string spoilt_words(const fs::path& file, const std::string& fault) {
  return "The preferences in " + file.string() +
         " are left out: " + fault.substr(0, fault.find_last_not_of('.') + 1) +
         "; correct the file and start again, or change a setting: then it is kept as " +
         file.filename().string() + ".old.";
}

// What was opened at this start comes before what the file remembers. An example may be there because nothing was
// asked for: it does not count.
std::vector<std::string> joined(const std::vector<std::string>& now, const std::vector<std::string>& kept) {
  std::vector<std::string> all;
  for (const std::string& name : now) {
    if (name.rfind(example_prefix, 0) != 0) all.push_back(name);
  }
  for (const std::string& name : kept) {
    if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(name);
  }
  all.resize(std::min(all.size(), most_recent));
  return all;
}

}  // namespace

PreferencesKeeper::PreferencesKeeper(Session& session, std::optional<fs::path> file, ForThisStart given)
    : file_(std::move(file)), given_(given) {
  if (!file_) return;
  const std::vector<std::string> opened = std::exchange(session.program->preferences.recent, {});
  if (const auto text = content_of(*file_)) {
    auto result = read_preferences(*text);
    if (const auto* fault = std::get_if<std::string>(&result)) {
      spoilt_ = true;
      notify(session, Notice::Kind::warning, spoilt_words(*file_, *fault));
    } else {
      read_ = std::get<Preferences>(std::move(result));
    }
  }
  session.program->preferences = read_;
  session.program->preferences.recent = joined(opened, read_.recent);
  if (given_.theme) session.program->preferences.theme = *given_.theme;
  if (given_.scale) session.program->preferences.scale = *given_.scale;
  if (given_.row_columns) session.program->preferences.row_columns = *given_.row_columns;
  // A file that somebody may want to repair is not replaced just because the program was started.
  known_ = spoilt_ ? lasting(session.program->preferences) : read_;
}

// As the file shall have them. What was given for this start counts until it is changed by hand.
Preferences PreferencesKeeper::lasting(const Preferences& preferences) {
  Preferences kept = preferences;
  if (given_.theme && *given_.theme != preferences.theme) given_.theme.reset();
  if (given_.scale && *given_.scale != preferences.scale) given_.scale.reset();
  if (given_.row_columns && *given_.row_columns != preferences.row_columns) given_.row_columns.reset();
  if (given_.theme) kept.theme = read_.theme;
  if (given_.scale) kept.scale = read_.scale;
  if (given_.row_columns) kept.row_columns = read_.row_columns;
  return kept;
}

void PreferencesKeeper::pass(Session& session, double seconds) {
  if (!file_) return;
  waited_ += seconds;
  Preferences now =
      lasting(session.program->preferences);  // also between writings: a change by hand is noticed
  if (waited_ < seconds_between || now == known_) return;
  write(session);
}

void PreferencesKeeper::end(Session& session) {
  if (file_ && lasting(session.program->preferences) != known_) write(session);
}

void PreferencesKeeper::write(Session& session) {
  waited_ = 0.0;
  known_ = lasting(session.program->preferences);
  std::error_code error;
  fs::create_directories(file_->parent_path(), error);
  if (std::exchange(spoilt_, false)) {
    fs::path old = *file_;
    old += ".old";
    fs::rename(*file_, old, error);
  }
  const auto trouble = write_file(*file_, preferences_text(known_));
  if (!trouble || std::exchange(told_, true)) return;
  notify(session, Notice::Kind::warning, "The preferences are not remembered: " + *trouble);
}

}  // namespace app
