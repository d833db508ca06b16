#include "app/files/preferences_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/base/json_fields.h"
#include "app/files/session_file.h"

namespace app {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* version_key = "knit-mesh-preferences";
constexpr std::int64_t preferences_version = 1;
constexpr double widest_split = 10000.0;
constexpr std::int64_t most_answers = 1000000;

// Anything but a whole path is not valid there.
std::optional<fs::path> folder_in(const Environment& variable, const char* name,
                                  std::string_view below = "") {
  const fs::path folder = variable(name);
  if (!folder.is_absolute()) return std::nullopt;
  return below.empty() ? folder : folder / below;
}

Platform this_platform() {
#if defined(_WIN32)
  return Platform::windows;
#elif defined(__APPLE__)
  return Platform::mac;
#else
  return Platform::xdg;
#endif
}

void read_panels(JsonFields& fields, Preferences& preferences) {
  if (fields.has("panels")) {
    JsonFields panels = fields.object("panels");
    for (std::size_t i = 0; i < panel_keys.size(); ++i) {
      const std::string key(panel_keys[i]);
      if (panels.has(key)) preferences.panels[i] = panels.flag(key);
    }
  }
  if (fields.has("row-columns")) {
    JsonFields columns = fields.object("row-columns");
    for (std::size_t i = 0; i < row_column_keys.size(); ++i) {
      const std::string key(row_column_keys[i]);
      if (columns.has(key)) preferences.row_columns[i] = columns.flag(key);
    }
  }
  if (!fields.has("splits")) return;
  JsonFields splits = fields.object("splits");
  for (std::size_t i = 0; i < split_keys.size(); ++i) {
    const std::string key(split_keys[i]);
    if (splits.has(key)) preferences.splits[i] = splits.number(key, 0.0, widest_split);
  }
}

void read_recent(JsonFields& fields, Preferences& preferences) {
  if (!fields.has("recent")) return;
  for (const nlohmann::json& name : fields.array("recent")) {
    if (!name.is_string()) return fields.set_fault("recent", "must be a list of texts in quotes.");
    if (preferences.recent.size() < most_recent) preferences.recent.push_back(name.get<std::string>());
  }
}

void read_learning(JsonFields& fields, Preferences& preferences) {
  if (fields.has("longest-streak"))
    preferences.longest_streak = static_cast<std::int32_t>(fields.whole("longest-streak", 0, most_answers));
  if (!fields.has("lessons")) return;
  JsonFields lessons = fields.object("lessons");
  if (!lessons.json().is_object()) return;
  for (const auto& [key, unused] : lessons.json().items()) {
    JsonFields lesson = lessons.object(key);
    const auto of = static_cast<std::int32_t>(lesson.whole("of", 0, most_answers));
    const auto right = static_cast<std::int32_t>(lesson.whole("right", 0, of));
    preferences.lessons[key] = {right, of};
  }
}

}  // namespace

std::optional<fs::path> preferences_file(Platform platform, const Environment& variable) {
  std::optional<fs::path> folder;
  switch (platform) {
    case Platform::windows:
      folder = folder_in(variable, "APPDATA");
      break;
    case Platform::mac:
      folder = folder_in(variable, "HOME", "Library/Application Support");
      break;
    case Platform::xdg:
      folder = folder_in(variable, "XDG_CONFIG_HOME");
      if (!folder) folder = folder_in(variable, "HOME", ".config");
      break;
  }
  if (!folder) return std::nullopt;
  return *folder / "knit-mesh" / "preferences.json";
}

std::optional<fs::path> preferences_file() {
  return preferences_file(this_platform(), [](const char* name) -> std::string {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
  });
}

std::string preferences_text(const Preferences& preferences) {
  Json json;
  json[version_key] = preferences_version;
  json["theme"] = theme_keys[static_cast<std::size_t>(preferences.theme)];
  json["scale"] = preferences.scale;
  json["motion"] = preferences.motion;
  for (std::size_t i = 0; i < panel_keys.size(); ++i)
    json["panels"][std::string(panel_keys[i])] = preferences.panels[i];
  for (std::size_t i = 0; i < split_keys.size(); ++i)
    json["splits"][std::string(split_keys[i])] = preferences.splits[i];
  for (std::size_t i = 0; i < row_column_keys.size(); ++i)
    json["row-columns"][std::string(row_column_keys[i])] = preferences.row_columns[i];
  json["recent"] = preferences.recent;
  json["lessons"] = Json::object();
  for (const auto& [key, score] : preferences.lessons)
    json["lessons"][key] = {{"right", score.right}, {"of", score.of}};
  json["longest-streak"] = preferences.longest_streak;
  // Names of files need not be valid UTF-8; such a one is found no more, the rest is kept.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::variant<Preferences, std::string> read_preferences(std::string_view text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) return "it is not valid JSON.";
  JsonFields fields(json);
  if (!fields.fault().empty()) return fields.fault();
  if (!fields.has(version_key))
    return "\"" + std::string(version_key) + "\", the version, is missing: it is another kind of file.";
  if (fields.whole(version_key, 1, most_answers) > preferences_version)
    return "a newer knit-mesh has written it.";
  Preferences preferences;
  if (fields.has("theme")) preferences.theme = static_cast<ThemeKind>(fields.choice("theme", theme_keys));
  if (fields.has("scale")) preferences.scale = fields.number("scale", smallest_scale, largest_scale);
  if (fields.has("motion")) preferences.motion = fields.flag("motion");
  read_panels(fields, preferences);
  read_recent(fields, preferences);
  read_learning(fields, preferences);
  if (!fields.fault().empty()) return fields.fault();
  return preferences;
}

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
