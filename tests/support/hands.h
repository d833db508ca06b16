// Hands at a desk: keys and clicks that come while the program is busy, and are seen in the frames after.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "knit/model/settings_table.h"
#include "tests/support/desk.h"
#include "tests/support/samples.h"

namespace desk {

// What hands do goes through the queue; a frame comes only when `drain` is called.
class Hands {
 public:
  explicit Hands(Desk& desk) : desk_(desk) {}

  void click(const std::string& control) {
    push({desk_.over(control), MouseClick{MouseButton::Left, true}, MouseClick{MouseButton::Left, false}});
  }
  void type(const std::string& words) {
    for (const char c : words) {
      const Key key = key_of(c);
      push({KeyPress{key, true, {}}, Text{static_cast<char32_t>(c)}, KeyPress{key, false, {}}});
    }
  }
  void press(Key key, Mods mods = {}) {
    if (mods.shift) push({KeyPress{Key::LeftShift, true, mods}});
    push({KeyPress{key, true, mods}, KeyPress{key, false, mods}});
    if (mods.shift) push({KeyPress{Key::LeftShift, false, {}}});
  }
  void drag(const std::string& control, float by, int moves = 10, Mods mods = {}) {
    const MouseMove at = desk_.over(control);
    if (mods.shift) push({KeyPress{Key::LeftShift, true, mods}});
    push({at, MouseClick{MouseButton::Left, true}});
    drain();
    for (int i = 1; i <= moves; ++i) {
      push({MouseMove{at.x + by * static_cast<float>(i) / static_cast<float>(moves), at.y}});
      drain();
    }
    push({MouseClick{MouseButton::Left, false}});
    if (mods.shift) push({KeyPress{Key::LeftShift, false, {}}});
    drain();
  }
  void push(std::initializer_list<InputEvent> events) {
    for (const InputEvent& event : events) queue_.push(event);
  }
  // Frames until all of it has been seen, and what was wished is done.
  Actions drain() {
    Actions all;
    for (int after = 0; after < 2; after += queue_.empty() ? 1 : 0) {
      Actions wishes = desk_.frame(queue_.take_frame());
      desk_.act(wishes);
      for (Action& wish : wishes) all.push_back(std::move(wish));
    }
    return all;
  }

 private:
  static Key key_of(char c) {
    if (c >= '0' && c <= '9') return static_cast<Key>(static_cast<int>(Key::Digit0) + (c - '0'));
    return c == '-' ? Key::Minus : c == ',' ? Key::Comma : Key::Period;
  }
  Desk& desk_;
  InputQueue queue_;
};

// One number of the left panel: a whole parameter, or a part of one (a gauge, a direction).
struct NumberKnob {
  std::string control, key;
  int part = -1;      // from 0; -1: the whole
  std::string typed;  // another value that may be typed
};

// All that are drawn now, as they stand in the table.
inline std::vector<NumberKnob> number_knobs(const Desk& desk) {
  std::vector<NumberKnob> knobs;
  // Of an axis, and of a direction that is not along it.
  constexpr std::array axis{"0.75", "0.625", "0.375"}, direction{"0.25", "0.875", "0.5"};
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    const std::string key(info.key), control = "knob/" + key;
    const bool whole = std::holds_alternative<knit::Number>(info.kind) ||
                       std::holds_alternative<knit::Count>(info.kind) ||
                       std::holds_alternative<knit::PickedVertex>(info.kind);
    if (whole && desk.ui.controls.count(control) > 0)
      knobs.push_back({control, key, -1, test_support::sample_of(info)});
    const bool gauge = std::holds_alternative<knit::GaugeChoice>(info.kind);
    for (int part = 0; !whole && part < 3; ++part) {
      const std::string field = control + "/" + std::to_string(part);
      if (desk.ui.controls.count(field) == 0) continue;
      knobs.push_back({field, key, part,
                       gauge ? "24.5" : (key == "axis" ? axis : direction)[static_cast<std::size_t>(part)]});
    }
  }
  return knobs;
}

// As text, of the part where it is one.
inline std::string value_of(const Desk& desk, const NumberKnob& knob) {
  const std::string all =
      knit::value_text(*knit::find_parameter(knob.key), desk.session.document->timeline.parameters());
  if (knob.part < 0) return all;
  std::size_t from = 0;
  for (int i = 0; i < knob.part; ++i) from = all.find(',', from) + 1;
  return all.substr(from, all.find(',', from) - from);
}

}  // namespace desk
