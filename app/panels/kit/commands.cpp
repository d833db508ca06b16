#include "app/panels/kit/commands.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>

#include "app/actions/navigate.h"
#include "app/checker/checker.h"
#include "app/lessons/lesson.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/pins.h"
#include "app/session/preferences.h"
#include "app/session/program.h"
#include "app/session/view.h"

namespace app {

namespace {

using Wish = std::optional<Action>;

constexpr Mods none{};
constexpr Mods shift{.shift = true};
constexpr Mods ctrl{.ctrl = true};
constexpr Mods alt{.alt = true};
constexpr Mods ctrl_shift{.shift = true, .ctrl = true};

constexpr std::array<Chord, 2> on(Key key, Mods mods = none) { return {{{key, mods, 0}, {}}}; }
constexpr std::array<Chord, 2> typing(char32_t a, char32_t b) {
  return {{{Key::None, none, a}, {Key::None, none, b}}};
}

template <Unit unit, int direction>
Wish step(const Session& /*session*/) {
  return StepBy{unit, direction};
}

template <int direction>
Wish play(const Session& session) {
  return SetPlaying{!session.view->playback.playing || session.view->playback.direction != direction,
                    direction};
}

template <Layer layer>
Wish toggle(const Session& session) {
  return SetLayer{layer, !session.view->shows(layer)};
}

template <int numerator, int denominator>
Wish speed(const Session& session) {
  const double wanted = session.view->playback.steps_per_second * numerator / denominator;
  return SetSpeed{std::clamp(wanted, slowest_steps_per_second, fastest_steps_per_second)};
}

template <Depth depth, int direction>
Wish deep(const Session& /*session*/) {
  return StepDeep{depth, direction};
}

template <knit::Verdict verdict>
Wish guess(const Session& /*session*/) {
  return Guess{verdict};
}

template <class Plain>
Wish plain(const Session& /*session*/) {
  return Plain{};
}

constexpr std::array scales{smallest_scale, 0.85, 1.0, 1.1, 1.25, projector_scale, 1.75, 2.0, largest_scale};

Wish larger(const Session& session) {
  const auto next = std::find_if(scales.begin(), scales.end(), [&](double scale) {
    return scale > session.program->preferences.scale + 1e-6;
  });
  return next != scales.end() ? Wish(SetScale{*next}) : std::nullopt;
}

Wish smaller(const Session& session) {
  const auto next = std::find_if(scales.rbegin(), scales.rend(), [&](double scale) {
    return scale < session.program->preferences.scale - 1e-6;
  });
  return next != scales.rend() ? Wish(SetScale{*next}) : std::nullopt;
}

Wish other_theme(const Session& session) {
  return SetTheme{session.program->preferences.theme == ThemeKind::dark ? ThemeKind::light : ThemeKind::dark};
}

// All panels away, or all there again.
Wish only_view(const Session& session) {
  const auto& panels = session.program->preferences.panels;
  return ShowPanel{every_panel, std::none_of(panels.begin(), panels.end(), [](bool shown) { return shown; })};
}

// Round the current row, or no more.
Wish loop(const Session& session) {
  if (!session.document || session.document->travel.loop) return SetLoop{};
  return SetLoop{stretch_of_row(session)};
}

Wish paste(const Session& /*session*/) {
  const char* text = ImGui::GetClipboardText();
  return text != nullptr && *text != '\0' ? Wish(PasteParameters{text}) : std::nullopt;
}

// Whatever is open on top; dialogs close themselves.
Wish close(const Session& session) {
  if (session.view->dialogs.action_palette_open) return ShowActionPalette{false};
  if (session.view->dialogs.go_to_open) return ShowGoTo{false};
  if (session.view->dialogs.glossary_open) return ShowGlossary{false, {}};
  if (session.view->dialogs.help_open) return ShowHelp{false};
  if (session.view->gaze.picking != Picking::nothing) return SetPicking{Picking::nothing};
  if (session.view->presenting) return Present{false};
  if (!session.outbox->notices.empty()) return DismissNotice{session.outbox->notices.size() - 1};
  if (session.view->checking) return ShowChecker{false};
  if (session.document && !session.document->place_note.empty()) return PutNoteAway{};
  return std::nullopt;
}

template <int direction>
Wish mistake(const Session& session) {
  return session.view->checking ? Wish(ToMistake{direction}) : std::nullopt;
}

// Where it came from, or was saved to; without such a file the panel asks.
Wish save_checked(const Session& session) {
  const auto& checker = session.view->checker;
  if (!session.view->checking || !checker || checker->path.empty()) return std::nullopt;
  return SaveCheckedText{checker->path};
}

// A presenter's remote: turns a lesson's pages, and steps where none is to be turned.
template <int direction>
Wish page(const Session& session) {
  const auto& lesson = session.learning->lesson;
  if (lesson && lesson->outcome() != PageOutcome::open) return TurnLesson{direction};
  return StepBy{Unit::item, direction};
}

constexpr std::string_view run = "The run";
constexpr std::string_view finding = "Finding why";
constexpr std::string_view changes = "Changes";
constexpr std::string_view learning = "Learning";
constexpr std::string_view view = "The view";
constexpr std::string_view program = "The program";

template <Layer layer>
constexpr CommandInfo layer_info(Key key) {
  return {Command::layer, view, "Show or hide", on(key), false, toggle<layer>, layer};
}

const std::array table{
    CommandInfo{Command::play, run, "Play or pause", on(Key::Space), false, play<1>},
    CommandInfo{Command::play_back, run, "Play backwards", on(Key::Space, shift), false, play<-1>},
    CommandInfo{Command::forward_item, run, "One item forward", on(Key::Right), true, step<Unit::item, 1>},
    CommandInfo{Command::back_item, run, "One item back", on(Key::Left), true, step<Unit::item, -1>},
    CommandInfo{Command::forward_row, run, "One row forward", on(Key::Right, shift), true,
                step<Unit::row, 1>},
    CommandInfo{Command::back_row, run, "One row back", on(Key::Left, shift), true, step<Unit::row, -1>},
    CommandInfo{Command::forward_stage, run, "One stage forward", on(Key::Right, ctrl), true,
                step<Unit::stage, 1>},
    CommandInfo{Command::back_stage, run, "One stage back", on(Key::Left, ctrl), true, step<Unit::stage, -1>},
    CommandInfo{Command::page_forward, run, "One item forward, or to a lesson's next page", on(Key::PageDown),
                true, page<1>},
    CommandInfo{Command::page_back, run, "One item back, or to a lesson's page before", on(Key::PageUp), true,
                page<-1>},
    CommandInfo{Command::first, run, "To the start", on(Key::Home), false,
                [](const Session&) -> Wish { return ToFirst{}; }},
    CommandInfo{Command::last, run, "To the end", on(Key::End), false,
                [](const Session&) -> Wish { return ToLast{}; }},
    CommandInfo{Command::go_to, run, "Go to a place by its name", on(Key::G, ctrl), false,
                [](const Session& session) -> Wish {
                  return session.document ? Wish(ShowGoTo{!session.view->dialogs.go_to_open}) : std::nullopt;
                }},
    CommandInfo{Command::faster, run, "Play faster", typing('.', '+'), true, speed<3, 2>},
    CommandInfo{Command::slower, run, "Play slower", typing(',', '-'), true, speed<2, 3>},
    CommandInfo{Command::slow_motion, run, "Slow down where it matters", on(Key::M), false,
                [](const Session& session) -> Wish { return SetSlowMotion{!session.view->slow_motion}; }},
    CommandInfo{Command::loop, run, "Play round and round in this row", on(Key::L), false, loop},
    CommandInfo{Command::step_over, finding, "Step over", on(Key::F10), true, deep<Depth::over, 1>},
    CommandInfo{Command::over_back, finding, "Step over, back", on(Key::F10, ctrl), true,
                deep<Depth::over, -1>},
    CommandInfo{Command::step_into, finding, "Step into", on(Key::F11), true, deep<Depth::into, 1>},
    CommandInfo{Command::into_back, finding, "Step into, back", on(Key::F11, ctrl), true,
                deep<Depth::into, -1>},
    CommandInfo{Command::step_out, finding, "Step out", on(Key::F11, shift), true, deep<Depth::out, 1>},
    CommandInfo{Command::out_back, finding, "Step out, back", on(Key::F11, ctrl_shift), true,
                deep<Depth::out, -1>},
    CommandInfo{Command::next_break, finding, "To the next break", on(Key::N), true,
                [](const Session&) -> Wish { return RunToBreak{1}; }},
    CommandInfo{Command::last_break, finding, "To the break before", on(Key::N, shift), true,
                [](const Session&) -> Wish { return RunToBreak{-1}; }},
    CommandInfo{Command::next_touch, finding, "The next step that touches what is selected", on(Key::J), true,
                [](const Session&) -> Wish { return ToTouch{1}; }},
    CommandInfo{Command::last_touch, finding, "The one before that touched it", on(Key::J, shift), true,
                [](const Session&) -> Wish { return ToTouch{-1}; }},
    CommandInfo{Command::go_back, finding, "Back to where you were", on(Key::Left, alt), true, plain<GoBack>},
    CommandInfo{Command::go_forward, finding, "Forward again", on(Key::Right, alt), true, plain<GoForward>},
    CommandInfo{Command::undo, changes, "Undo a change", on(Key::Z, ctrl), true, plain<Undo>},
    CommandInfo{
        Command::redo, changes, "Redo it", {{{Key::Y, ctrl, 0}, {Key::Z, ctrl_shift, 0}}}, true, plain<Redo>},
    CommandInfo{Command::copy, changes, "Copy all parameters", on(Key::C, ctrl), false,
                plain<CopyParameters>},
    CommandInfo{Command::paste, changes, "Paste parameters", on(Key::V, ctrl), false, paste},
    CommandInfo{Command::pin, changes, "Pin this run, or let it go", on(Key::P), false,
                [](const Session& session) -> Wish {
                  // One of another mesh gives way to this one.
                  const bool lets_go = session.document && session.document->pinned &&
                                       is_of_this_mesh(session, *session.document->pinned);
                  return lets_go ? Wish(Unpin{}) : Wish(PinRun{});
                }},
    CommandInfo{Command::swap, changes, "Swap with the pinned run", on(Key::X), false, plain<SwapPinned>},
    CommandInfo{Command::both, changes, "Show the pinned run beside this one", on(Key::B), false,
                [](const Session& session) -> Wish { return ShowBoth{!session.view->both}; }},
    CommandInfo{Command::frame_all, view, "Frame the mesh", on(Key::F), false,
                [](const Session&) -> Wish { return FrameAll{}; }},
    layer_info<Layer::surface>(Key::Digit1),
    layer_info<Layer::times>(Key::Digit2),
    layer_info<Layer::isolines>(Key::I),
    layer_info<Layer::criticals>(Key::C),
    layer_info<Layer::wire>(Key::Digit3),
    layer_info<Layer::cycle>(Key::Digit4),
    layer_info<Layer::band>(Key::Digit5),
    layer_info<Layer::stitches>(Key::Digit6),
    layer_info<Layer::row_edges>(Key::Digit7),
    layer_info<Layer::column_edges>(Key::Digit8),
    layer_info<Layer::faces>(Key::Digit9),
    layer_info<Layer::stretch>(Key::S),
    layer_info<Layer::moves>(Key::V),
    layer_info<Layer::yarn>(Key::Y),
    CommandInfo{Command::side, view, "The next side panel", on(Key::R), false,
                [](const Session& session) -> Wish {
                  return ShowSide{static_cast<SidePanel>((static_cast<std::size_t>(session.view->side) + 1) %
                                                         side_keys.size())};
                }},
    CommandInfo{Command::chart, view, "The view or the chart", on(Key::T), false,
                [](const Session& session) -> Wish {
                  const bool chart = session.view->centre == CentrePanel::chart;
                  return ShowCentre{chart ? CentrePanel::view : CentrePanel::chart};
                }},
    CommandInfo{Command::knit_along, view, "Knit along, round by round", on(Key::K), false,
                [](const Session& session) -> Wish {
                  if (session.view->gaze.knit_along) return KnitAlong{std::nullopt};
                  return KnitAlong{session.view->gaze.knit_along_round};
                }},
    CommandInfo{Command::larger,
                view,
                "Larger words and lines",
                {{{Key::Equal, ctrl, 0}, {Key::Equal, ctrl_shift, 0}}},
                true,
                larger},
    CommandInfo{Command::smaller, view, "Smaller words and lines", on(Key::Minus, ctrl), true, smaller},
    CommandInfo{Command::plain_size, view, "Normal size of words and lines", on(Key::Digit0, ctrl), false,
                [](const Session&) -> Wish { return SetScale{1.0}; }},
    CommandInfo{Command::theme, view, "Switch the theme", on(Key::F8), false, other_theme},
    CommandInfo{Command::present, view, "Present to a class", on(Key::F5), false,
                [](const Session& session) -> Wish { return Present{!session.view->presenting}; }},
    CommandInfo{Command::only_view, view, "All panels away, or back", on(Key::F9), false, only_view},
    CommandInfo{Command::predict, learning, "Guess each verdict before it falls", on(Key::G), false,
                [](const Session& session) -> Wish {
                  return SetPredicting{session.learning->prediction == nullptr};
                }},
    CommandInfo{Command::guess_near, learning, "Guess: too near", on(Key::Q), false,
                guess<knit::Verdict::too_near>},
    CommandInfo{Command::guess_accepted, learning, "Guess: accepted", on(Key::W), false,
                guess<knit::Verdict::accepted>},
    CommandInfo{Command::guess_far, learning, "Guess: too far", on(Key::E), false,
                guess<knit::Verdict::too_far>},
    CommandInfo{Command::open, program, "Open a mesh", on(Key::O, ctrl), false,
                [](const Session&) -> Wish { return ShowOpenDialog{true}; }},
    CommandInfo{Command::checker, program, "Check a written pattern", on(Key::F7), false,
                [](const Session& session) -> Wish { return ShowChecker{!session.view->checking}; }},
    CommandInfo{Command::next_mistake, program, "The pattern's next mistake", on(Key::F4), true, mistake<1>},
    CommandInfo{Command::last_mistake, program, "The mistake before", on(Key::F4, shift), true, mistake<-1>},
    CommandInfo{Command::save_checked, program, "Save the checked pattern", on(Key::S, ctrl), false,
                save_checked},
    CommandInfo{Command::close_mesh, program, "Close the mesh", on(Key::W, ctrl), false, plain<CloseMesh>},
    CommandInfo{Command::copy_link, program, "Copy a command line that opens exactly this",
                on(Key::C, ctrl_shift), false, plain<CopyLink>},
    CommandInfo{Command::action_palette, program, "All actions, by name", on(Key::P, ctrl), false,
                [](const Session& session) -> Wish {
                  return ShowActionPalette{!session.view->dialogs.action_palette_open};
                }},
    CommandInfo{Command::glossary, program, "The glossary", on(Key::F2), false,
                [](const Session& session) -> Wish {
                  return ShowGlossary{!session.view->dialogs.glossary_open, {}};
                }},
    CommandInfo{Command::help,
                program,
                "Show or hide the keys",
                {{{Key::F1, none, 0}, {Key::None, none, '?'}}},
                false,
                [](const Session& session) -> Wish { return ShowHelp{!session.view->dialogs.help_open}; }},
    CommandInfo{Command::close, program, "Close what is on top", on(Key::Escape), false, close},
    CommandInfo{Command::quit, program, "Quit", on(Key::Q, ctrl), false,
                [](const Session&) -> Wish { return Quit{}; }},
};

std::string name_of(Key key) {
  if (key >= Key::A && key <= Key::Z) {
    return {static_cast<char>('A' + static_cast<int>(key) - static_cast<int>(Key::A))};
  }
  if (key >= Key::Digit0 && key <= Key::Digit9) {
    return std::to_string(static_cast<int>(key) - static_cast<int>(Key::Digit0));
  }
  if (key >= Key::F1 && key <= Key::F12) {
    return "F" + std::to_string(1 + static_cast<int>(key) - static_cast<int>(Key::F1));
  }
  switch (key) {
    case Key::Space:
      return "Space";
    case Key::Left:
      return "Left";
    case Key::Right:
      return "Right";
    case Key::Home:
      return "Home";
    case Key::End:
      return "End";
    case Key::PageUp:
      return "Page Up";
    case Key::PageDown:
      return "Page Down";
    case Key::Escape:
      return "Esc";
    case Key::Equal:
      return "Plus";  // with Shift, or without, as the keyboard has it
    case Key::Minus:
      return "Minus";
    default:
      return "?";  // a test sees to it that no such key is in the table
  }
}

bool exists(const Chord& chord) { return chord.key != Key::None || chord.character != 0; }

bool is_pressed(const Chord& chord, bool repeats) {
  const Mods mods = key_mods();
  if (chord.character != 0) return !mods.ctrl && !mods.alt && typed(chord.character);
  return chord.key != Key::None && mods == chord.mods && key_pressed(chord.key, repeats);
}

}  // namespace

std::span<const CommandInfo> command_table() { return table; }

const CommandInfo& info_of(Command command) {
  return *std::find_if(table.begin(), table.end(),
                       [&](const CommandInfo& i) { return i.command == command; });
}

const CommandInfo& info_of(Layer layer) {
  return *std::find_if(table.begin(), table.end(), [&](const CommandInfo& i) { return i.layer == layer; });
}

std::string text_of(const Chord& chord) {
  if (chord.character != 0) return {static_cast<char>(chord.character)};
  std::string text;
  if (chord.mods.ctrl) text += "Ctrl+";
  if (chord.mods.shift) text += "Shift+";
  if (chord.mods.alt) text += "Alt+";
  return text + name_of(chord.key);
}

std::string keys_of(const CommandInfo& info) {
  const std::string first = text_of(info.chords[0]);
  // The same key with Shift need not be told.
  const bool another =
      exists(info.chords[1]) && (info.chords[1].key == Key::None || info.chords[1].key != info.chords[0].key);
  return another ? first + " or " + text_of(info.chords[1]) : first;
}

std::string words_of(const CommandInfo& info) {
  std::string words(info.words);
  if (!info.layer) return words;
  std::string layer(name_of(*info.layer));
  layer[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(layer[0])));
  return words + " " + layer;
}

