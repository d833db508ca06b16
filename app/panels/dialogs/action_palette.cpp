#include "app/panels/dialogs/action_palette.h"
#include "app/files/export.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/panels/dialogs/top_popup.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "app/panels/kit/widgets.h"
#include "app/session/document.h"
#include "app/session/view.h"

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
  if (!session.document) return needs_mesh(info) ? no_mesh : "";
  const Travel& travel = session.document->travel;
  switch (info.command) {
    case Command::undo:
      return unless(!session.document->changes.undo.empty(), "There is nothing to undo.");
    case Command::redo:
      return unless(!session.document->changes.redo.empty(), "There is nothing to redo.");
    case Command::swap:
      return unless(session.document->pinned.has_value(), "No run is pinned.");
    case Command::next_touch:
    case Command::last_touch:
      return unless(travel.selected.has_value(), "Nothing is selected.");
    case Command::next_break:
    case Command::last_break:
      return unless(!session.view->breaks.empty(), "There is no break condition.");
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
  for (const ExportInfo* kind : exports_of_menu()) {
    entries.push_back({"Save the " + std::string(kind->words) + "...", "Files", "Asks for the file's name.",
                       AskToSave{std::string(kind->key)}, unless(session.document.has_value(), no_mesh), "",
                       false});
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

// The palette of all actions: type a few letters of what to do, Enter does it. Over the head of the view, as editors
// have it.

namespace {

constexpr const char* popup = "All actions";
constexpr int lines_shown = 12;
constexpr std::size_t most_recent = 30;

// One frame's look at it.
struct PaletteView {
  ActionPaletteState& state;
  std::vector<ActionEntry> entries;
  std::vector<std::size_t> found;  // indices of entries, best first

  [[nodiscard]] std::string typed() const { return state.field.data(); }
  [[nodiscard]] const ActionEntry* chosen() const {
    return state.chosen < found.size() ? &entries[found[state.chosen]] : nullptr;
  }
  // For which something is typed; null: none, one is searched for.
  [[nodiscard]] const ActionEntry* asking() const {
    const auto asked = std::find_if(entries.begin(), entries.end(), [&](const ActionEntry& entry) {
      return entry.words == state.asking && std::holds_alternative<ActionPrompt>(entry.does);
    });
    return asked == entries.end() ? nullptr : &*asked;
  }
};

void fill_field(ActionPaletteState& state, const std::string& words) {
  state.field.fill('\0');
  std::copy_n(words.begin(), std::min(words.size(), state.field.size() - 1), state.field.begin());
  ++state.field_number;
  state.refocus = true;
  state.chosen = 0;
}

void begin(const Session& session, ActionPaletteState& state) {
  state.shown = true;
  state.asking.clear();
  state.searched.clear();
  fill_field(state, state.begin_with);
  state.begin_with.clear();
  state.sources = std::make_shared<const ActionSources>(read_action_sources(session));
}

void close_palette(PanelFrame& frame) {
  frame.own<ActionPaletteState>().shown = false;
  frame.wish(ShowActionPalette{false});
  ImGui::CloseCurrentPopup();
}

void remember(ActionPaletteState& state, const std::string& words) {
  state.recent.erase(std::remove(state.recent.begin(), state.recent.end(), words), state.recent.end());
  state.recent.insert(state.recent.begin(), words);
  if (state.recent.size() > most_recent) state.recent.resize(most_recent);
}

// It closes before anything is done, so that what is opened comes up over the panels.
void do_it(PanelFrame& frame, const ActionEntry& entry, Action action) {
  remember(frame.own<ActionPaletteState>(), entry.words);
  close_palette(frame);
  if (!action.is<ShowActionPalette>()) frame.wish(std::move(action));
}

void choose(PanelFrame& frame, const ActionEntry& entry) {
  ActionPaletteState& state = frame.own<ActionPaletteState>();
  if (!entry.why_not.empty()) return;
  if (std::holds_alternative<ActionPrompt>(entry.does)) {
    state.asking = entry.words;
    return fill_field(state, "");
  }
  if (const auto* ask = std::get_if<AskToSave>(&entry.does)) {
    remember(state, entry.words);
    ask_to_save(frame, ask->what);
    return close_palette(frame);
  }
  if (const CommandInfo* command = command_of(entry)) {
    if (auto action = command->make(frame.session)) do_it(frame, entry, std::move(*action));
    return;
  }
  do_it(frame, entry, std::get<Action>(entry.does));
}

void draw_field(PaletteView& view, const std::string& hint) {
  ActionPaletteState& state = view.state;
  ImGui::PushID(state.field_number);
  // While something is held, the focus would go back to it.
  if (state.refocus && !ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive()) {
    ImGui::SetWindowFocus();
    ImGui::SetKeyboardFocusHere();
    state.refocus = false;
  }
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##action", hint.c_str(), state.field.data(), state.field.size());
  ImGui::PopID();
}

// Up and down by the keys, a page as much as is shown.
void move_choice(PaletteView& view) {
  ActionPaletteState& state = view.state;
  const auto pressed = [](Key key) { return key_pressed(key, true) ? 1 : 0; };
  const int by = pressed(Key::Down) - pressed(Key::Up) +
                 (lines_shown - 1) * (pressed(Key::PageDown) - pressed(Key::PageUp));
  if (by == 0 || view.found.empty()) return;
  const int last = static_cast<int>(view.found.size()) - 1;
  state.chosen = static_cast<std::size_t>(std::clamp(static_cast<int>(state.chosen) + by, 0, last));
  state.follow = true;
}

// Words at the left, key and group in columns at the right.
void draw_line(const PanelFrame& frame, const ActionEntry& entry, ImVec2 at, float width) {
  const bool idle = !entry.why_not.empty();
  const float right = at.x + width - frame.units(8.0f);
  const float left = at.x + frame.units(8.0f);
  push_font(frame.fonts.small);
  text_at(ImVec2(right, at.y + frame.units(2.0f)), 1.0f, theme().faint_text, entry.group);
  pop_font();
  const float keys_end = right - frame.units(92.0f);
  push_font(frame.fonts.mono);
  const float keys =
      entry.keys.empty() ? 0.0f : ImGui::CalcTextSize(entry.keys.c_str()).x + frame.units(12.0f);
  text_at(ImVec2(keys_end, at.y), 1.0f, theme().faint_text, entry.keys);
  pop_font();
  text_at(ImVec2(left, at.y), 0.0f, idle ? theme().faint_text : theme().text,
          cut_to_width(entry.words, keys_end - keys - left));
}

// Gives the entry that was clicked, or null.
const ActionEntry* draw_entry(PanelFrame& frame, PaletteView& view, std::size_t line) {
  const ActionEntry& entry = view.entries[view.found[line]];
  ImGui::PushID(static_cast<int>(line));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const bool clicked =
      ImGui::Selectable("##entry", line == view.state.chosen, 0, ImVec2(width, ImGui::GetTextLineHeight()));
  frame.mark("action/" + entry.words);
  tooltip(frame, entry.why_not);
  draw_line(frame, entry, at, width);
  ImGui::PopID();
  if (clicked) view.state.chosen = line;
  return clicked ? &entry : nullptr;
}

const ActionEntry* draw_list(PanelFrame& frame, PaletteView& view) {
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const ActionEntry* clicked = nullptr;
  ImGui::BeginChild("found", ImVec2(0.0f, static_cast<float>(lines_shown) * line), false);
  if (view.state.follow) {
    // So that the chosen line and one beside it can be seen.
    const float top = static_cast<float>(view.state.chosen) * line;
    const float low = top - static_cast<float>(lines_shown - 2) * line;
    const float now = ImGui::GetScrollY();
    if (now > top) ImGui::SetScrollY(top);
    if (now < low) ImGui::SetScrollY(low);
    view.state.follow = false;
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(view.found.size()), line);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      if (const ActionEntry* entry = draw_entry(frame, view, static_cast<std::size_t>(i))) clicked = entry;
    }
  }
  if (view.found.empty()) faint_text("Nothing that can be done is called that.");
  ImGui::EndChild();
  return clicked;
}

void draw_foot(PanelFrame& frame, const PaletteView& view) {
  const ActionEntry* chosen = view.chosen();
  const float width = ImGui::GetContentRegionAvail().x;
  const auto* action = chosen != nullptr ? std::get_if<Action>(&chosen->does) : nullptr;
  if (action != nullptr && action->is<GoTo>()) {  // what is there is read before one goes
    const bool there = chosen->why_not.empty();
    wrapped_text(there ? chosen->help : chosen->why_not, there ? theme().text : theme().warning);
  } else if (chosen != nullptr && !chosen->why_not.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().warning));
    text(cut_to_width(chosen->why_not, width));
    ImGui::PopStyleColor();
  } else {
    const bool helps = chosen != nullptr && !chosen->help.empty();
    const std::string words = helps ? chosen->help : "Enter does it, the arrow keys choose, Esc closes.";
    faint_text(cut_to_width(words, width));
    if (helps) tooltip(frame, words);
  }
  frame.mark("action-foot");
}

