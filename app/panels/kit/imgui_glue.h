// The one file where versions of Dear ImGui differ: 1.86 (Debian 12), 1.90, 1.92. Panels call what is here
// instead of the parts that changed: keys, text, fonts, clipboard.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/actions/input_queue.h"

struct ImFont;
struct ImGuiContext;

namespace app {

struct FrameSize {
  float width = 0.0f, height = 0.0f;               // window units: the pointer's and ImGui's
  float pixels_per_x = 1.0f, pixels_per_y = 1.0f;  // framebuffer pixels in one window unit
  float seconds = 1.0f / 60.0f;                    // since the last frame
};

struct Clipboard {
  std::function<std::string()> get;
  std::function<void(const std::string&)> set;
};

// Never null once fonts are loaded; several may be the same font where files are missing.
struct Fonts {
  ImFont* text = nullptr;
  ImFont* strong = nullptr;
  ImFont* heading = nullptr;  // strong and larger
  ImFont* mono = nullptr;
  ImFont* small = nullptr;  // for the axes of plots
  bool from_files = false;  // false: the built-in bitmap font, which has only Latin-1
};

// Owns a Dear ImGui context, current from construction on; of several, `make_current` says whose turn it is.
// Writes no settings file.
class ImGuiGlue {
 public:
  ImGuiGlue();
  ~ImGuiGlue();
  ImGuiGlue(const ImGuiGlue&) = delete;
  ImGuiGlue& operator=(const ImGuiGlue&) = delete;

  void make_current();

  // Replaces all fonts by those in `folder` at `text_size` x `scale` window units, or by the built-in one.
  // Between frames only. Pictures already made of the old fonts are void: see ImGuiDraw::forget_fonts.
  Fonts load_fonts(const std::string& folder, float scale, float text_size = 15.0f);
  void set_clipboard(Clipboard clipboard);

  // Tells ImGui what happened and opens its frame. `events` are from InputQueue::take_frame.
  void begin_frame(const FrameSize& size, const std::vector<InputEvent>& events);
  // Closes the frame: ImGui::GetDrawData() is complete.
  void end_frame();

  // After a frame.
  Cursor wanted_cursor() const;
  bool wants_text() const;
  // Something is held or blinks, so that a next frame is due even without an event.
  bool busy() const;

 private:
  void feed(const MouseMove& event);
  void feed(const MouseLeave& event);
  void feed(const MouseClick& event);
  void feed(const Wheel& event);
  void feed(const KeyPress& event);
  void feed(const Text& event);
  void feed(const Focus& event);
  void set_mods(const Mods& mods);

  struct Destroy {
    void operator()(ImGuiContext* context) const;
  };
  std::unique_ptr<ImGuiContext, Destroy> context_;
  Clipboard clipboard_;
  std::string pasted_;  // what ImGui reads after it asked for the clipboard
  friend struct ClipboardCalls;
};

// Whoever's turn it is now has it again when this goes: for work with a glue of its own in between.
class ContextKept {
 public:
  ContextKept();
  ~ContextKept();
  ContextKept(const ContextKept&) = delete;
  ContextKept& operator=(const ContextKept&) = delete;

 private:
  ImGuiContext* context_;
};

// For panels, inside a frame. They do not ask whether a widget wants the keyboard.
bool key_pressed(Key key, bool repeat = false);
bool key_down(Key key);
Mods key_mods();
// True if this character was typed in this frame, whatever the keyboard's layout ('?' for help).
bool typed(char32_t codepoint);

// PushFont as it was before 1.92: the font at the size it was loaded with. Null: the default.
void push_font(ImFont* font);
void pop_font();

}  // namespace app