std::string tooltip_of(const CommandInfo& info) { return words_of(info) + " (" + keys_of(info) + ")"; }

bool is_of_numbers(const Chord& chord) {
  if (chord.mods != none) return false;
  const bool digit = chord.key >= Key::Digit0 && chord.key <= Key::Digit9;
  return digit || chord.character == '.' || chord.character == ',' || chord.character == '-' ||
         chord.character == '+';
}

namespace {

bool keys_are_heard() {
  return !ImGui::GetIO().WantTextInput && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
}

// Without `numbers` a key of numbers is not for the view.
bool is_pressed(const CommandInfo& info, bool numbers) {
  return std::any_of(info.chords.begin(), info.chords.end(), [&](const Chord& chord) {
    return (numbers || !is_of_numbers(chord)) && is_pressed(chord, info.repeats);
  });
}

// Who knits along turns the rounds with these (draw_knit_along).
bool turns_rounds(const Session& session, Command command) {
  return session.view->gaze.knit_along && session.document &&
         (command == Command::forward_item || command == Command::back_item);
}

}  // namespace

bool is_pressed(Command command) { return keys_are_heard() && is_pressed(info_of(command), true); }

Actions commands_over_list(const Session& session) {
  Actions actions;
  if (ImGui::GetIO().WantTextInput || !key_mods().ctrl) return actions;
  for (const CommandInfo& info : table) {
    if (!is_pressed(info, false)) continue;
    if (auto action = info.make(session)) actions.push_back(std::move(*action));
  }
  return actions;
}

