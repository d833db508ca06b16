// What the palette of all actions lists: commands, what can be saved, and all else that there is to do.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "app/entries/action_entries.h"
#include "app/panels/dialogs/destination_field.h"
#include "app/panels/kit/commands.h"

namespace app {

std::vector<ActionEntry> palette_entries(const Session& session, const ActionSources& sources);

// The command that an entry stands for; null: none.
const CommandInfo* command_of(const ActionEntry& entry);

struct ActionPaletteState {
  bool shown = false;
  std::array<char, 512> field{};
  int field_number = 0;  // changes when the field is emptied or filled from outside
  bool refocus = false;
  std::string begin_with;           // what the field holds when it opens: by a link
  std::string searched;             // what the list was last made for
  std::size_t chosen = 0;           // in the list shown
  bool follow = false;              // the chosen line is to be scrolled to
  std::string asking;               // the words of the entry for which something is typed; empty: searching
  std::vector<std::string> recent;  // words of entries, newest first
  std::shared_ptr<const ActionSources> sources;  // read when it opens
  DestinationLookup lookup;                      // of what is typed, where it names a place
};

}  // namespace app
