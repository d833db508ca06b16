// A slow frame must lose no click and no key, in the queue alone and through Dear ImGui.
#include "app/actions/input_queue.h"

#include <imgui.h>

#include <string>
#include <vector>

#include "app/panels/kit/imgui_glue.h"
#include "tests/support/catch.h"

namespace {

using namespace app;
using Events = std::vector<InputEvent>;

KeyPress press(Key key, Mods mods = {}) { return {key, true, mods}; }
KeyPress release(Key key, Mods mods = {}) { return {key, false, mods}; }
constexpr MouseClick left_down{MouseButton::Left, true};
constexpr MouseClick left_up{MouseButton::Left, false};

InputQueue queue_of(const Events& events) {
  InputQueue queue;
  for (const InputEvent& event : events) {
    queue.push(event);
  }
  return queue;
}

// A button in a corner and counters for keys, in slow frames.
class SlowWindow {
 public:
  InputQueue queue;
  int clicks = 0;
  int spaces = 0, rights = 0, f1s = 0, undos = 0, questions = 0;
  std::string text;
  bool with_field = false;

  void frame() {
    glue_.begin_frame({.width = 400, .height = 300, .seconds = 0.3f}, queue.take_frame());
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({400, 300});
    ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration);
    ImGui::SetCursorScreenPos({20, 20});
    clicks += ImGui::Button("press", {100, 40}) ? 1 : 0;
    if (with_field) {
      ImGui::SetKeyboardFocusHere();
      with_field = false;
      focused_ = true;
    }
    if (focused_) {
      char buffer[64] = {};
      text.copy(buffer, sizeof buffer - 1);
      ImGui::InputText("field", buffer, sizeof buffer);
      text = buffer;
    }
    spaces += key_pressed(Key::Space) ? 1 : 0;
    rights += key_pressed(Key::Right) ? 1 : 0;
    f1s += key_pressed(Key::F1) ? 1 : 0;
    undos += key_pressed(Key::Z) && key_mods().ctrl ? 1 : 0;
    questions += typed(U'?') ? 1 : 0;
    ImGui::End();
    glue_.end_frame();
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      frame();
    }
  }
  void until_quiet() {
    for (int i = 0; i < 100 && !queue.empty(); ++i) {
      frame();
    }
    frames(2);
    REQUIRE(queue.empty());
  }
  const ImGuiGlue& glue() const { return glue_; }

 private:
  ImGuiGlue glue_;
  bool focused_ = false;
};

}  // namespace

TEST_CASE("a frame holds at most one change of each button") {
  InputQueue queue = queue_of({MouseMove{5, 5}, left_down, left_up, left_down, left_up});
  CHECK(queue.take_frame() == Events{MouseMove{5, 5}, left_down});
  CHECK(queue.take_frame() == Events{left_up});
  CHECK(queue.take_frame() == Events{left_down});
  CHECK(queue.take_frame() == Events{left_up});
  CHECK(queue.empty());
  CHECK(queue.take_frame().empty());
}

TEST_CASE("a frame holds at most one change of each key, but many keys") {
  InputQueue queue = queue_of(
      {press(Key::Space), press(Key::Right), release(Key::Space), press(Key::Space), release(Key::Space)});
  CHECK(queue.take_frame() == Events{press(Key::Space), press(Key::Right)});
  CHECK(queue.take_frame() == Events{release(Key::Space)});
  CHECK(queue.take_frame() == Events{press(Key::Space)});
  CHECK(queue.take_frame() == Events{release(Key::Space)});
}

TEST_CASE("a click happens where the pointer was, and a drag is seen before its end") {
  InputQueue queue = queue_of({MouseMove{1, 1}, left_down, MouseMove{9, 9}, left_up});
  CHECK(queue.take_frame() == Events{MouseMove{1, 1}, left_down});
  CHECK(queue.take_frame() == Events{MouseMove{9, 9}});
  CHECK(queue.take_frame() == Events{left_up});
}

TEST_CASE("a flood of moves and wheel turns fits into one frame") {
  InputQueue queue;
  for (int i = 0; i < 1000; ++i) {
    queue.push(MouseMove{static_cast<float>(i), 2});
  }
  for (int i = 0; i < 8; ++i) {
    queue.push(Wheel{0, 0.5f});
  }
  CHECK(queue.take_frame() == Events{MouseMove{999, 2}, Wheel{0, 4}});
  CHECK(queue.empty());
  for (int i = 0; i < 100; ++i) {  // turning while moving must not lag either
    queue.push(MouseMove{static_cast<float>(i), 3});
    queue.push(Wheel{0, 1});
  }
  queue.take_frame();
  CHECK(queue.empty());
}

