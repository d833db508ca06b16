// Where each panel stands: computed from the window's size and the scale alone. Panels never overlap.
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

struct Layout {
  float scale = 1.0f;  // window units for one unit of a plain screen: Window::unit_scale()
  Box window;
  Box menu;
  Box parameters;   // left
  Box view;         // centre: left empty for the scene
  Box explanation;  // right
  Box timeline;     // bottom

  [[nodiscard]] double view_aspect() const;  // for SetAspect
};

// Made for 1280 x 720 times `scale` and up; a smaller window shrinks the panels, and the view is never empty.
Layout layout_of(float width, float height, float scale);

// `pixels_per_x`, `pixels_per_y`: framebuffer pixels in one window unit.
PixelBox pixels_of(const Box& box, const Box& window, float pixels_per_x, float pixels_per_y);

}  // namespace app
