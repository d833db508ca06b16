#include "app/window/window.h"

#include <glad/gl.h>
// After glad: both declare OpenGL.
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/window/keys.h"

namespace app {

struct Window::Inside {
  using ResetStatus = GLenum (*)();
  GLFWwindow* window = nullptr;
  ResetStatus reset_status = nullptr;  // null: this driver does not say
  InputQueue input;
  std::vector<std::string> dropped;
  bool refresh = true;
  std::string title;  // as set last
  Cursor cursor = Cursor::Arrow;
  std::array<GLFWcursor*, 10> cursors{};  // by Cursor; null: the system's arrow

  Inside() = default;
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
  ~Inside() {
    for (GLFWcursor* made : cursors) {
      glfwDestroyCursor(made);
    }
    glfwDestroyWindow(window);
    glfwTerminate();
  }
};

namespace {

std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "unknown reason";
}

void wish_for_context() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS,
                 GLFW_LOSE_CONTEXT_ON_RESET);  // passed over where there is no such thing
  glfwWindowHint(GLFW_SAMPLES, 0);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
}

// Null where the driver cannot say. Mesa gives an address for any name, so the extension is asked for first.
template <class Function>
Function reset_status_function() {
  for (const auto& [extension, name] : {std::pair{"GL_KHR_robustness", "glGetGraphicsResetStatusKHR"},
                                        std::pair{"GL_ARB_robustness", "glGetGraphicsResetStatusARB"}}) {
    if (glfwExtensionSupported(extension) == GLFW_TRUE)
      return reinterpret_cast<Function>(glfwGetProcAddress(name));
  }
  return nullptr;
}

// GLFW 3.3 names no diagonal cursors.
void make_cursors(std::array<GLFWcursor*, 10>& cursors) {
  const auto make = [&](Cursor cursor, int shape) {
    cursors[static_cast<std::size_t>(cursor)] = glfwCreateStandardCursor(shape);
  };
  make(Cursor::Text, GLFW_IBEAM_CURSOR);
  make(Cursor::UpDown, GLFW_VRESIZE_CURSOR);
  make(Cursor::LeftRight, GLFW_HRESIZE_CURSOR);
  make(Cursor::Hand, GLFW_HAND_CURSOR);
#ifdef GLFW_RESIZE_ALL_CURSOR
  make(Cursor::Move, GLFW_RESIZE_ALL_CURSOR);
  make(Cursor::UpRight, GLFW_RESIZE_NESW_CURSOR);
  make(Cursor::DownRight, GLFW_RESIZE_NWSE_CURSOR);
  make(Cursor::No, GLFW_NOT_ALLOWED_CURSOR);
#endif
  glfwGetError(nullptr);  // a theme may lack a shape: then the arrow serves
}

// A window larger than the screen would hide panels beyond its edges, and without a frame nobody could pull it smaller.
void fit_to_screen(GLFWwindow* window) {
  GLFWmonitor* screen = glfwGetPrimaryMonitor();
  if (screen == nullptr) return;
  int x = 0;
  int y = 0;
  Window::Size room;
  Window::Size size;
  glfwGetMonitorWorkarea(screen, &x, &y, &room.width, &room.height);
  glfwGetWindowSize(window, &size.width, &size.height);
  if (room.width <= 0 || room.height <= 0) return;
  if (size.width > room.width || size.height > room.height)
    glfwSetWindowSize(window, std::min(size.width, room.width), std::min(size.height, room.height));
}

template <class Inside>
Inside& inside_of(GLFWwindow* window) {
  return *static_cast<Inside*>(glfwGetWindowUserPointer(window));
}

template <class Inside>
void listen_to_hands(GLFWwindow* window) {
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    inside_of<Inside>(w).input.push(MouseMove{static_cast<float>(x), static_cast<float>(y)});
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    if (entered == GLFW_FALSE) {
      inside_of<Inside>(w).input.push(MouseLeave{});
    }
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int /*mods*/) {
    inside_of<Inside>(w).input.push(MouseClick{button_from_glfw(button), action == GLFW_PRESS});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double dx, double dy) {
    inside_of<Inside>(w).input.push(Wheel{static_cast<float>(dx), static_cast<float>(dy)});
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int glfw_key, int scancode, int action, int mods) {
    if (action != GLFW_REPEAT) {  // who wants repetition asks how long a key has been down
      const Key key = key_from_glfw(glfw_key, scancode);
      const bool down = action == GLFW_PRESS;
      inside_of<Inside>(w).input.push(KeyPress{key, down, mods_after(mods_from_glfw(mods), key, down)});
    }
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned int codepoint) {
    inside_of<Inside>(w).input.push(Text{static_cast<char32_t>(codepoint)});
  });
}

