// What the palette of all actions lists: commands, what can be saved, and all else that there is to do.
#pragma once

#include "app/actions/action_entries.h"
#include "app/panels/kit/commands.h"

namespace app {

std::vector<ActionEntry> palette_entries(const Session& session, const ActionSources& sources);

// The command that an entry stands for; null: none.
const CommandInfo* command_of(const ActionEntry& entry);

}  // namespace app
