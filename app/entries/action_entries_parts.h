// The list of entries in the making; its parts stand in files of their own.
#pragma once

#include "app/entries/action_entries.h"
#include "app/session/document.h"

namespace app {

// What the entries are grouped by.
namespace group {
inline constexpr const char* the_run = "The run";
inline constexpr const char* finding = "Finding why";
inline constexpr const char* changes = "Changes";
inline constexpr const char* parameters = "Parameters";
inline constexpr const char* learning = "Learning";
inline constexpr const char* the_glossary = "The glossary";
inline constexpr const char* view = "The view";
inline constexpr const char* panels = "Panels";
inline constexpr const char* program = "The program";
inline constexpr const char* files = "Files";
inline constexpr const char* the_pattern = "The pattern";
}  // namespace group

struct EntryList {
  const Session& session;
  std::vector<ActionEntry> entries;

  [[nodiscard]] std::string unless_open() const { return session.document ? "" : "Open a mesh first."; }
  void add(ActionEntry entry) { entries.push_back(std::move(entry)); }
};

// A sentence of the command line's about a value; its "--" says nothing here.
std::string without_dashes(const std::string& sentence);

void add_run_entries(EntryList& list);        // going to a place, why, breaks, comparing
void add_parameter_entries(EntryList& list);  // each parameter
void add_view_entries(EntryList& list);       // panels, lists, looking from a side, theme, size
void add_curve_entries(EntryList& list);      // where knitting begins and ends
void add_file_entries(EntryList& list, const ActionSources& sources);  // opening, saving, pictures
void add_learning_entries(EntryList& list, const ActionSources& sources);

}  // namespace app