template <class Inside>
void listen_to_system(GLFWwindow* window) {
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int gained) {
    inside_of<Inside>(w).input.push(Focus{gained != GLFW_FALSE});
  });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    auto& dropped = inside_of<Inside>(w).dropped;
    dropped.insert(dropped.end(), paths, paths + count);
  });
  const auto refresh = [](GLFWwindow* w, int, int) { inside_of<Inside>(w).refresh = true; };
  glfwSetFramebufferSizeCallback(window, refresh);
  glfwSetWindowSizeCallback(window, refresh);
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { inside_of<Inside>(w).refresh = true; });
  glfwSetWindowContentScaleCallback(window,
                                    [](GLFWwindow* w, float, float) { inside_of<Inside>(w).refresh = true; });
}

}  // namespace

std::variant<Window, std::string> Window::open(const std::string& title, int width, int height) {
  if (glfwInit() == GLFW_FALSE) {
    return "No window can be opened: " + last_error() + ". Run with --headless where there is no display.";
  }
  auto inside = std::make_unique<Inside>();  // from here on it ends GLFW
  wish_for_context();
  inside->window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (inside->window == nullptr) {
    return "No window with OpenGL 3.3 can be opened: " + last_error() +
           ". Update the graphics driver, or run with --headless.";
  }
  fit_to_screen(inside->window);
  glfwMakeContextCurrent(inside->window);
  if (gladLoadGL(glfwGetProcAddress) < GLAD_MAKE_VERSION(3, 3)) {
    return "The window's OpenGL is older than 3.3. Update the graphics driver, or run with --headless.";
  }
  inside->reset_status = reset_status_function<Inside::ResetStatus>();
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(inside->window, inside.get());
  listen_to_hands<Inside>(inside->window);
  listen_to_system<Inside>(inside->window);
  make_cursors(inside->cursors);
  return Window(std::move(inside));
}

Window::Window(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;

void Window::poll() { glfwPollEvents(); }
void Window::wait(double seconds) { glfwWaitEventsTimeout(std::max(seconds, 0.001)); }
void Window::swap() { glfwSwapBuffers(inside_->window); }
bool Window::lost() const {
  return inside_->reset_status != nullptr && inside_->reset_status() != GL_NO_ERROR;
}

InputQueue& Window::input() { return inside_->input; }
std::vector<std::string> Window::take_dropped() { return std::exchange(inside_->dropped, {}); }
bool Window::take_refresh() { return std::exchange(inside_->refresh, false); }
bool Window::close_requested() const { return glfwWindowShouldClose(inside_->window) != GLFW_FALSE; }
bool Window::minimised() const { return glfwGetWindowAttrib(inside_->window, GLFW_ICONIFIED) != GLFW_FALSE; }

Window::Size Window::size() const {
  Size size;
  glfwGetWindowSize(inside_->window, &size.width, &size.height);
  return size;
}

Window::Size Window::framebuffer_size() const {
  Size size;
  glfwGetFramebufferSize(inside_->window, &size.width, &size.height);
  return size;
}

float Window::pixel_scale() const {
  float x = 1.0f;
  float y = 1.0f;
  glfwGetWindowContentScale(inside_->window, &x, &y);
  return std::clamp(std::max(x, y), 0.5f, 8.0f);
}

float Window::unit_scale() const {
  const int units = size().width;
  const int pixels = framebuffer_size().width;
  const bool known = units > 0 && pixels > 0;
  return known ? pixel_scale() * static_cast<float>(units) / static_cast<float>(pixels) : pixel_scale();
}

void Window::set_title(const std::string& title) {
  if (title == inside_->title) return;
  inside_->title = title;
  glfwSetWindowTitle(inside_->window, title.c_str());
}

void Window::set_cursor(Cursor cursor) {
  if (cursor == inside_->cursor) {
    return;
  }
  inside_->cursor = cursor;
  const bool hidden = cursor == Cursor::Hidden;
  glfwSetInputMode(inside_->window, GLFW_CURSOR, hidden ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
  glfwSetCursor(inside_->window, inside_->cursors[static_cast<std::size_t>(cursor)]);
}

std::string Window::clipboard() const {
  const char* text = glfwGetClipboardString(inside_->window);
  return text != nullptr ? text : "";
}

void Window::set_clipboard(const std::string& text) { glfwSetClipboardString(inside_->window, text.c_str()); }

}  // namespace app
