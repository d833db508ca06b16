#include "app/entries/action_entries.h"

#include <algorithm>

#include "app/base/word_search.h"
#include "app/entries/action_entries_parts.h"
#include "app/files/session_file.h"
#include "app/lessons/lesson.h"
#include "app/session/program.h"

namespace app {

namespace {

constexpr int penalty_of_many = 20;  // in word_search's points
constexpr int penalty_of_idle = 10;

// Who writes a lesson hears of its faults when it is started.
std::vector<ActionSources::Lesson> readable_lessons(const std::filesystem::path& assets) {
  std::vector<ActionSources::Lesson> lessons;
  for (LessonEntry& entry : list_lessons(assets))
    if (!entry.key.empty()) lessons.push_back({std::move(entry.key), std::move(entry.title)});
  return lessons;
}

}  // namespace

std::string without_dashes(const std::string& sentence) {
  return sentence.substr(sentence.rfind("--", 0) == 0 ? 2 : 0);
}

ActionSources read_action_sources(const Session& session) {
  ActionSources sources{
      list_examples(session.program->assets), readable_lessons(session.program->assets), {}};
  for (const std::string& path : session.program->preferences.recent) {
    // Examples have entries of their own.
    if (path.rfind("example:", 0) != 0) sources.recent.emplace_back(path, opening_of(path));
  }
  return sources;
}

std::vector<ActionEntry> action_entries(const Session& session, const ActionSources& sources) {
  EntryList list{session, {}};
  add_run_entries(list);
  add_parameter_entries(list);
  add_view_entries(list);
  add_curve_entries(list);
  add_file_entries(list, sources);
  add_learning_entries(list, sources);
  return std::move(list.entries);
}

std::vector<std::size_t> find_entries(const std::vector<ActionEntry>& entries, const std::string& typed,
                                      const std::vector<std::string>& recent) {
  struct Found {
    std::size_t index;
    int points;
  };
  std::vector<Found> found;
  const bool all = std::all_of(typed.begin(), typed.end(), [](char c) { return c == ' '; });
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const ActionEntry& entry = entries[i];
    const std::string more = entry.group + " " + entry.help;
    const auto points = fit(typed, {entry.words, more, entry.keys});
    if (!points) continue;
    const auto used = std::find(recent.begin(), recent.end(), entry.words);
    const int lately = static_cast<int>(recent.end() - used);  // 0: not
    // Nothing typed: what was used lately first, then in the list's order. Else it only decides between equals.
    const int idle = entry.why_not.empty() || all ? 0 : penalty_of_idle;
    found.push_back(
        {i, *points - (entry.one_of_many ? penalty_of_many : 0) - idle + (all ? 100 * lately : lately / 4)});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.points > b.points; });
  std::vector<std::size_t> indices(found.size());
  std::transform(found.begin(), found.end(), indices.begin(), [](const Found& f) { return f.index; });
  return indices;
}

}  // namespace app
