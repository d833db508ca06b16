// The one table of keys: what the keyboard does, what the help lists, what menus and tooltips name.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/panels/kit/imgui_glue.h"
#include "app/session/action.h"
#include "app/session/view.h"

namespace app {

enum class Command : std::uint8_t {
  // clang-format off
  play, play_back, forward_item, back_item, forward_row, back_row, forward_stage, back_stage, first, last,
  faster, slower, slow_motion, loop, step_over, step_into, step_out, over_back, into_back, out_back,
  next_break, last_break, next_touch, last_touch, go_back, go_forward, undo, redo, copy, paste, pin, swap,
  frame_all, layer, side, chart, knit_along, predict, guess_near, guess_accepted, guess_far,
  larger, smaller, plain_size, theme, only_view, open, close_mesh, copy_link, action_palette, glossary, help, close, quit,
  both, present, page_forward, page_back, go_to, checker, next_mistake, last_mistake, save_checked
  // clang-format on
};

// A key with its modifiers, or a character as the keyboard's layout makes it.
struct Chord {
  Key key = Key::None;
  Mods mods;
  char32_t character = 0;
};

struct CommandInfo {
  Command command;
  std::string_view group;
  std::string_view words;  // "Play or pause"
  std::array<Chord, 2> chords;
  bool repeats;                                   // while the key is held
  std::optional<Action> (*make)(const Session&);  // nothing: there is nothing to do
  std::optional<Layer> layer = std::nullopt;
};

std::span<const CommandInfo> command_table();
const CommandInfo& info_of(Command command);
const CommandInfo& info_of(Layer layer);

std::string text_of(const Chord& chord);          // "Ctrl+Left"
std::string keys_of(const CommandInfo& info);     // "Esc", ", or -"
std::string words_of(const CommandInfo& info);    // of a layer: with its name
std::string tooltip_of(const CommandInfo& info);  // "Play or pause (Space)"

// Digits, points and signs, which a person who means a number types.
bool is_of_numbers(const Chord& chord);

// What the keys of this frame ask for; nothing while a person types or a menu or dialog is open. Without `numbers`
// those of numbers are not for the view: the pointer is over fields.
Actions pressed_commands(const Session& session, bool numbers = true);
// Those with Ctrl, while a list hangs open from a field: it is closed by them.
Actions commands_over_list(const Session& session);
// Whether its keys were pressed in this frame, under the same conditions.
bool is_pressed(Command command);
// While a written pattern is checked: those that are not about the mesh, and of them those that no text field knows even
// while a person types.
Actions commands_in_checker(const Session& session);
bool is_pressed_in_checker(Command command);

}  // namespace app
