// The one window: GLFW, with an OpenGL 3.3 core context that is current (in a page: a canvas with WebGL 2). It collects what
// hands and keyboard do and decides nothing. Drawing goes to a Target, so the window itself has neither depth nor samples.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "app/actions/input_queue.h"

namespace app {

class Window {
 public:
  // Or a sentence that says why there is none and what to do. Width and height are in window units; a screen
  // of high density gets a window of the same apparent size. No larger than the screen has room for.
  static std::variant<Window, std::string> open(const std::string& title, int width, int height);

  Window(Window&&) noexcept;
  Window& operator=(Window&&) noexcept;
  ~Window();

  // Collects what happened since; wait() sleeps until something does or the time is over.
  void poll();
  void wait(double seconds);
  // Shows what was drawn (see Target::present), in step with the screen.
  void swap();
  // The driver has lost what was given to it (a reset, a card taken out): nothing drawn is seen any more, and only a
  // new window helps.
  bool lost() const;

  InputQueue& input();
  // Paths of files dropped on the window since the last call.
  std::vector<std::string> take_dropped();
  // True once after the picture must be drawn anew: size, density, or uncovered.
  bool take_refresh();
  bool close_requested() const;
  bool minimised() const;

  struct Size {
    int width = 0, height = 0;
  };
  Size size() const;              // window units
  Size framebuffer_size() const;  // pixels; 0 x 0 while minimised on some systems
  // Pixels of this screen for one pixel of a plain one: line widths in the picture.
  float pixel_scale() const;
  // Window units for one unit of a plain screen: font and panel sizes. 2 on a dense X11 screen, 1 on macOS,
  // where window units are large themselves.
  float unit_scale() const;

  void set_title(const std::string& title);  // a line of UTF-8
  void set_cursor(Cursor cursor);
  std::string clipboard() const;
  void set_clipboard(const std::string& text);

 private:
  friend struct PageEvents;  // in a page
  struct Inside;
  explicit Window(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

}  // namespace app
