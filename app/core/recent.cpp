#include "app/core/recent.h"

#include <algorithm>

#include "app/core/session_file.h"

namespace app {

namespace fs = std::filesystem;

namespace {

bool is_example(std::string_view name) { return name.substr(0, example_prefix.size()) == example_prefix; }

}  // namespace

std::string recent_name(const fs::path& file) {
  std::error_code error;
  const fs::path absolute = fs::absolute(file, error);
  return (error ? file : absolute).lexically_normal().string();
}

void note_recent(Preferences& preferences, const std::string& name) {
  std::vector<std::string>& recent = preferences.recent;
  std::erase(recent, name);
  recent.insert(recent.begin(), name);
  recent.resize(std::min(recent.size(), most_recent));
}

Action opening_of_recent(const std::string& name) {
  if (is_example(name)) return OpenExample{name.substr(example_prefix.size())};
  return opening_of(name);
}

RecentWords words_of_recent(const std::string& name) {
  if (is_example(name)) return {name.substr(example_prefix.size()), "example"};
  const fs::path path = name;
  return {path.filename().string(), path.parent_path().string()};
}

}  // namespace app