// What is typed may name a place: then going there stands before all else.
void add_destination(const PanelFrame& frame, PaletteView& view) {
  const std::string typed = view.typed();
  if (typed.empty() || !frame.session.document) return;
  const DestinationLookup::Found& found = view.state.lookup.find(frame.session, typed);
  const auto* there = std::get_if<Destination>(&found);
  const auto* none = std::get_if<NoDestination>(&found);
  if (none != nullptr && !none->understood) return;
  view.found.insert(view.found.begin(), view.entries.size());
  view.entries.push_back({"Go to: " + typed, "The run", there != nullptr ? there->words : "", GoTo{typed},
                          none != nullptr ? none->why : "", "", false});
}

// The field lets go of the keyboard then; it is to have it again if the palette stays.
bool entered(ActionPaletteState& state) {
  const bool pressed = key_pressed(Key::Enter) || key_pressed(Key::KeypadEnter);
  state.refocus = state.refocus || pressed;
  return pressed;
}

void draw_search(PanelFrame& frame, PaletteView& view) {
  ActionPaletteState& state = view.state;
  draw_field(view, "What shall be done?");
  frame.mark("action-field");
  if (view.typed() != state.searched) {
    state.searched = view.typed();
    state.chosen = 0;
    state.follow = true;
  }
  view.found = find_entries(view.entries, state.searched, state.recent);
  add_destination(frame, view);
  if (state.chosen >= view.found.size()) state.chosen = 0;
  move_choice(view);
  const ActionEntry* clicked = draw_list(frame, view);
  draw_foot(frame, view);
  if (clicked != nullptr) return choose(frame, *clicked);
  if (entered(state) && view.chosen() != nullptr) choose(frame, *view.chosen());
}

