// Where each panel stands: computed from the window's size, the scale and what a person wishes. Panels never
// overlap.
#pragma once

namespace app {

// Window units, from the top left corner.
struct Box {
  float x = 0.0f, y = 0.0f, width = 0.0f, height = 0.0f;
  [[nodiscard]] float right() const { return x + width; }
  [[nodiscard]] float bottom() const { return y + height; }
  friend bool operator==(const Box&, const Box&) = default;
};

// Framebuffer pixels, from the lower left corner as OpenGL counts.
struct PixelBox {
  int x = 0, y = 0, width = 0, height = 0;
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

// Plain units. A window that is not so wide, a telephone's say, begins with its sides closed.
inline constexpr float narrow_window = 640.0f;

// What a person has made of it, in plain units; 0: as there is room.
struct LayoutWish {
  bool parameters = true, explanation = true, timeline = true;  // shown
  float left = 0.0f, right = 0.0f, bottom = 0.0f;               // dragged to
  float lesson = 0.0f;                                          // height of the strip below the view; 0: none
  float guess = 0.0f;                                           // of the card that asks for a guess; 0: none
  // The view, a large caption below it and a thin timeline, nothing else; a lesson stands beside them.
  bool presenting = false;
  bool both = false;      // the view in two halves
  bool checking = false;  // a written pattern, and the view of its shape
  bool menus = true;      // the line above all
};

struct Layout {
  float scale = 1.0f;  // window units for one unit of a plain screen: Window::unit_scale()
  Box window;
  Box menu;
  Box parameters;   // left
  Box view;         // centre: left empty for the scene
  Box explanation;  // right
  Box timeline;     // bottom
  Box guess;        // below the view, while a verdict is guessed; else empty
  Box lesson;       // below that, while a lesson goes on; else empty
  Box caption;      // below the view, while presenting; else empty
  Box other_view;   // left of the view, for the pinned run; else empty
  Box checker;      // left of the view, while a written pattern is checked; else empty

  [[nodiscard]] double view_aspect() const;  // for SetAspect
};

// Made for 1280 x 720 times `scale` and up; a smaller window shrinks the panels. The view always keeps a third of
// the window's width and of its height, whatever is wished. What is not shown is empty, and its room the view's.
Layout layout_of(float width, float height, float scale, const LayoutWish& wish = {});

// The scale at which a presentation's words can be read from the back of a room: at least `scale`.
inline constexpr float largest_presenting_scale = 4.0f;  // letters have to fit on the card
float presenting_scale(float width, float height, float scale);

// How far a panel can be dragged while the others stay as they are, in plain units.
struct DragRange {
  float low = 0.0f, high = 0.0f;
};
DragRange range_of_left(const Layout& layout);
DragRange range_of_right(const Layout& layout);
DragRange range_of_bottom(const Layout& layout);

// `pixels_per_x`, `pixels_per_y`: framebuffer pixels in one window unit.
PixelBox pixels_of(const Box& box, const Box& window, float pixels_per_x, float pixels_per_y);

}  // namespace app
