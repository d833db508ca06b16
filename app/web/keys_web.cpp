#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/web/page_calls.h"

namespace app {

namespace {

using Named = std::pair<std::string_view, Key>;

constexpr std::array named_keys{
    Named{"ArrowLeft", Key::Left},
    Named{"ArrowRight", Key::Right},
    Named{"ArrowUp", Key::Up},
    Named{"ArrowDown", Key::Down},
    Named{"Home", Key::Home},
    Named{"End", Key::End},
    Named{"PageUp", Key::PageUp},
    Named{"PageDown", Key::PageDown},
    Named{"Insert", Key::Insert},
    Named{"Delete", Key::Delete},
    Named{"Backspace", Key::Backspace},
    Named{"Space", Key::Space},
    Named{"Enter", Key::Enter},
    Named{"NumpadEnter", Key::KeypadEnter},
    Named{"Escape", Key::Escape},
    Named{"Tab", Key::Tab},
    Named{"Comma", Key::Comma},
    Named{"Period", Key::Period},
    Named{"Slash", Key::Slash},
    Named{"Minus", Key::Minus},
    Named{"NumpadSubtract", Key::Minus},
    Named{"Equal", Key::Equal},
    Named{"NumpadAdd", Key::Equal},
    Named{"BracketLeft", Key::LeftBracket},
    Named{"BracketRight", Key::RightBracket},
    Named{"Backslash", Key::Backslash},
    Named{"Semicolon", Key::Semicolon},
    Named{"Quote", Key::Apostrophe},
    Named{"Backquote", Key::GraveAccent},
    Named{"ShiftLeft", Key::LeftShift},
    Named{"ShiftRight", Key::RightShift},
    Named{"ControlLeft", Key::LeftCtrl},
    Named{"ControlRight", Key::RightCtrl},
    Named{"AltLeft", Key::LeftAlt},
    Named{"AltRight", Key::RightAlt},
    Named{"MetaLeft", Key::LeftSuper},
    Named{"MetaRight", Key::RightSuper},
};

Key shifted(Key first, int by) { return static_cast<Key>(static_cast<int>(first) + by); }

}  // namespace

Key key_of_page(const char* code, const char* key) {
  const std::string_view place = code;
  const std::string_view printed = key;
  // What is printed on the key counts, whatever the keyboard's layout.
  if (printed.size() == 1) {
    const char c = printed[0];
    if (c >= 'a' && c <= 'z') return shifted(Key::A, c - 'a');
    if (c >= 'A' && c <= 'Z') return shifted(Key::A, c - 'A');
    if (c == '+') return Key::Equal;
    if (c == '-') return Key::Minus;
  }
  if (place.starts_with("Key") && place.size() == 4) return shifted(Key::A, place[3] - 'A');
  if (place.starts_with("Digit") && place.size() == 6) return shifted(Key::Digit0, place[5] - '0');
  if (place.starts_with("F") && place.size() == 2) return shifted(Key::F1, place[1] - '1');
  if (place.starts_with("F1") && place.size() == 3) return shifted(Key::F10, place[2] - '0');
  const auto* found = std::find_if(named_keys.begin(), named_keys.end(),
                                   [&](const Named& named) { return named.first == place; });
  return found != named_keys.end() ? found->second : Key::None;
}

Mods mods_of_page(int packed) {
  return {.shift = (packed & 1) != 0,
          .ctrl = (packed & 2) != 0,
          .alt = (packed & 4) != 0,
          .super = (packed & 8) != 0};
}

}  // namespace app
