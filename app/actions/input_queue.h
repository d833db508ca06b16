// What hands and keyboard did, as plain data, and a queue that hands it out frame by frame. No ImGui, no
// GLFW.
//
// A slow frame may collect several clicks and keys. Who only looks at states ("is it down?") once a frame
// loses them, so take_frame() gives out what one frame can show and keeps the rest: nothing is lost, the
// order is kept.
#pragma once

#include <cstdint>
#include <deque>
#include <variant>
#include <vector>

namespace app {

enum class Key : std::uint8_t {
  // clang-format off
  None,
  A, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T, U, V, W, X, Y, Z,
  Digit0, Digit1, Digit2, Digit3, Digit4, Digit5, Digit6, Digit7, Digit8, Digit9,
  F1, F2, F3, F4, F5, F6, F7, F8, F9, F10, F11, F12,
  Left, Right, Up, Down, Home, End, PageUp, PageDown, Insert, Delete, Backspace, Space, Enter, KeypadEnter,
  Escape, Tab,
  Comma, Period, Slash, Minus, Equal, LeftBracket, RightBracket, Backslash, Semicolon, Apostrophe, GraveAccent,
  LeftShift, RightShift, LeftCtrl, RightCtrl, LeftAlt, RightAlt, LeftSuper, RightSuper,
  Count
  // clang-format on
};

bool is_modifier(Key key);
// Keys that also arrive as Text when a person writes.
bool is_printing(Key key);

struct Mods {
  bool shift = false, ctrl = false, alt = false, super = false;
  friend bool operator==(const Mods&, const Mods&) = default;
};

enum class MouseButton : std::uint8_t { Left, Right, Middle, Back, Forward, Count };

// How the pointer should look; a panel wishes it, a window shows it.
enum class Cursor : std::uint8_t {
  Arrow,
  Text,
  Move,
  UpDown,
  LeftRight,
  UpRight,
  DownRight,
  Hand,
  No,
  Hidden
};

struct MouseMove {
  float x = 0.0f, y = 0.0f;  // window units, from the top left
  friend bool operator==(const MouseMove&, const MouseMove&) = default;
};
struct MouseLeave {
  friend bool operator==(const MouseLeave&, const MouseLeave&) = default;
};
struct MouseClick {
  MouseButton button = MouseButton::Left;
  bool down = false;
  friend bool operator==(const MouseClick&, const MouseClick&) = default;
};
struct Wheel {
  float dx = 0.0f, dy = 0.0f;  // notches; up and right are positive
  friend bool operator==(const Wheel&, const Wheel&) = default;
};
struct KeyPress {
  Key key = Key::None;
  bool down = false;
  Mods mods;  // as they are after this event
  friend bool operator==(const KeyPress&, const KeyPress&) = default;
};
struct Text {
  char32_t codepoint = 0;
  friend bool operator==(const Text&, const Text&) = default;
};
struct Focus {
  bool gained = false;
  friend bool operator==(const Focus&, const Focus&) = default;
};

using InputEvent = std::variant<MouseMove, MouseLeave, MouseClick, Wheel, KeyPress, Text, Focus>;

class InputQueue {
 public:
  // A pointer move or turn of the wheel right after one of its kind joins it, so that a flood cannot pile up.
  void push(const InputEvent& event);

  // The next frame's events, oldest first. Within a frame
  // - each button and each key changes at most once;
  // - the pointer does not move after a button changed, and no button changes after the wheel turned;
  // - no button goes up after the pointer moved: what is dragged goes where it is dropped;
  // - a modifier does not change after any other key, button or wheel (else Ctrl would seem held, or not);
  // - text and editing keys stay in the order in which they were typed, and before a click that comes after them;
  // - the focus does not change after anything else did.
  // After what may open or leave a field (a click, Tab, Enter, Escape, a shortcut that opens something) keys and
  // text wait for a few frames, until it is known whose they are.
  // What would break a rule, and all that comes after it, waits.
  std::vector<InputEvent> take_frame();

  bool empty() const { return events_.empty(); }

 private:
  std::deque<InputEvent> events_;
  int settling_ = 0;  // frames that keys still wait
};

}  // namespace app