// What is typed is looked at as it is typed.
void draw_prompt(PanelFrame& frame, PaletteView& view, const ActionEntry& entry) {
  const auto& prompt = std::get<ActionPrompt>(entry.does);
  ImGui::AlignTextToFramePadding();
  text(prompt.label + ":");
  ImGui::SameLine();
  draw_field(view, prompt.example);
  frame.mark("action-field");
  const std::string typed = view.typed();
  const bool enter = entered(view.state);
  if (typed.empty()) {
    wrapped_text(entry.help.empty() ? "Such as " + prompt.example + "." : entry.help, theme().faint_text);
    faint_text("Enter does it, Esc goes back to the list.");
    return;
  }
  auto read = prompt.read(frame.session, typed);
  if (const auto* error = std::get_if<std::string>(&read)) {
    wrapped_text(with_capital(*error), theme().problem);
    frame.mark("action-trouble");
    return;
  }
  faint_text("Enter does it, Esc goes back to the list.");
  if (enter) do_it(frame, entry, std::get<Action>(std::move(read)));
}

void draw_palette_inside(PanelFrame& frame) {
  ActionPaletteState& state = frame.own<ActionPaletteState>();
  PaletteView view{state, palette_entries(frame.session, *state.sources), {}};
  const ActionEntry* asking = view.asking();
  const bool again = key_mods().ctrl && key_pressed(Key::P);
  const bool escaped = key_pressed(Key::Escape);
  if (again || (escaped && asking == nullptr)) return close_palette(frame);
  if (escaped) {
    state.asking.clear();
    return fill_field(state, state.searched);
  }
  // What could be asked for may be gone: the mesh, by another hand.
  if (asking != nullptr && !asking->why_not.empty()) asking = nullptr;
  asking != nullptr ? draw_prompt(frame, view, *asking) : draw_search(frame, view);
}

}  // namespace

void draw_action_palette(PanelFrame& frame) {
  ActionPaletteState& state = frame.own<ActionPaletteState>();
  const bool wanted = frame.session.view->dialogs.action_palette_open;
  if (!wanted && !state.shown) return;
  if (wanted && !state.shown) {
    begin(frame.session, state);
    ImGui::OpenPopup(popup);
  }
  if (!begin_top_popup(frame, popup, 640.0f)) {  // a click beside it
    state.shown = false;
    if (wanted) frame.wish(ShowActionPalette{false});
    return;
  }
  if (!wanted) {  // closed by another hand
    state.shown = false;
    ImGui::CloseCurrentPopup();
  } else {
    draw_palette_inside(frame);
  }
  ImGui::EndPopup();
}

}  // namespace app
