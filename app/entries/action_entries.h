// All that a person can do in this session, by name: what the palette of all actions lists. Commands of the keyboard
// and what the save dialog offers are the panels' (palette_list.h); everything else is here.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/session/action.h"

namespace app {

// Something is to be typed first.
struct ActionPrompt {
  std::string label;    // what: "Row"
  std::string example;  // could be typed as it is; shown while nothing is
  // The error is one sentence.
  std::function<std::variant<Action, std::string>(const Session& session, const std::string& typed)> read;
};

// The dialog asks for the file's name.
struct AskToSave {
  std::string what;  // as in Export
};

struct ActionEntry {
  std::string words;  // "Go to row...": no two entries have the same
  std::string group;  // "The run"
  std::string help;   // one sentence; may be empty
  std::variant<Action, ActionPrompt, AskToSave> does;
  std::string why_not;       // it cannot be done now, in one sentence; empty: it can
  std::string keys;          // "Ctrl+Z"
  bool one_of_many = false;  // stands behind the others
};

// What the disk has to say; read once, when the list is opened.
struct ActionSources {
  struct Lesson {
    std::string key, title;
  };
  std::vector<std::string> examples;
  std::vector<Lesson> lessons;                         // those that can be read
  std::vector<std::pair<std::string, Action>> recent;  // path, and how it is opened
};
ActionSources read_action_sources(const Session& session);

std::vector<ActionEntry> action_entries(const Session& session, const ActionSources& sources);

// Indices of the entries that fit what is typed, best first. With nothing typed all of them, those used lately
// (their words, newest first) before the others.
std::vector<std::size_t> find_entries(const std::vector<ActionEntry>& entries, const std::string& typed,
                                      const std::vector<std::string>& recent);

}  // namespace app
