#include "app/panels/kit/imgui_glue.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <filesystem>
#include <initializer_list>
#include <system_error>
#include <utility>

namespace app {

namespace {

// 1.87 brought the event queue and named keys.
#define KNIT_IMGUI_EVENTS (IMGUI_VERSION_NUM >= 18700)
#define KNIT_IMGUI_PLATFORM_IO (IMGUI_VERSION_NUM >= 19110)
#define KNIT_IMGUI_DYNAMIC_FONTS (IMGUI_VERSION_NUM >= 19200)

#if KNIT_IMGUI_EVENTS
ImGuiKey named_key(Key key) {
  // clang-format off
  switch (key) {
    case Key::Left: return ImGuiKey_LeftArrow;
    case Key::Right: return ImGuiKey_RightArrow;
    case Key::Up: return ImGuiKey_UpArrow;
    case Key::Down: return ImGuiKey_DownArrow;
    case Key::Home: return ImGuiKey_Home;
    case Key::End: return ImGuiKey_End;
    case Key::PageUp: return ImGuiKey_PageUp;
    case Key::PageDown: return ImGuiKey_PageDown;
    case Key::Insert: return ImGuiKey_Insert;
    case Key::Delete: return ImGuiKey_Delete;
    case Key::Backspace: return ImGuiKey_Backspace;
    case Key::Space: return ImGuiKey_Space;
    case Key::Enter: return ImGuiKey_Enter;
    case Key::KeypadEnter: return ImGuiKey_KeypadEnter;
    case Key::Escape: return ImGuiKey_Escape;
    case Key::Tab: return ImGuiKey_Tab;
    case Key::Comma: return ImGuiKey_Comma;
    case Key::Period: return ImGuiKey_Period;
    case Key::Slash: return ImGuiKey_Slash;
    case Key::Minus: return ImGuiKey_Minus;
    case Key::Equal: return ImGuiKey_Equal;
    case Key::LeftBracket: return ImGuiKey_LeftBracket;
    case Key::RightBracket: return ImGuiKey_RightBracket;
    case Key::Backslash: return ImGuiKey_Backslash;
    case Key::Semicolon: return ImGuiKey_Semicolon;
    case Key::Apostrophe: return ImGuiKey_Apostrophe;
    case Key::GraveAccent: return ImGuiKey_GraveAccent;
    case Key::LeftShift: return ImGuiKey_LeftShift;
    case Key::RightShift: return ImGuiKey_RightShift;
    case Key::LeftCtrl: return ImGuiKey_LeftCtrl;
    case Key::RightCtrl: return ImGuiKey_RightCtrl;
    case Key::LeftAlt: return ImGuiKey_LeftAlt;
    case Key::RightAlt: return ImGuiKey_RightAlt;
    case Key::LeftSuper: return ImGuiKey_LeftSuper;
    case Key::RightSuper: return ImGuiKey_RightSuper;
    default: return ImGuiKey_None;
  }
  // clang-format on
}

int offset_from(Key key, Key first) { return static_cast<int>(key) - static_cast<int>(first); }

ImGuiKey to_imgui(Key key) {
  if (key >= Key::A && key <= Key::Z) {
    return static_cast<ImGuiKey>(ImGuiKey_A + offset_from(key, Key::A));
  }
  if (key >= Key::Digit0 && key <= Key::Digit9) {
    return static_cast<ImGuiKey>(ImGuiKey_0 + offset_from(key, Key::Digit0));
  }
  if (key >= Key::F1 && key <= Key::F12) {
    return static_cast<ImGuiKey>(ImGuiKey_F1 + offset_from(key, Key::F1));
  }
  return named_key(key);
}
#else
// Here ImGui's key numbers are our own.
int to_imgui(Key key) { return static_cast<int>(key); }

void map_keys(ImGuiIO& io) {
  constexpr std::array<std::pair<ImGuiKey_, Key>, ImGuiKey_COUNT> map = {{
      {ImGuiKey_Tab, Key::Tab},
      {ImGuiKey_LeftArrow, Key::Left},
      {ImGuiKey_RightArrow, Key::Right},
      {ImGuiKey_UpArrow, Key::Up},
      {ImGuiKey_DownArrow, Key::Down},
      {ImGuiKey_PageUp, Key::PageUp},
      {ImGuiKey_PageDown, Key::PageDown},
      {ImGuiKey_Home, Key::Home},
      {ImGuiKey_End, Key::End},
      {ImGuiKey_Insert, Key::Insert},
      {ImGuiKey_Delete, Key::Delete},
      {ImGuiKey_Backspace, Key::Backspace},
      {ImGuiKey_Space, Key::Space},
      {ImGuiKey_Enter, Key::Enter},
      {ImGuiKey_Escape, Key::Escape},
      {ImGuiKey_KeyPadEnter, Key::KeypadEnter},
      {ImGuiKey_A, Key::A},
      {ImGuiKey_C, Key::C},
      {ImGuiKey_V, Key::V},
      {ImGuiKey_X, Key::X},
      {ImGuiKey_Y, Key::Y},
      {ImGuiKey_Z, Key::Z},
  }};
  for (const auto& [theirs, ours] : map) {
    io.KeyMap[theirs] = to_imgui(ours);
  }
}
#endif

// Greek letters, dashes, arrows and mathematical signs that the panels write, besides Latin-1. tools/web.sh cuts the fonts of
// a page down to these.
const ImWchar* glyph_ranges() {
  static constexpr std::array<ImWchar, 15> ranges = {0x0020, 0x00ff, 0x0370, 0x03ff, 0x2010,
                                                     0x2027, 0x2030, 0x203a, 0x2190, 0x21ff,
                                                     0x2200, 0x22ff, 0x25a0, 0x25ff, 0};
  return ranges.data();
}

ImFont* add_font(const std::filesystem::path& folder, std::initializer_list<const char*> names, float size) {
  for (const char* name : names) {
    const std::filesystem::path file = folder / name;
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error)) {
      ImFontConfig config;
      config.OversampleH = 2;
      config.OversampleV = 1;
      return ImGui::GetIO().Fonts->AddFontFromFileTTF(file.string().c_str(), size, &config, glyph_ranges());
    }
  }
  return nullptr;
}

