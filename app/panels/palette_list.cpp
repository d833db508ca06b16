#include "app/panels/palette_list.h"

#include <iterator>

#include "app/panels/save_dialog.h"

namespace app {

namespace {

constexpr const char* no_mesh = "Open a mesh first.";

std::string unless(bool possible, const char* why_not) { return possible ? "" : why_not; }

// All that is about a run does, but for how it is played.
bool needs_mesh(const CommandInfo& info) {
  switch (info.command) {
    case Command::faster:
    case Command::slower:
    case Command::slow_motion:
      return false;
    case Command::frame_all:
    case Command::knit_along:
    case Command::copy_link:
      return true;
    default:
      return info.group == info_of(Command::play).group || info.group == info_of(Command::go_back).group ||
             info.group == info_of(Command::undo).group;
  }
}

std::string why_not(const Session& session, const CommandInfo& info) {
  if (!session.timeline && needs_mesh(info)) return no_mesh;
  const Travel& travel = session.travel;
  switch (info.command) {
    case Command::undo:
      return unless(!session.changes.undo.empty(), "There is nothing to undo.");
    case Command::redo:
      return unless(!session.changes.redo.empty(), "There is nothing to redo.");
    case Command::swap:
      return unless(session.pinned.has_value(), "No run is pinned.");
    case Command::next_touch:
    case Command::last_touch:
      return unless(travel.selected.has_value(), "Nothing is selected.");
    case Command::next_break:
    case Command::last_break:
      return unless(!travel.breaks.empty(), "There is no break condition.");
    case Command::go_back:
      return unless(!travel.history.behind.empty(), "There was no jump to go back from.");
    case Command::go_forward:
      return unless(!travel.history.ahead.empty(), "There is no way forward again.");
    default:
      return "";
  }
}

ActionEntry entry_of(const Session& session, const CommandInfo& info) {
  ActionEntry entry{words_of(info), std::string(info.group), "", PasteParameters{}, why_not(session, info),
                    keys_of(info),  info.layer.has_value()};
  // What the clipboard holds is asked for once it is wanted, not in every frame.
  if (info.command == Command::paste) return entry;
  if (auto action = info.make(session)) {
    entry.does = std::move(*action);
  } else if (entry.why_not.empty()) {
    entry.why_not = "There is nothing to do for it now.";
  }
  return entry;
}

}  // namespace

std::vector<ActionEntry> palette_entries(const Session& session, const ActionSources& sources) {
  std::vector<ActionEntry> entries;
  for (const CommandInfo& info : command_table()) entries.push_back(entry_of(session, info));
  for (const SaveKind& kind : save_kinds()) {
    entries.push_back({"Save the " + std::string(kind.words) + "...", "Files", "Asks for the file's name.",
                       kind.kind, unless(session.timeline.has_value(), no_mesh), "", false});
  }
  auto others = action_entries(session, sources);
  std::move(others.begin(), others.end(), std::back_inserter(entries));
  return entries;
}

const CommandInfo* command_of(const ActionEntry& entry) {
  for (const CommandInfo& info : command_table()) {
    if (words_of(info) == entry.words) return &info;
  }
  return nullptr;
}

}  // namespace app