namespace {

// The others are about the mesh, which is not seen.
bool is_for_checker(Command command) {
  constexpr std::array heard{Command::checker,      Command::next_mistake,   Command::last_mistake,
                             Command::save_checked, Command::open,           Command::frame_all,
                             Command::larger,       Command::smaller,        Command::plain_size,
                             Command::theme,        Command::action_palette, Command::glossary,
                             Command::help,         Command::close,          Command::quit};
  return std::find(heard.begin(), heard.end(), command) != heard.end();
}

// Who types means letters, and moves with arrows.
bool is_heard_while_typing(const Chord& chord) {
  return chord.character == 0 && (chord.mods.ctrl || (chord.key >= Key::F1 && chord.key <= Key::F12));
}

bool is_pressed_in_checker(const CommandInfo& info) {
  const bool typing = ImGui::GetIO().WantTextInput;
  return std::any_of(info.chords.begin(), info.chords.end(), [&](const Chord& chord) {
    return (!typing || is_heard_while_typing(chord)) && is_pressed(chord, info.repeats);
  });
}

}  // namespace

bool is_pressed_in_checker(Command command) {
  return !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) && is_pressed_in_checker(info_of(command));
}

Actions commands_in_checker(const Session& session) {
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return {};
  Actions actions;
  for (const CommandInfo& info : table) {
    if (!is_for_checker(info.command) || !is_pressed_in_checker(info)) continue;
    if (auto action = info.make(session)) actions.push_back(std::move(*action));
  }
  return actions;
}

Actions pressed_commands(const Session& session, bool numbers) {
  if (!keys_are_heard()) return {};
  Actions actions;
  for (const CommandInfo& info : table) {
    if (!is_pressed(info, numbers) || turns_rounds(session, info.command)) continue;
    if (auto action = info.make(session)) actions.push_back(std::move(*action));
  }
  return actions;
}

}  // namespace app
