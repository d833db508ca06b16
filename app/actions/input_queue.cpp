#include "app/actions/input_queue.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>

namespace app {

namespace {

// Dear ImGui gives a field the keyboard up to two frames after it was asked to, a window that opens is laid out in
// one more, and says that it wants text in the next.
constexpr int frames_to_settle = 4;

// What may open a field or leave one. The keys that step and play are not among them: they may follow each other
// at once.
bool may_move_keyboard(const KeyPress& event) {
  if (!event.down || is_modifier(event.key)) return false;
  if (event.mods.ctrl || event.mods.alt) {
    constexpr std::array editing{Key::A, Key::C, Key::V, Key::X, Key::Y, Key::Z};
    return is_printing(event.key) && std::find(editing.begin(), editing.end(), event.key) == editing.end();
  }
  return event.key == Key::Tab || event.key == Key::Enter || event.key == Key::KeypadEnter ||
         event.key == Key::Escape || (event.key >= Key::F1 && event.key <= Key::F9);
}

// What one frame holds so far, and whether one more event still fits.
class FrameRules {
 public:
  explicit FrameRules(bool keys_wait) : keys_wait_(keys_wait) {}

  bool admits(const MouseMove& /*event*/) const { return buttons_.none(); }
  bool admits(const MouseLeave& /*event*/) const { return buttons_.none() && !wheel_; }
  bool admits(const MouseClick& event) const {
    return !buttons_[static_cast<std::size_t>(event.button)] && !wheel_ && (event.down || !moved_) &&
           !text_ && !plain_key_;
  }
  bool admits(const Wheel& /*event*/) const { return buttons_.none(); }
  bool admits(const KeyPress& event) const {
    if (keys_[static_cast<std::size_t>(event.key)] || moved_keyboard_) {
      return false;
    }
    if (keys_wait_ && event.down && !is_modifier(event.key)) {
      return false;
    }
    if (is_modifier(event.key)) {
      return !plain_key_ && buttons_.none() && !wheel_ && !text_;
    }
    // Letters may follow text; Enter or Backspace would act before it.
    return buttons_.none() && (!text_ || is_printing(event.key) || !event.down);
  }
  bool admits(const Text& /*event*/) const {
    return !keys_wait_ && !moved_keyboard_ && !editing_key_ && buttons_.none();
  }
  bool admits(const Focus& /*event*/) const { return keys_.none() && buttons_.none() && !wheel_ && !text_; }

  void note(const MouseMove& /*event*/) { moved_ = true; }
  void note(const MouseLeave& /*event*/) {}
  void note(const MouseClick& event) {
    buttons_.set(static_cast<std::size_t>(event.button));
    moved_keyboard_ = true;
  }
  void note(const Wheel& /*event*/) { wheel_ = true; }
  void note(const KeyPress& event) {
    keys_.set(static_cast<std::size_t>(event.key));
    moved_keyboard_ = moved_keyboard_ || may_move_keyboard(event);
    if (event.down && !is_modifier(event.key)) {
      plain_key_ = true;
      editing_key_ = editing_key_ || !is_printing(event.key);
    }
  }
  void note(const Text& /*event*/) { text_ = true; }
  void note(const Focus& /*event*/) {}
  bool moved_keyboard() const { return moved_keyboard_; }

 private:
  bool keys_wait_;
  bool moved_keyboard_ = false;  // perhaps: it is not known yet whose the next keys are
  std::bitset<static_cast<std::size_t>(MouseButton::Count)> buttons_;
  std::bitset<static_cast<std::size_t>(Key::Count)> keys_;
  bool moved_ = false;
  bool wheel_ = false;
  bool text_ = false;
  bool plain_key_ = false;    // pressed: any key but a modifier
  bool editing_key_ = false;  // pressed: one that edits or moves instead of writing
};

// True when `event` became part of `last`.
bool joined(InputEvent& last, const InputEvent& event) {
  if (std::holds_alternative<MouseMove>(last) && std::holds_alternative<MouseMove>(event)) {
    last = event;
    return true;
  }
  auto* wheel = std::get_if<Wheel>(&last);
  const auto* more = std::get_if<Wheel>(&event);
  if (wheel != nullptr && more != nullptr) {
    wheel->dx += more->dx;
    wheel->dy += more->dy;
    return true;
  }
  return false;
}

bool nonsense(const InputEvent& event) {
  if (const auto* key = std::get_if<KeyPress>(&event)) {
    return key->key == Key::None || key->key >= Key::Count;
  }
  if (const auto* click = std::get_if<MouseClick>(&event)) {
    return click->button >= MouseButton::Count;
  }
  return false;
}

}  // namespace

bool is_modifier(Key key) { return key >= Key::LeftShift && key <= Key::RightSuper; }

bool is_printing(Key key) {
  return (key >= Key::A && key <= Key::Digit9) || (key >= Key::Comma && key <= Key::GraveAccent) ||
         key == Key::Space;
}

void InputQueue::push(const InputEvent& event) {
  if (nonsense(event) || (!events_.empty() && joined(events_.back(), event))) {
    return;
  }
  events_.push_back(event);
}

std::vector<InputEvent> InputQueue::take_frame() {
  std::vector<InputEvent> frame;
  settling_ = settling_ > 0 ? settling_ - 1 : 0;
  FrameRules rules(settling_ > 0);
  while (!events_.empty()) {
    const InputEvent& next = events_.front();
    if (!std::visit([&](const auto& event) { return rules.admits(event); }, next)) {
      break;
    }
    std::visit([&](const auto& event) { rules.note(event); }, next);
    if (frame.empty() || !joined(frame.back(), next)) {
      frame.push_back(next);
    }
    events_.pop_front();
  }
  if (rules.moved_keyboard()) settling_ = frames_to_settle;
  return frame;
}

}  // namespace app