ImFont* add_builtin_font(float size) {
  ImFontConfig config;
  config.SizePixels = std::max(13.0f, size);
  return ImGui::GetIO().Fonts->AddFontDefault(&config);
}

}  // namespace

// ImGui calls plain functions with a pointer; both kinds end here.
struct ClipboardCalls {
  static const char* get(ImGuiGlue& glue) {
    glue.pasted_ = glue.clipboard_.get ? glue.clipboard_.get() : std::string();
    return glue.pasted_.c_str();
  }
  static void set(ImGuiGlue& glue, const char* text) {
    if (glue.clipboard_.set) {
      glue.clipboard_.set(text != nullptr ? text : "");
    }
  }
};

void ImGuiGlue::Destroy::operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }

ImGuiGlue::ImGuiGlue() : context_(ImGui::CreateContext()) {
  ImGui::SetCurrentContext(context_.get());
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  io.BackendPlatformName = "knit-mesh";
#if KNIT_IMGUI_EVENTS
  // InputQueue has done it already, and knows when something still waits.
  io.ConfigInputTrickleEventQueue = false;
#else
  map_keys(io);
#endif
}

ImGuiGlue::~ImGuiGlue() = default;

void ImGuiGlue::make_current() { ImGui::SetCurrentContext(context_.get()); }

ContextKept::ContextKept() : context_(ImGui::GetCurrentContext()) {}
ContextKept::~ContextKept() { ImGui::SetCurrentContext(context_); }

