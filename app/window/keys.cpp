#include "app/window/keys.h"

#include <GLFW/glfw3.h>

namespace app {

namespace {

Key shifted(Key first, int by) { return static_cast<Key>(static_cast<int>(first) + by); }

Key named_key(int key) {
  // clang-format off
  switch (key) {
    case GLFW_KEY_LEFT: return Key::Left;
    case GLFW_KEY_RIGHT: return Key::Right;
    case GLFW_KEY_UP: return Key::Up;
    case GLFW_KEY_DOWN: return Key::Down;
    case GLFW_KEY_HOME: return Key::Home;
    case GLFW_KEY_END: return Key::End;
    case GLFW_KEY_PAGE_UP: return Key::PageUp;
    case GLFW_KEY_PAGE_DOWN: return Key::PageDown;
    case GLFW_KEY_INSERT: return Key::Insert;
    case GLFW_KEY_DELETE: return Key::Delete;
    case GLFW_KEY_BACKSPACE: return Key::Backspace;
    case GLFW_KEY_SPACE: return Key::Space;
    case GLFW_KEY_ENTER: return Key::Enter;
    case GLFW_KEY_KP_ENTER: return Key::KeypadEnter;
    case GLFW_KEY_ESCAPE: return Key::Escape;
    case GLFW_KEY_TAB: return Key::Tab;
    case GLFW_KEY_COMMA: return Key::Comma;
    case GLFW_KEY_PERIOD: return Key::Period;
    case GLFW_KEY_SLASH: return Key::Slash;
    case GLFW_KEY_MINUS: case GLFW_KEY_KP_SUBTRACT: return Key::Minus;
    case GLFW_KEY_EQUAL: case GLFW_KEY_KP_ADD: return Key::Equal;
    case GLFW_KEY_LEFT_BRACKET: return Key::LeftBracket;
    case GLFW_KEY_RIGHT_BRACKET: return Key::RightBracket;
    case GLFW_KEY_BACKSLASH: return Key::Backslash;
    case GLFW_KEY_SEMICOLON: return Key::Semicolon;
    case GLFW_KEY_APOSTROPHE: return Key::Apostrophe;
    case GLFW_KEY_GRAVE_ACCENT: return Key::GraveAccent;
    case GLFW_KEY_LEFT_SHIFT: return Key::LeftShift;
    case GLFW_KEY_RIGHT_SHIFT: return Key::RightShift;
    case GLFW_KEY_LEFT_CONTROL: return Key::LeftCtrl;
    case GLFW_KEY_RIGHT_CONTROL: return Key::RightCtrl;
    case GLFW_KEY_LEFT_ALT: return Key::LeftAlt;
    case GLFW_KEY_RIGHT_ALT: return Key::RightAlt;
    case GLFW_KEY_LEFT_SUPER: return Key::LeftSuper;
    case GLFW_KEY_RIGHT_SUPER: return Key::RightSuper;
    default: return Key::None;
  }
  // clang-format on
}

}  // namespace

Key key_from_glfw(int key, int scancode) {
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) {
    return shifted(Key::F1, key - GLFW_KEY_F1);
  }
  const bool printing = key >= GLFW_KEY_APOSTROPHE && key <= GLFW_KEY_WORLD_2;
  if (const char* name = printing ? glfwGetKeyName(key, scancode) : nullptr;
      name != nullptr && name[0] != '\0' && name[1] == '\0') {
    if (name[0] >= 'a' && name[0] <= 'z') {
      return shifted(Key::A, name[0] - 'a');
    }
    if (name[0] >= 'A' && name[0] <= 'Z') {
      return shifted(Key::A, name[0] - 'A');
    }
    // Where these keys lie differs much; for sizes it counts what is printed on them.
    if (name[0] == '+') return Key::Equal;
    if (name[0] == '-') return Key::Minus;
  }
  if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) {
    return shifted(Key::A, key - GLFW_KEY_A);
  }
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) {
    return shifted(Key::Digit0, key - GLFW_KEY_0);
  }
  return named_key(key);
}

MouseButton button_from_glfw(int button) {
  static_assert(GLFW_MOUSE_BUTTON_LEFT == 0 && GLFW_MOUSE_BUTTON_RIGHT == 1 && GLFW_MOUSE_BUTTON_MIDDLE == 2);
  const bool known = button >= 0 && button < static_cast<int>(MouseButton::Count);
  return known ? static_cast<MouseButton>(button) : MouseButton::Count;
}

Mods mods_from_glfw(int mods) {
  return {.shift = (mods & GLFW_MOD_SHIFT) != 0,
          .ctrl = (mods & GLFW_MOD_CONTROL) != 0,
          .alt = (mods & GLFW_MOD_ALT) != 0,
          .super = (mods & GLFW_MOD_SUPER) != 0};
}

Mods mods_after(Mods mods, Key key, bool down) {
  mods.shift = key == Key::LeftShift || key == Key::RightShift ? down : mods.shift;
  mods.ctrl = key == Key::LeftCtrl || key == Key::RightCtrl ? down : mods.ctrl;
  mods.alt = key == Key::LeftAlt || key == Key::RightAlt ? down : mods.alt;
  mods.super = key == Key::LeftSuper || key == Key::RightSuper ? down : mods.super;
  return mods;
}

}  // namespace app
