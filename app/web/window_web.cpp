// The window where it is a canvas in a page: WebGL 2, and events that page.js collects.
#include <emscripten.h>
#include <emscripten/html5.h>

#include <algorithm>
#include <utility>

#include "app/web/page_calls.h"
#include "app/window/window.h"

// clang-format off
EM_JS(void, page_open, (void* window), { Module.knit.open(window); });
EM_JS(void, page_close, (void* window), { Module.knit.close(window); });
EM_JS(double, page_width, (), { return Module.knit.width(); });
EM_JS(double, page_height, (), { return Module.knit.height(); });
EM_JS(double, page_density, (), { return window.devicePixelRatio || 1; });
EM_JS(void, page_fit, (int width, int height), { Module.knit.fit(width, height); });
EM_JS(void, page_title, (const char* title), { document.title = UTF8ToString(title); });
EM_JS(void, page_cursor, (const char* style), { Module.canvas.style.cursor = UTF8ToString(style); });
EM_JS(void, page_copy, (const char* text), { Module.knit.copy(UTF8ToString(text)); });
// clang-format on

namespace app {

struct Window::Inside {
  EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = 0;
  InputQueue input;
  std::vector<std::string> dropped;
  std::string pasted;
  bool refresh = true;
  bool lost = false;
  std::string title;
  Cursor cursor = Cursor::Arrow;

  Inside() = default;
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
  ~Inside() {
    page_close(this);
    if (context > 0) emscripten_webgl_destroy_context(context);
  }
};

namespace {

const char* style_of(Cursor cursor) {
  switch (cursor) {
    case Cursor::Arrow:
      return "default";
    case Cursor::Text:
      return "text";
    case Cursor::Move:
      return "move";
    case Cursor::UpDown:
      return "ns-resize";
    case Cursor::LeftRight:
      return "ew-resize";
    case Cursor::UpRight:
      return "nesw-resize";
    case Cursor::DownRight:
      return "nwse-resize";
    case Cursor::Hand:
      return "pointer";
    case Cursor::No:
      return "not-allowed";
    case Cursor::Hidden:
      return "none";
  }
  return "default";
}

int whole(double value) { return static_cast<int>(value + 0.5); }

}  // namespace

// Its script calls these; `window` is what page_open was given.
struct PageEvents {
  static Window::Inside& of(void* window) { return *static_cast<Window::Inside*>(window); }
  static void push(void* window, const InputEvent& event) { of(window).input.push(event); }
  static void drop(void* window, const char* path) { of(window).dropped.emplace_back(path); }
  static void paste(void* window, const char* text) { of(window).pasted = text; }
  static void refresh(void* window) { of(window).refresh = true; }
  static void lose(void* window) { of(window).lost = true; }
};

extern "C" {
EMSCRIPTEN_KEEPALIVE void knit_move(void* window, float x, float y) {
  PageEvents::push(window, MouseMove{x, y});
}
EMSCRIPTEN_KEEPALIVE void knit_leave(void* window) { PageEvents::push(window, MouseLeave{}); }
EMSCRIPTEN_KEEPALIVE void knit_button(void* window, int button, int down) {
  if (button >= 0 && button < static_cast<int>(MouseButton::Count))
    PageEvents::push(window, MouseClick{static_cast<MouseButton>(button), down != 0});
}
EMSCRIPTEN_KEEPALIVE void knit_wheel(void* window, float dx, float dy) {
  PageEvents::push(window, Wheel{dx, dy});
}
EMSCRIPTEN_KEEPALIVE void knit_key(void* window, const char* code, const char* key, int down, int mods) {
  PageEvents::push(window, KeyPress{key_of_page(code, key), down != 0, mods_of_page(mods)});
}
EMSCRIPTEN_KEEPALIVE void knit_text(void* window, int codepoint) {
  PageEvents::push(window, Text{static_cast<char32_t>(codepoint)});
}
EMSCRIPTEN_KEEPALIVE void knit_focus(void* window, int gained) {
  PageEvents::push(window, Focus{gained != 0});
}
EMSCRIPTEN_KEEPALIVE void knit_drop(void* window, const char* path) { PageEvents::drop(window, path); }
EMSCRIPTEN_KEEPALIVE void knit_paste(void* window, const char* text) { PageEvents::paste(window, text); }
EMSCRIPTEN_KEEPALIVE void knit_refresh(void* window) { PageEvents::refresh(window); }
EMSCRIPTEN_KEEPALIVE void knit_lost(void* window) { PageEvents::lose(window); }
}

int open_canvas() {
  EmscriptenWebGLContextAttributes wish;
  emscripten_webgl_init_context_attributes(&wish);
  wish.majorVersion = 2;
  wish.minorVersion = 0;
  wish.alpha = false;
  wish.depth = false;
  wish.stencil = false;
  wish.antialias = false;
  wish.preserveDrawingBuffer = true;
  const int context = emscripten_webgl_create_context("#canvas", &wish);
  if (context > 0) emscripten_webgl_make_context_current(context);
  return context;
}

std::variant<Window, std::string> Window::open(const std::string& title, int /*width*/, int /*height*/) {
  auto inside = std::make_unique<Inside>();
  page_open(inside.get());
  inside->context = open_canvas();
  if (inside->context <= 0) return std::string(no_webgl);
  Window window(std::move(inside));
  window.set_title(title);
  return window;
}

Window::Window(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;

// The page collects by itself and comes again for every frame.
void Window::poll() {
  const Size pixels = framebuffer_size();
  page_fit(pixels.width, pixels.height);
}
void Window::wait(double /*seconds*/) { poll(); }
void Window::swap() {}
bool Window::lost() const { return inside_->lost; }

InputQueue& Window::input() { return inside_->input; }
std::vector<std::string> Window::take_dropped() { return std::exchange(inside_->dropped, {}); }
bool Window::take_refresh() { return std::exchange(inside_->refresh, false); }
bool Window::close_requested() const { return false; }
bool Window::minimised() const { return false; }

Window::Size Window::size() const { return {whole(page_width()), whole(page_height())}; }

Window::Size Window::framebuffer_size() const {
  const double scale = pixel_scale();
  return {whole(page_width() * scale), whole(page_height() * scale)};
}

float Window::pixel_scale() const { return std::clamp(static_cast<float>(page_density()), 0.5f, 8.0f); }
float Window::unit_scale() const { return 1.0f; }

void Window::set_title(const std::string& title) {
  if (title == inside_->title) return;
  inside_->title = title;
  page_title(title.c_str());
}

void Window::set_cursor(Cursor cursor) {
  if (cursor == inside_->cursor) return;
  inside_->cursor = cursor;
  page_cursor(style_of(cursor));
}

// What was pasted last: a page may not look for itself.
std::string Window::clipboard() const { return inside_->pasted; }

void Window::set_clipboard(const std::string& text) {
  inside_->pasted = text;
  page_copy(text.c_str());
}

}  // namespace app