Fonts ImGuiGlue::load_fonts(const std::string& folder, float scale, float text_size) {
  ImGui::GetIO().Fonts->Clear();
  const float size = text_size * std::max(0.25f, scale);
  Fonts fonts;
  fonts.text = add_font(folder, {"Inter-Regular.otf", "Inter-Regular.ttf", "InterVariable.ttf"}, size);
  fonts.from_files = fonts.text != nullptr;
  if (fonts.text == nullptr) {
    fonts.text = add_builtin_font(size);
  }
  const auto semibold = {"Inter-SemiBold.otf", "Inter-SemiBold.ttf", "Inter-Bold.otf"};
  fonts.strong = add_font(folder, semibold, size);
  fonts.heading = add_font(folder, semibold, size * 1.3f);
  fonts.mono = add_font(folder, {"JetBrainsMono-Regular.ttf"}, size * 0.93f);
  fonts.small =
      add_font(folder, {"Inter-Regular.otf", "Inter-Regular.ttf", "InterVariable.ttf"}, size * 0.84f);
  for (ImFont** font : {&fonts.strong, &fonts.heading, &fonts.mono, &fonts.small}) {
    *font = *font != nullptr ? *font : fonts.text;
  }
  return fonts;
}

void ImGuiGlue::set_clipboard(Clipboard clipboard) {
  clipboard_ = std::move(clipboard);
#if KNIT_IMGUI_PLATFORM_IO
  ImGuiPlatformIO& io = ImGui::GetPlatformIO();
  io.Platform_ClipboardUserData = this;
  io.Platform_GetClipboardTextFn = [](ImGuiContext*) {
    return ClipboardCalls::get(*static_cast<ImGuiGlue*>(ImGui::GetPlatformIO().Platform_ClipboardUserData));
  };
  io.Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) {
    ClipboardCalls::set(*static_cast<ImGuiGlue*>(ImGui::GetPlatformIO().Platform_ClipboardUserData), text);
  };
#else
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = this;
  io.GetClipboardTextFn = [](void* glue) { return ClipboardCalls::get(*static_cast<ImGuiGlue*>(glue)); };
  io.SetClipboardTextFn = [](void* glue, const char* text) {
    ClipboardCalls::set(*static_cast<ImGuiGlue*>(glue), text);
  };
#endif
}

void ImGuiGlue::begin_frame(const FrameSize& size, const std::vector<InputEvent>& events) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(size.width, size.height);
  io.DisplayFramebufferScale = ImVec2(size.pixels_per_x, size.pixels_per_y);
  io.DeltaTime = std::max(size.seconds, 1e-4f);
  for (const InputEvent& event : events) {
    std::visit([this](const auto& it) { feed(it); }, event);
  }
  if (io.BackendRendererUserData == nullptr) {  // nobody draws (tests), yet text must have a size
#if KNIT_IMGUI_DYNAMIC_FONTS
    io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
#else
    if (!io.Fonts->IsBuilt()) {
      io.Fonts->Build();
    }
#endif
  }
  ImGui::NewFrame();
}

void ImGuiGlue::end_frame() { ImGui::Render(); }

Cursor ImGuiGlue::wanted_cursor() const {
  // clang-format off
  switch (ImGui::GetMouseCursor()) {
    case ImGuiMouseCursor_None: return Cursor::Hidden;
    case ImGuiMouseCursor_TextInput: return Cursor::Text;
    case ImGuiMouseCursor_ResizeAll: return Cursor::Move;
    case ImGuiMouseCursor_ResizeNS: return Cursor::UpDown;
    case ImGuiMouseCursor_ResizeEW: return Cursor::LeftRight;
    case ImGuiMouseCursor_ResizeNESW: return Cursor::UpRight;
    case ImGuiMouseCursor_ResizeNWSE: return Cursor::DownRight;
    case ImGuiMouseCursor_Hand: return Cursor::Hand;
    case ImGuiMouseCursor_NotAllowed: return Cursor::No;
    default: return Cursor::Arrow;
  }
  // clang-format on
}

bool ImGuiGlue::wants_text() const { return ImGui::GetIO().WantTextInput; }

bool ImGuiGlue::busy() const {
  if (wants_text() || ImGui::IsAnyMouseDown()) {
    return true;
  }
  for (int key = 1; key < static_cast<int>(Key::Count); ++key) {
    if (key_down(static_cast<Key>(key))) {
      return true;
    }
  }
  return false;
}