TEST_CASE("a modifier belongs to the keys that it was held for") {
  const Mods ctrl{.ctrl = true};
  InputQueue queue = queue_of({press(Key::LeftCtrl, ctrl), press(Key::Z, ctrl), release(Key::Z, ctrl),
                               release(Key::LeftCtrl), press(Key::X), press(Key::LeftCtrl, ctrl)});
  CHECK(queue.take_frame() == Events{press(Key::LeftCtrl, ctrl), press(Key::Z, ctrl)});
  CHECK(queue.take_frame() == Events{release(Key::Z, ctrl), release(Key::LeftCtrl), press(Key::X)});
  CHECK(queue.take_frame() == Events{press(Key::LeftCtrl, ctrl)});
}

TEST_CASE("text and editing keys keep their order") {
  InputQueue queue = queue_of({press(Key::A), Text{U'a'}, release(Key::A), press(Key::Backspace),
                               release(Key::Backspace), press(Key::B), Text{U'b'}});
  CHECK(queue.take_frame() == Events{press(Key::A), Text{U'a'}});
  CHECK(queue.take_frame() == Events{release(Key::A), press(Key::Backspace)});
  CHECK(queue.take_frame() == Events{release(Key::Backspace), press(Key::B), Text{U'b'}});
}

TEST_CASE("losing the focus cannot swallow a key") {
  InputQueue queue = queue_of({press(Key::Space), Focus{false}, release(Key::Space)});
  CHECK(queue.take_frame() == Events{press(Key::Space)});
  CHECK(queue.take_frame() == Events{Focus{false}, release(Key::Space)});
}

TEST_CASE("unknown keys and buttons are dropped") {
  InputQueue queue = queue_of({press(Key::None), MouseClick{MouseButton::Count, true}});
  CHECK(queue.empty());
}

TEST_CASE("two clicks and four keys within one 300 ms frame all count") {
  SlowWindow window;
  window.frames(2);
  for (const InputEvent& event :
       Events{MouseMove{50, 30}, left_down, left_up, left_down, left_up, press(Key::Space),
              release(Key::Space), press(Key::Space), release(Key::Space), press(Key::Right),
              release(Key::Right), press(Key::F1), release(Key::F1)}) {
    window.queue.push(event);
  }
  window.until_quiet();
  CHECK(window.clicks == 2);
  CHECK(window.spaces == 2);
  CHECK(window.rights == 1);
  CHECK(window.f1s == 1);
  CHECK_FALSE(window.glue().busy());
}

TEST_CASE("Ctrl+Z within one slow frame is Ctrl+Z, and a plain z is not") {
  const Mods ctrl{.ctrl = true};
  SlowWindow window;
  window.frames(2);
  for (const InputEvent& event :
       Events{press(Key::LeftCtrl, ctrl), press(Key::Z, ctrl), release(Key::Z, ctrl), release(Key::LeftCtrl),
              press(Key::Z), release(Key::Z)}) {
    window.queue.push(event);
  }
  window.until_quiet();
  CHECK(window.undos == 1);
}

TEST_CASE("text typed within one slow frame arrives whole and in order") {
  SlowWindow window;
  window.with_field = true;
  window.frames(3);
  for (const char letter : std::string("0.5")) {
    const Key key = letter == '.' ? Key::Period : letter == '0' ? Key::Digit0 : Key::Digit5;
    window.queue.push(press(key));
    window.queue.push(Text{static_cast<char32_t>(letter)});
    window.queue.push(release(key));
  }
  window.queue.push(press(Key::Backspace));
  window.queue.push(release(Key::Backspace));
  window.queue.push(Text{U'7'});
  window.until_quiet();
  CHECK(window.text == "0.7");
  CHECK(window.glue().wants_text());
}

TEST_CASE("a character is a shortcut whatever the layout") {
  SlowWindow window;
  window.frames(2);
  window.queue.push(Text{U'?'});
  window.until_quiet();
  CHECK(window.questions == 1);
}

TEST_CASE("a lost focus lets go of held keys") {
  SlowWindow window;
  window.frames(2);
  window.queue.push(press(Key::Right));
  window.until_quiet();
  CHECK(window.glue().busy());
  window.queue.push(Focus{false});
  window.until_quiet();
  CHECK_FALSE(window.glue().busy());
}

TEST_CASE("one ImGui context after another, each with its clipboard") {
  for (int i = 0; i < 2; ++i) {
    std::string board = "of context " + std::to_string(i);
    ImGuiGlue glue;
    glue.set_clipboard({.get = [&] { return board; }, .set = [&](const std::string& text) { board = text; }});
    const Fonts fonts = glue.load_fonts("no such folder", 2.0f);
    CHECK_FALSE(fonts.from_files);
    CHECK(fonts.mono != nullptr);
    glue.begin_frame({.width = 100, .height = 100}, {});
    push_font(fonts.heading);
    ImGui::GetForegroundDrawList()->AddText({1, 1}, 0xffffffffU, "words");
    pop_font();
    CHECK(std::string(ImGui::GetClipboardText()) == "of context " + std::to_string(i));
    ImGui::SetClipboardText("copied");
    CHECK(board == "copied");
    glue.end_frame();
    CHECK(glue.wanted_cursor() == Cursor::Arrow);
    CHECK(ImGui::GetDrawData()->TotalVtxCount > 0);
  }
}