#if KNIT_IMGUI_EVENTS

void ImGuiGlue::feed(const MouseMove& event) { ImGui::GetIO().AddMousePosEvent(event.x, event.y); }
void ImGuiGlue::feed(const MouseLeave& /*event*/) { ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX); }
void ImGuiGlue::feed(const MouseClick& event) {
  ImGui::GetIO().AddMouseButtonEvent(static_cast<int>(event.button), event.down);
}
void ImGuiGlue::feed(const Wheel& event) { ImGui::GetIO().AddMouseWheelEvent(event.dx, event.dy); }
void ImGuiGlue::feed(const KeyPress& event) {
  set_mods(event.mods);
  ImGui::GetIO().AddKeyEvent(to_imgui(event.key), event.down);
}
void ImGuiGlue::feed(const Text& event) {
  ImGui::GetIO().AddInputCharacter(static_cast<unsigned int>(event.codepoint));
}
void ImGuiGlue::feed(const Focus& event) { ImGui::GetIO().AddFocusEvent(event.gained); }

void ImGuiGlue::set_mods(const Mods& mods) {
  ImGuiIO& io = ImGui::GetIO();
  io.AddKeyEvent(ImGuiMod_Ctrl, mods.ctrl);
  io.AddKeyEvent(ImGuiMod_Shift, mods.shift);
  io.AddKeyEvent(ImGuiMod_Alt, mods.alt);
  io.AddKeyEvent(ImGuiMod_Super, mods.super);
}

#else

void ImGuiGlue::feed(const MouseMove& event) { ImGui::GetIO().MousePos = ImVec2(event.x, event.y); }
void ImGuiGlue::feed(const MouseLeave& /*event*/) { ImGui::GetIO().MousePos = ImVec2(-FLT_MAX, -FLT_MAX); }
void ImGuiGlue::feed(const MouseClick& event) {
  ImGui::GetIO().MouseDown[static_cast<int>(event.button)] = event.down;
}
void ImGuiGlue::feed(const Wheel& event) {
  ImGui::GetIO().MouseWheelH += event.dx;
  ImGui::GetIO().MouseWheel += event.dy;
}
void ImGuiGlue::feed(const KeyPress& event) {
  set_mods(event.mods);
  ImGui::GetIO().KeysDown[to_imgui(event.key)] = event.down;
}
void ImGuiGlue::feed(const Text& event) {
  ImGui::GetIO().AddInputCharacter(static_cast<unsigned int>(event.codepoint));
}
void ImGuiGlue::feed(const Focus& event) {
  if (!event.gained) {  // their releases go to another window
    for (bool& down : ImGui::GetIO().KeysDown) down = false;
    set_mods({});
  }
}

void ImGuiGlue::set_mods(const Mods& mods) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyCtrl = mods.ctrl;
  io.KeyShift = mods.shift;
  io.KeyAlt = mods.alt;
  io.KeySuper = mods.super;
}

#endif

bool key_pressed(Key key, bool repeat) { return ImGui::IsKeyPressed(to_imgui(key), repeat); }
bool key_down(Key key) { return ImGui::IsKeyDown(to_imgui(key)); }

Mods key_mods() {
  const ImGuiIO& io = ImGui::GetIO();
  return {.shift = io.KeyShift, .ctrl = io.KeyCtrl, .alt = io.KeyAlt, .super = io.KeySuper};
}

bool typed(char32_t codepoint) {
  for (const ImWchar waiting : ImGui::GetIO().InputQueueCharacters) {
    if (static_cast<char32_t>(waiting) == codepoint) {
      return true;
    }
  }
  return false;
}

void push_font(ImFont* font) {
#if KNIT_IMGUI_DYNAMIC_FONTS
  ImFont* chosen = font != nullptr ? font : ImGui::GetIO().Fonts->Fonts[0];
  ImGui::PushFont(chosen, chosen->LegacySize);
#else
  ImGui::PushFont(font);
#endif
}

void pop_font() { ImGui::PopFont(); }

}  // namespace app
